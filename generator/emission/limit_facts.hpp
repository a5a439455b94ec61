#pragma once

#include <string>
#include <vector>

namespace treeline {

/// Facts about the robot in NAME_limited.hpp, see `core::limit_torque`.
struct LimitFacts {
  /// A row of a cone: coefficients of forces of held rows, from `first` on, at most `bound`.
  struct Row {
    int first = 0;
    std::vector<double> coefficients;
    double bound = 0;
  };
  std::vector<int> passive;           ///< velocities without a motor
  std::vector<double> force_weights;  ///< of held rows: 1, or the lever of a moment, m
  std::vector<double> torque;         ///< by velocity, infinite: no limit
  std::vector<Row> cones;
  std::vector<double> task_weights;  ///< by row of the task
  /// By held row and by row of the task, which share it has; -1: none. Both empty where none has.
  std::vector<int> held_shares, task_shares;
  int freedoms = 0;                ///< of torques and internal forces, in ordinary states
  std::vector<std::string> notes;  ///< lines that describe the cones

  [[nodiscard]] bool has_shares() const { return !held_shares.empty() || !task_shares.empty(); }
};

}  // namespace treeline
