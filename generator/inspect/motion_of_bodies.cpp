#include "inspect/motion_of_bodies.hpp"

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <cmath>

#include "bounds/rng.hpp"

namespace treeline {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr std::uint64_t kMotionSeed = 1;
// Singular values below this are rounding errors, or motions due to the errors of a file's angles.
constexpr double kRankTolerance = 1e-9;

/// Position and motion of a link, in world axes.
struct LinkMotion {
  Matrix3d R = Matrix3d::Identity();
  Vector3d p = Vector3d::Zero(), v = Vector3d::Zero(), w = Vector3d::Zero();
};

/// Draws motions of the tree with random coordinates. Joints that share a coordinate have the same
/// value.
class MovingTree {
 public:
  MovingTree(const Mechanism& mechanism, Rng& rng) : mechanism_(mechanism) {
    q_.resize(mechanism.coordinates.size());
    qd_.resize(mechanism.velocities.size());
    for (double& q : q_) q = rng.within(1.5);
    for (double& qd : qd_) qd = rng.within(1);
  }

  [[nodiscard]] std::vector<LinkMotion> motions() const {
    std::vector<LinkMotion> all;
    for (const MovingLink& link : mechanism_.links) {
      const LinkMotion parent =
          link.parent < 0 ? LinkMotion{} : all[static_cast<std::size_t>(link.parent)];
      all.push_back(moved(link, parent));
    }
    return all;
  }

 private:
  [[nodiscard]] LinkMotion moved(const MovingLink& link, const LinkMotion& parent) const {
    const Matrix3d placement_R = link.placement.R.cast<double>();
    const Vector3d offset = parent.R * link.placement.p.cast<double>();
    LinkMotion motion;
    motion.R = parent.R * placement_R;
    motion.p = parent.p + offset;
    motion.w = parent.w;
    motion.v = parent.v + parent.w.cross(offset);
    const auto q = static_cast<std::size_t>(link.q_index),
               v = static_cast<std::size_t>(link.v_index);
    if (link.is_floating()) {
      move_freely(q, v, motion);
      return motion;
    }
    if (link.is_of_ball()) {
      // The first step turns, in its own axes: y z x of the joint's.
      if (!link.continues_joint()) {
        motion.R = motion.R * quaternion(q_[q + 1], q_[q + 2], q_[q], q_[q + 3]);
      }
      motion.w += motion.R.col(2) * qd_[v];
      return motion;
    }
    const double at = link.multiplier * q_[q] + static_cast<double>(link.offset);
    const double rate = link.multiplier * qd_[v];
    const Vector3d axis = motion.R.col(2);
    if (link.kind == JointKind::prismatic) {
      motion.p += axis * at;
      motion.v += motion.w.cross(axis * at) + axis * rate;
    } else {
      motion.R = motion.R * Eigen::AngleAxisd(at, Vector3d::UnitZ()).toRotationMatrix();
      motion.w += axis * rate;
    }
    return motion;
  }

  /// Rotation matrix of a quaternion that is far from 0.
  static Matrix3d quaternion(double x, double y, double z, double w) {
    return Eigen::Quaterniond(2 + w, x, y, z).normalized().toRotationMatrix();
  }

  void move_freely(std::size_t q, std::size_t v, LinkMotion& motion) const {
    const Vector3d shift = motion.R * Vector3d(q_[q], q_[q + 1], q_[q + 2]);
    motion.p += shift;
    motion.R = motion.R * quaternion(q_[q + 3], q_[q + 4], q_[q + 5], q_[q + 6]);
    motion.v += motion.w.cross(shift) + motion.R * Vector3d(qd_[v], qd_[v + 1], qd_[v + 2]);
    motion.w += motion.R * Vector3d(qd_[v + 3], qd_[v + 4], qd_[v + 5]);
  }

  const Mechanism& mechanism_;
  std::vector<double> q_, qd_;
};

using Numbers = Eigen::Matrix<double, kInertialNumbers, 1>;

/// Kinetic energy as a linear function of the ten numbers: m v^2 / 2 + h (v x w) + (tr(Sigma) w^2 -
/// w^T Sigma w) / 2.
Numbers kinetic_row(const LinkMotion& link, const BodyFrame& frame) {
  const Vector3d w = link.R.transpose() * link.w;
  const Vector3d v = link.R.transpose() * link.v + w.cross(frame.centre);
  Numbers row;
  const Vector3d h = v.cross(w) / std::sqrt(2.0);
  const double w2 = w.squaredNorm(), product = -1 / std::sqrt(2.0);
  row << v.squaredNorm() / 2, h * frame.length,
      Vector3d(w2 - w.x() * w.x(), w2 - w.y() * w.y(), w2 - w.z() * w.z()) * frame.length *
          frame.length / 2,
      Vector3d(w.x() * w.y(), w.x() * w.z(), w.y() * w.z()) * product * frame.length * frame.length;
  return row * frame.mass;
}

/// Potential energy, up to a constant, as a linear function of the ten numbers.
Numbers potential_row(const LinkMotion& link, const BodyFrame& frame, const Vector3d& gravity) {
  Numbers row = Numbers::Zero();
  row[0] = -gravity.dot(link.p + link.R * frame.centre);
  row.segment<3>(1) = -(link.R.transpose() * gravity) * frame.length / std::sqrt(2.0);
  return row * frame.mass;
}

}  // namespace

Eigen::MatrixXd find_felt_directions(const Mechanism& mechanism,
                                     const std::vector<BodyFrame>& frames) {
  const auto links = static_cast<Eigen::Index>(mechanism.links.size());
  const Eigen::Index numbers = kInertialNumbers * links;
  const Eigen::Index states = numbers + 8;
  const Vector3d gravity = Eigen::Map<const Vector3d>(mechanism.gravity.data());
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(numbers, 2 * states);  // transposed
  Eigen::VectorXd first_potential;
  Rng rng(kMotionSeed);
  for (Eigen::Index k = 0; k < states; ++k) {
    const auto motions = MovingTree(mechanism, rng).motions();
    for (Eigen::Index i = 0; i < links; ++i) {
      const auto at = static_cast<std::size_t>(i);
      const Eigen::Index first = kInertialNumbers * i;
      rows.block<kInertialNumbers, 1>(first, 2 * k) = kinetic_row(motions[at], frames[at]);
      rows.block<kInertialNumbers, 1>(first, 2 * k + 1) =
          potential_row(motions[at], frames[at], gravity);
    }
    if (k == 0) first_potential = rows.col(1);
    rows.col(2 * k + 1) -= first_potential;
  }
  for (Eigen::Index k = 0; k < rows.cols(); ++k) {
    const double norm = rows.col(k).norm();
    if (norm > 0) rows.col(k) /= norm;
  }
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factor(rows);
  factor.setThreshold(kRankTolerance);
  const Eigen::Index rank = factor.rank();
  return factor.householderQ() * Eigen::MatrixXd::Identity(numbers, rank);
}

}  // namespace treeline
