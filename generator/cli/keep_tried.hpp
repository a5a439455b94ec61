#pragma once

#include <optional>

#include "cli/generate_from_files.hpp"

namespace treeline {

/// Tries every function that was made, see `retry_routes`. Those beyond their bounds by every
/// algorithm, for which `check` would fail too, are named in `diagnostics` with the state, and what
/// is returned was made again without them; `failed` says whether there were any. Nothing when none
/// is left.
std::optional<GeneratedInputs> keep_tried(const InputOptions& options, GeneratedInputs made,
                                          bool& failed, Diagnostics& diagnostics);

}  // namespace treeline
