#include <algorithm>
#include <cmath>
#include <limits>

#include "description/inertias.hpp"
#include "inspect/inspect_robot.hpp"
#include "inspect/motion_of_bodies.hpp"
#include "mechanism/build_mechanism.hpp"
#include "oracle/symmetric_matrices.hpp"

namespace treeline {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix4d;
using Eigen::Vector3d;
using Eigen::VectorXd;

// Relative to a body's own size: rounding of figures in a file, see `find_unphysical`.
constexpr double kTolerance = 1e-4;
constexpr int kMostSteps = 2000;
constexpr int kPatience = 25;       ///< steps without progress
constexpr double kProgress = 1e-3;  ///< relative

Vector3d to_double(const Digits50Vector3& v) {
  return v.cast<double>();
}

double typical_length(const Mechanism& mechanism) {
  double length = 0;
  for (const MovingLink& link : mechanism.links) {
    length = std::max(length, to_double(link.placement.p).norm());
  }
  return length > 0 ? length : 1;
}

double typical_mass(const Mechanism& mechanism) {
  double mass = 0;
  for (const MovingLink& link : mechanism.links) {
    mass = std::max(mass, static_cast<double>(link.inertia.mass));
  }
  return mass > 0 ? mass : 1;
}

BodyFrame frame_of(const Inertia& inertia, double length, double mass) {
  BodyFrame frame{Vector3d::Zero(), mass, length};
  if (inertia.mass > 0) {
    frame.centre = to_double(Digits50Vector3(inertia.h / inertia.mass));
    frame.mass = static_cast<double>(inertia.mass);
  }
  const Inertia centred =
      transformed(inertia, {Digits50Matrix3::Identity(), -frame.centre.cast<Digits50>()});
  const double extent = centred.Sigma.cast<double>().norm() / frame.mass;
  if (extent > 0) frame.length = std::sqrt(extent);
  return frame;
}

VectorXd numbers_of(const Inertia& inertia, const BodyFrame& frame) {
  const Inertia centred =
      transformed(inertia, {Digits50Matrix3::Identity(), -frame.centre.cast<Digits50>()});
  const Vector3d h = to_double(centred.h) / (frame.mass * frame.length) * std::sqrt(2.0);
  const Matrix3d S = centred.Sigma.cast<double>() / (frame.mass * frame.length * frame.length);
  VectorXd numbers(kInertialNumbers);
  numbers << static_cast<double>(centred.mass) / frame.mass, h, S.diagonal(),
      Vector3d(S(0, 1), S(0, 2), S(1, 2)) * std::sqrt(2.0);
  return numbers;
}

VectorXd numbers_of(const Mechanism& mechanism, const std::vector<BodyFrame>& frames) {
  VectorXd all(kInertialNumbers * static_cast<Eigen::Index>(frames.size()));
  for (std::size_t i = 0; i < frames.size(); ++i) {
    all.segment<kInertialNumbers>(kInertialNumbers * static_cast<Eigen::Index>(i)) =
        numbers_of(mechanism.links[i].inertia, frames[i]);
  }
  return all;
}

/// Replaces the ten numbers by those of the nearest possible body. As a matrix they must be
/// positive semidefinite.
void make_possible(Eigen::Ref<VectorXd> numbers) {
  const double s = 1 / std::sqrt(2.0);
  Matrix4d P;
  P.topLeftCorner<3, 3>() << numbers[4], s * numbers[7], s * numbers[8],  //
      s * numbers[7], numbers[5], s * numbers[9],                         //
      s * numbers[8], s * numbers[9], numbers[6];
  P.topRightCorner<3, 1>() = s * numbers.segment<3>(1);
  P.bottomLeftCorner<1, 3>() = s * numbers.segment<3>(1).transpose();
  P(3, 3) = numbers[0];
  const SymmetricDecomposition eigen = decompose_symmetric(P);
  if (eigen.values[0] >= 0) return;
  P = eigen.vectors * eigen.values.cwiseMax(0).asDiagonal() * eigen.vectors.transpose();
  numbers << P(3, 3), P.topRightCorner<3, 1>() / s, P(0, 0), P(1, 1), P(2, 2), P(0, 1) / s,
      P(0, 2) / s, P(1, 2) / s;
}

/// Whether some possible bodies move like these. Uses alternating projections between possible
/// bodies and bodies with the same motion, which converge to a body that is both if there is one.
bool moves_like_possible_bodies(const Eigen::MatrixXd& felt, const VectorXd& numbers) {
  VectorXd bodies = numbers;
  double best = std::numeric_limits<double>::infinity();
  for (int step = 0, idle = 0; step < kMostSteps && idle < kPatience; ++step) {
    VectorXd possible = bodies;
    for (Eigen::Index i = 0; i < possible.size(); i += kInertialNumbers) {
      make_possible(possible.segment(i, kInertialNumbers));
    }
    double farthest = 0;
    for (Eigen::Index i = 0; i < possible.size(); i += kInertialNumbers) {
      farthest = std::max(farthest, (possible - bodies).segment(i, kInertialNumbers).norm());
    }
    if (farthest <= kTolerance) return true;
    idle = farthest < best * (1 - kProgress) ? 0 : idle + 1;
    best = std::min(best, farthest);
    bodies = possible - felt * (felt.transpose() * (possible - numbers));
  }
  return false;
}

Robot with_repaired(const Robot& robot, const std::vector<int>& faulty, int except) {
  Robot result = robot;
  for (const int link : faulty) {
    auto& inertial = result.links[static_cast<std::size_t>(link)].inertial;
    const auto nearest = nearest_possible_inertia(*inertial);
    if (link != except && nearest) inertial = nearest;
  }
  return result;
}

}  // namespace

std::vector<int> find_felt_faults(const Robot& robot, const Scene& scene,
                                  const std::vector<int>& faulty) {
  if (faulty.empty()) return {};
  const Mechanism as_written = build_mechanism(robot, scene);
  if (as_written.links.empty()) return {};
  std::vector<BodyFrame> frames;
  const double length = typical_length(as_written), mass = typical_mass(as_written);
  for (const MovingLink& link : as_written.links) {
    frames.push_back(frame_of(link.inertia, length, mass));
  }
  const Eigen::MatrixXd felt = find_felt_directions(as_written, frames);
  if (moves_like_possible_bodies(felt, numbers_of(as_written, frames))) return {};
  std::vector<int> found;
  for (const int link : faulty) {
    const Mechanism alone = build_mechanism(with_repaired(robot, faulty, link), scene);
    if (!moves_like_possible_bodies(felt, numbers_of(alone, frames))) found.push_back(link);
  }
  // Each fault alone can be absorbed, but not all together.
  return found.empty() ? faulty : found;
}

}  // namespace treeline
