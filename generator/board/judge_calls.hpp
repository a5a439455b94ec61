#pragma once

#include <vector>

#include "board/board_report.hpp"
#include "board/run_board.hpp"
#include "oracle/reference.hpp"

namespace treeline {

/// Compares the calls of function `i` with the references and notes the verdict and the counted
/// instructions. With `contracted` errors are compared with the bound of `check`, else bits.
/// `function.cycles`, the mean of one instruction, becomes that of the longest call.
void judge_calls(std::size_t i, const GeneratedFunction& generated, const BoardCalls& calls,
                 const std::vector<StateReference>& references, Real real, bool contracted,
                 BoardFunction& function);

}  // namespace treeline
