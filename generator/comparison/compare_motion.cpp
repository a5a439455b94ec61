#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "comparison/difference.hpp"
#include "comparison/paired_models.hpp"

namespace treeline {
namespace {

using interpreter::Matrix;
using interpreter::Points;
using interpreter::Vector;
using Poses = std::vector<interpreter::PointPose<double>>;

constexpr std::uint64_t kSeed = 1;
constexpr int kStates = 64;

/// Points at the frames of these links.
Points<double> frames(const interpreter::Model<double>& model,
                      const std::vector<std::string>& links) {
  Points<double> points;
  for (const std::string& link : links) {
    interpreter::OperationalPoint<double> point;
    point.body = body_named(model, link);
    points.push_back(point);
  }
  return points;
}

/// Index among the differences of the link that is nearest to the first robot's root and exists in
/// both robots.
std::size_t find_reference(const interpreter::Model<double>& model,
                           const RobotDifference& difference) {
  const auto body_of = [&](const LinkDifference& link) { return body_named(model, link.first); };
  const auto nearest = std::min_element(
      difference.links.begin(), difference.links.end(),
      [&](const LinkDifference& a, const LinkDifference& b) { return body_of(a) < body_of(b); });
  return static_cast<std::size_t>(nearest - difference.links.begin());
}

void compare_poses(const Poses& first, const Poses& second, std::size_t reference,
                   RobotDifference& difference) {
  const auto& base_a = first[reference];
  const auto& base_b = second[reference];
  for (std::size_t i = 0; i < first.size(); ++i) {
    const Eigen::Vector3d p_a = base_a.rotation.transpose() * (first[i].position - base_a.position);
    const Eigen::Vector3d p_b =
        base_b.rotation.transpose() * (second[i].position - base_b.position);
    const Eigen::Matrix3d R_a = base_a.rotation.transpose() * first[i].rotation;
    const Eigen::Matrix3d R_b = base_b.rotation.transpose() * second[i].rotation;
    LinkDifference& link = difference.links[i];
    link.position = std::max(link.position, (p_a - p_b).norm());
    // R_a - R_b| = 2 sqrt(2) sin(angle / 2), which is well conditioned for small angles.
    const double sine = std::min(1.0, (R_a - R_b).norm() / std::sqrt(8.0));
    link.rotation = std::max(link.rotation, 2 * std::asin(sine));
  }
}

/// Collects the deviations of a vector over all states. The vector has an entry for each shared
/// velocity.
class DeviationOverStates {
 public:
  explicit DeviationOverStates(const std::vector<SharedVelocity>& velocities)
      : velocities_(velocities) {}

  /// Adds the vectors of both robots at one state. `scale` is sqrt(M_ii) of each shared velocity,
  /// or 0 if it moves nothing.
  void add(const Vector<double>& a, const Vector<double>& b, const Vector<double>& scale) {
    double change = 0, size_a = 0, size_b = 0;
    for (Eigen::Index i = 0; i < a.size(); ++i) {
      note(a[i] - b[i], static_cast<std::size_t>(i));
      if (!(scale[i] > 0)) continue;
      change += std::pow((a[i] - b[i]) / scale[i], 2);
      size_a += std::pow(a[i] / scale[i], 2);
      size_b += std::pow(b[i] / scale[i], 2);
    }
    largest_change_ = std::max(largest_change_, std::sqrt(change));
    largest_ = std::max({largest_, std::sqrt(size_a), std::sqrt(size_b)});
  }

  [[nodiscard]] Deviation result() const {
    Deviation result = worst_;
    result.relative = largest_ > 0 ? largest_change_ / largest_ : 0;
    return result;
  }

 private:
  void note(double change, std::size_t i) {
    if (std::abs(change) <= worst_.absolute) return;
    worst_.absolute = std::abs(change);
    worst_.joint = velocities_[i].joint;
    worst_.unit = velocities_[i].turns ? "N m" : "N";
  }

  const std::vector<SharedVelocity>& velocities_;
  Deviation worst_;
  double largest_change_ = 0, largest_ = 0;
};

/// Selects the entries of the shared velocities from a vector or matrix of either model.
class Selection {
 public:
  explicit Selection(const std::vector<SharedVelocity>& velocities) : velocities_(velocities) {}

  [[nodiscard]] Vector<double> first(const Vector<double>& all) const {
    return select(all, &SharedVelocity::first);
  }
  [[nodiscard]] Vector<double> second(const Vector<double>& all) const {
    return select(all, &SharedVelocity::second);
  }
  [[nodiscard]] Matrix<double> first(const Matrix<double>& all) const {
    return select(all, &SharedVelocity::first);
  }
  [[nodiscard]] Matrix<double> second(const Matrix<double>& all) const {
    return select(all, &SharedVelocity::second);
  }

