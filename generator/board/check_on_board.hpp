#pragma once

#include <optional>
#include <vector>

#include "board/board_report.hpp"
#include "board/run_board.hpp"
#include "check/check.hpp"
#include "oracle/reference.hpp"

namespace treeline {

/// Compiles the generated code, or `options.folder`, for the scene's target, runs it at many states
/// on a board that QEMU imitates, or on that of `board`, and compares it with the host: to the bit,
/// or within the bounds of `check` if the flags let the compiler fuse products and sums. Returns
/// nothing if a program is missing or fails; `diagnostics` says which. A report that has not passed
/// is no diagnostic.
std::optional<BoardReport> check_on_board(const Robot& robot, const Scene& scene,
                                          const Generation& generation, const CheckOptions& options,
                                          const BoardOptions& board, Diagnostics& diagnostics);

/// Compares the calls of function `i` with the references and notes the verdict and the counted
/// instructions. With `contracted` errors are compared with the bound of `check`, else bits.
/// `function.cycles`, the mean of one instruction, becomes that of the longest call.
void judge_calls(std::size_t i, const GeneratedFunction& generated, const BoardCalls& calls,
                 const std::vector<StateReference>& references, Real real, bool contracted,
                 BoardFunction& function);

}  // namespace treeline
