#pragma once

#include "trial/retry_routes.hpp"

namespace treeline {

/// Chooses once more without the functions that failed, for which `check` would fail too, and with
/// nothing that needs them. Each is named in `diagnostics` with its state. `files` are those for
/// `treeline check`, as a command line names them. No function may be left.
TriedFunctions leave_out_failed(const Robot& robot, TriedFunctions tried, const std::string& files,
                                Diagnostics& diagnostics);

}  // namespace treeline
