#pragma once

#include <vector>

#include "cli/generate_from_files.hpp"
#include "oracle/try_functions.hpp"

namespace treeline {

/// Tries every function that was made, see `try_functions`, and makes those beyond their bounds
/// again by the next cheapest algorithm, until they are within or none is left; a note in
/// `diagnostics` names both. Algorithms that lose digits do so on few robots: with inertias of very
/// different size, say. Those that the command line chose stay. Where functions fail by every
/// algorithm and `noise` is the default, all are made again from numbers as they are written.
/// Returns the functions that fail then too.
std::vector<FailedTrial> retry_routes(const InputOptions& options, GeneratedInputs& made,
                                      Diagnostics& diagnostics);

}  // namespace treeline
