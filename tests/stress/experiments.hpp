#pragma once

#include <functional>
#include <string>
#include <vector>

#include "finding.hpp"

namespace treeline::stress {

/// `quick`: fewer samples and shorter runs, for the suite. `robots`: the folder of the robots.
struct Effort {
  bool quick = false;
  std::string robots;
};

struct Experiment {
  std::string name;
  std::function<Finding(const Effort&)> run;
};

/// Configurations, inertias, sizes, speeds: what every algorithm makes of them.
std::vector<Experiment> sweep_experiments();
/// Chang table 5.1's big base, table 8.1's subtraction, redundant tasks.
std::vector<Experiment> table_experiments();
/// Long motions: energy and momentum.
std::vector<Experiment> motion_experiments();

}  // namespace treeline::stress