 private:
  [[nodiscard]] Vector<double> select(const Vector<double>& all, int SharedVelocity::*entry) const {
    Vector<double> selected(static_cast<Eigen::Index>(velocities_.size()));
    for (std::size_t i = 0; i < velocities_.size(); ++i) {
      selected[static_cast<Eigen::Index>(i)] = all[velocities_[i].*entry];
    }
    return selected;
  }
  [[nodiscard]] Matrix<double> select(const Matrix<double>& all, int SharedVelocity::*entry) const {
    const auto n = static_cast<Eigen::Index>(velocities_.size());
    Matrix<double> selected(n, n);
    for (Eigen::Index i = 0; i < n; ++i) {
      for (Eigen::Index j = 0; j < n; ++j) {
        selected(i, j) = all(velocities_[static_cast<std::size_t>(i)].*entry,
                             velocities_[static_cast<std::size_t>(j)].*entry);
      }
    }
    return selected;
  }

  const std::vector<SharedVelocity>& velocities_;
};

/// Compares the mass matrices at one state. Returns sqrt(M_ii), the larger of both, for each shared
/// velocity.
Vector<double> compare_mass_matrices(const Matrix<double>& a, const Matrix<double>& b,
                                     const std::vector<SharedVelocity>& velocities,
                                     DynamicsDifference& difference) {
  const Vector<double> scale = a.diagonal().cwiseMax(b.diagonal()).cwiseMax(0.0).cwiseSqrt();
  for (Eigen::Index i = 0; i < a.rows(); ++i) {
    for (Eigen::Index j = 0; j <= i; ++j) {
      const double size = scale[i] * scale[j];
      const double change = size > 0 ? std::abs(a(i, j) - b(i, j)) / size : 0;
      if (!(change > difference.mass_matrix)) continue;
      difference.mass_matrix = change;
      difference.row = velocities[static_cast<std::size_t>(i)].joint;
      difference.column = velocities[static_cast<std::size_t>(j)].joint;
    }
  }
  return scale;
}

void compare_dynamics(const PairedModels& models, DynamicsDifference& difference) {
  const auto& velocities = models.velocities();
  difference.coordinates = static_cast<int>(velocities.size());
  if (velocities.empty()) return;
  const Selection select(velocities);
  DeviationOverStates gravity(velocities), forces(velocities);
  Rng rng(kSeed);
  for (int k = 0; k < kStates; ++k) {
    const PairedState q = models.draw_position(rng);
    const PairedState qd = models.draw_velocity(rng), qdd = models.draw_velocity(rng);
    const Vector<double> scale = compare_mass_matrices(
        select.first(interpreter::mass_matrix<double>(models.first(), q.first)),
        select.second(interpreter::mass_matrix<double>(models.second(), q.second)), velocities,
        difference);
    gravity.add(select.first(interpreter::gravity<double>(models.first(), q.first)),
                select.second(interpreter::gravity<double>(models.second(), q.second)), scale);
    forces.add(select.first(interpreter::inverse_dynamics<double>(models.first(), q.first, qd.first,
                                                                  qdd.first)),
               select.second(interpreter::inverse_dynamics<double>(models.second(), q.second,
                                                                   qd.second, qdd.second)),
               scale);
  }
  difference.gravity = gravity.result();
  difference.inverse_dynamics = forces.result();
}

}  // namespace

void compare_motion(const Robot& first, const Robot& second, const RobotMatch& match,
                    RobotDifference& difference) {
  difference.states = kStates;
  const PairedModels models(first, second, match, difference.base);
  compare_dynamics(models, difference.dynamics);
  if (difference.links.empty()) return;
  std::vector<std::string> links_a, links_b;
  for (const LinkDifference& link : difference.links) {
    links_a.push_back(link.first);
    links_b.push_back(link.second);
  }
  const Points<double> frames_a = frames(models.first(), links_a);
  const Points<double> frames_b = frames(models.second(), links_b);
  const std::size_t reference = find_reference(models.first(), difference);
  difference.reference = difference.links[reference].first;
  Rng rng(kSeed);
  for (int k = 0; k < kStates; ++k) {
    const PairedState q = models.draw_position(rng);
    compare_poses(interpreter::forward_kinematics<double>(models.first(), frames_a, q.first),
                  interpreter::forward_kinematics<double>(models.second(), frames_b, q.second),
                  reference, difference);
  }
}

}  // namespace treeline
