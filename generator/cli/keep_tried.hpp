#pragma once

#include <optional>

#include "cli/generate_from_files.hpp"

namespace treeline {

/// Tries every function that was made, see `try_functions`. Those that are wrong, by many times
/// their bounds, are named in `diagnostics` with the state, and what is returned was made again
/// without them; `failed` says whether there were any. Those that only round worse than expected
/// are kept, with a warning. Nothing when none is left.
std::optional<GeneratedInputs> keep_tried(const InputOptions& options, GeneratedInputs made,
                                          bool& failed, Diagnostics& diagnostics);

}  // namespace treeline
