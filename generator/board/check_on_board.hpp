#pragma once

#include <optional>

#include "board/board_options.hpp"
#include "board/board_report.hpp"
#include "check/check.hpp"

namespace treeline {

/// Compiles the generated code, or `options.folder`, for the scene's target, runs it at many states
/// on a board that QEMU imitates, or on that of `board`, and compares it with the host: to the bit,
/// or within the bounds of `check` if the flags let the compiler fuse products and sums. Returns
/// nothing if a program is missing or fails; `diagnostics` says which. A report that has not passed
/// is no diagnostic.
std::optional<BoardReport> check_on_board(const Robot& robot, const Scene& scene,
                                          const Generation& generation, const CheckOptions& options,
                                          const BoardOptions& board, Diagnostics& diagnostics);

}  // namespace treeline
