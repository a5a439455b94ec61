#pragma once

#include <string>

#include "trial/retry_routes.hpp"

namespace treeline {

/// Takes away the functions that failed, for which `check` would fail too, and what needs them.
/// Each is named in `diagnostics` with its state. `files` are those for `treeline check`, as a
/// command line names them. No function may be left.
void leave_out_failed(TriedFunctions& tried, const std::string& files, Diagnostics& diagnostics);

}  // namespace treeline
