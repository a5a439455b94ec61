#pragma once

#include <functional>
#include <string>
#include <vector>

#include "finding.hpp"

namespace treeline::stress {

/// Effort of the experiments. `quick`: fewer samples and shorter runs, for the test suite.
/// `robots`: the folder of the robots.
struct Effort {
  bool quick = false;
  std::string robots;
};

struct Experiment {
  std::string name;
  std::function<Finding(const Effort&)> run;
};

/// Effect of configurations, inertias, sizes and speeds on every algorithm.
std::vector<Experiment> sweep_experiments();
/// The big base of Chang table 5.1, the subtraction of table 8.1, redundant tasks.
std::vector<Experiment> table_experiments();
/// Long motions: energy and momentum.
std::vector<Experiment> motion_experiments();
/// Long motions of a closed loop.
std::vector<Experiment> loop_experiments();

}  // namespace treeline::stress
