#pragma once

#include <vector>

#include "check/report.hpp"

namespace treeline {

/// Reports of each function of the generation how far its equation is from holding at the first of
/// these states, which are of every class: the results in 50 digits, with which the code is
/// compared, against derivatives of lower functions along motions. `report` has the functions.
void judge_equations(const Robot& robot, const Scene& scene, const Generation& generation,
                     const std::vector<StateReference>& references, int threads,
                     CheckReport& report);

}  // namespace treeline
