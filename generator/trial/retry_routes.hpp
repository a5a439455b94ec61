#pragma once

#include <string>
#include <vector>

#include "choice/choose_functions.hpp"
#include "trial/try_functions.hpp"

namespace treeline {

/// The functions of a scene after they were tried.
struct TriedFunctions {
  Scene scene;  ///< numbers are taken as written where the trial asked for that
  ChosenFunctions chosen;
  std::vector<FailedTrial> failed = {};  ///< beyond their bounds by every algorithm
};

/// Tries every function that was chosen, see `try_functions`, and chooses the next cheapest
/// algorithm for those beyond their bounds, until they are within or none is left; a note in
/// `diagnostics` names both. Algorithms that lose digits do so on few robots: with inertias of very
/// different size, say. Those that were chosen in advance stay. Where functions fail by every
/// algorithm and `noise` is the default, all are chosen again from numbers as they are written.
TriedFunctions retry_routes(const Robot& robot, const Scene& scene, ChosenFunctions chosen,
                            Diagnostics& diagnostics);

/// Takes away the functions that failed, for which `check` would fail too, and what needs them.
/// Each is named in `diagnostics` with its state. `files` are those for `treeline check`, as a
/// command line names them. No function may be left.
void leave_out_failed(TriedFunctions& tried, const std::string& files, Diagnostics& diagnostics);

}  // namespace treeline
