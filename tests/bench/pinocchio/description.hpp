#pragma once

#include <array>
#include <string>
#include <vector>

#include "subject.hpp"

namespace treeline::bench::pin {

/// A frame fixed to a link, all six of its rows controlled in the world's axes.
struct Point {
  std::string link;
  std::array<double, 9> R{};  ///< in the link's frame, row-major
  std::array<double, 3> p{};
};

/// What Pinocchio has to know of a robot. Nothing of Eigen here: this header is seen by code that
/// is compiled for another machine, where Eigen aligns otherwise.
struct Description {
  std::string urdf;                ///< path
  bool floating = false;           ///< the root link on a free joint
  std::vector<std::string> links;  ///< moved by each entry of qd
  std::array<double, 3> gravity{};
  std::vector<Point> points;
};

/// Recursive Newton-Euler, articulated bodies, M, M^-1, derivatives, and of J M^-1 J^T every route.
/// Nothing if Pinocchio cannot read the robot as it is described.
[[gnu::visibility("default")]] std::vector<Subject> pinocchio_subjects(
    const Description& description);

}  // namespace treeline::bench::pin
