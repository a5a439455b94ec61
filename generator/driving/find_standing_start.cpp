#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "description/group_bodies.hpp"
#include "description/robot_queries.hpp"
#include "drawing/place_links.hpp"
#include "driving/find_start.hpp"

namespace treeline {
namespace {

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// A foot: a frame of a link, and whether it must not tilt.
struct Foot {
  std::size_t link = 0;
  Isometry3d origin = Isometry3d::Identity();
  bool is_level = false;
};

/// How far a place is from one where the robot stands well. The base stays, and the feet move by a
/// common way, which is sought with the joints: x has the joints that move alone, then that way.
class Stance {
 public:
  Stance(const LaunchedRobot& robot, const std::vector<double>& start)
      : robot_(robot), placer_(robot.robot, robot.scene), start_(start) {
    const auto& coordinates = robot.description.coordinates;
    for (std::size_t i = 0; i < coordinates.size(); ++i) {
      if (drive::is_single(coordinates[i])) joints_.push_back(i);
    }
    const auto poses = placer_.place(upright());
    for (const ScenePoint& point : robot.scene.constraints) {
      const bool is_level = point.rows[3] || point.rows[4];
      feet_.push_back(
          {index_of_link(robot.robot, point.link), isometry_of(point.origin), is_level});
      first_.push_back(poses[feet_.back().link] * feet_.back().origin);
    }
    find_middle(poses);
    bend_ = 0.06 * (center_of_mass(poses).z() - middle_.z());
  }

  [[nodiscard]] VectorXd begin(double bend) const {
    return VectorXd::Constant(static_cast<Eigen::Index>(joints_.size()) + 3, bend);
  }

  [[nodiscard]] std::vector<double> place(const VectorXd& x) const {
    std::vector<double> q = start_;
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      const auto& coordinate = robot_.description.coordinates[joints_[i]];
      const double moved = start_[joints_[i]] + x[static_cast<Eigen::Index>(i)];
      q[joints_[i]] = std::clamp(moved, coordinate.lower, coordinate.upper);
    }
    return q;
  }

  /// What must vanish, in m: how feet move against each other and tilt, and how far the centre of
  /// mass is from the middle.
  [[nodiscard]] VectorXd must(const VectorXd& x) const {
    constexpr double kTilt = 0.2;  // m by rad
    const auto poses = placer_.place(place(x));
    const Vector3d way = x.tail<3>();
    VectorXd errors = VectorXd::Zero(static_cast<Eigen::Index>(6 * feet_.size()) + 2);
    for (std::size_t k = 0; k < feet_.size(); ++k) {
      const Isometry3d now = poses[feet_[k].link] * feet_[k].origin;
      const auto at = static_cast<Eigen::Index>(6 * k);
      errors.segment<3>(at) = now.translation() - first_[k].translation() - way;
      const Matrix3d turn = now.linear() * first_[k].linear().transpose();
      const Vector3d tilt(turn(2, 1) - turn(1, 2), turn(0, 2) - turn(2, 0),
                          turn(1, 0) - turn(0, 1));
      if (feet_[k].is_level) errors.segment<3>(at + 3) = 0.5 * kTilt * tilt;
    }
    errors.tail<2>() = (center_of_mass(poses) - middle_ - way).head<2>();
    return errors;
  }

  /// What should be small beside that: the way of the joints, and what the legs are not bent.
  [[nodiscard]] VectorXd should(const VectorXd& x) const {
    constexpr double kJoint = 0.01;  // m by rad
    constexpr double kHeight = 1.0;
    VectorXd errors = kJoint * x;
    errors.tail<3>() = Vector3d(0, 0, kHeight * (x[x.size() - 1] - bend_));
    return errors;
  }

 private:
  /// The robot as its file has it: feet are level there, though joints may be beyond their limits.
  [[nodiscard]] std::vector<double> upright() const {
    std::vector<double> q = start_;
    for (const std::size_t joint : joints_) q[joint] = 0;
    return q;
  }

  [[nodiscard]] Vector3d center_of_mass(const std::vector<Isometry3d>& poses) const {
    Vector3d sum = Vector3d::Zero();
    double mass = 0;
    for (std::size_t i = 0; i < poses.size(); ++i) {
      const auto& inertial = robot_.robot.links[i].inertial;
      if (!inertial) continue;
      sum += inertial->mass * (poses[i] * Vector3d(inertial->origin.xyz.data()));
      mass += inertial->mass;
    }
    return mass > 0 ? Vector3d(sum / mass) : sum;
  }

  /// The middle of the points that touch the ground first.
  void find_middle(const std::vector<Isometry3d>& poses) {
    constexpr double kLevel = 0.01;  // m
    std::vector<Vector3d> points;
    for (const SceneTouch& touch : robot_.scene.touches) {
      const std::size_t link = index_of_link(robot_.robot, touch.link);
      for (const auto& point : touch.points) {
        points.push_back(poses[link] * Vector3d(point.data()) - touch.radius * Vector3d::UnitZ());
      }
    }
    const auto by_height = [](const Vector3d& a, const Vector3d& b) { return a.z() < b.z(); };
    if (points.empty()) return;
    const double lowest = std::min_element(points.begin(), points.end(), by_height)->z();
    std::erase_if(points, [&](const Vector3d& point) { return point.z() > lowest + kLevel; });
    for (const Vector3d& point : points) middle_ += point / static_cast<double>(points.size());
  }

  const LaunchedRobot& robot_;
  LinkPlacer placer_;
  const std::vector<double>& start_;
  std::vector<std::size_t> joints_;
  std::vector<Foot> feet_;
  std::vector<Isometry3d> first_;  ///< the feet where all joints are at 0
  Vector3d middle_ = Vector3d::Zero();
  double bend_ = 0;  ///< m
};

/// By the method of Levenberg and Marquardt from all joints displaced by `bend`, since straight
/// legs do not tell in which direction they bend.
VectorXd find_stance(const Stance& stance, double bend) {
  constexpr int kSteps = 60;
  constexpr double kLongest = 0.2;  // rad or m
  constexpr double kWay = 1e-6;
  VectorXd x = stance.begin(bend);
  const auto errors = [&](const VectorXd& at) {
    const VectorXd must = stance.must(at);
    const VectorXd should = stance.should(at);
    VectorXd all(must.size() + should.size());
    all << must, 0.05 * should;
    return all;
  };
  for (int step = 0; step < kSteps; ++step) {
    const VectorXd e = errors(x);
    Eigen::MatrixXd J(e.size(), x.size());
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      VectorXd moved = x;
      moved[i] += kWay;
      J.col(i) = (errors(moved) - e) / kWay;
    }
    const Eigen::MatrixXd A =
        J.transpose() * J + 1e-8 * Eigen::MatrixXd::Identity(x.size(), x.size());
    const VectorXd way = A.ldlt().solve(-J.transpose() * e);
    x += way * std::min(1.0, kLongest / std::max(kLongest, way.cwiseAbs().maxCoeff()));
  }
  return x;
}

}  // namespace

std::optional<std::vector<double>> find_standing_start(const LaunchedRobot& robot,
                                                       const std::vector<double>& start,
                                                       const AdmitsStart& admits) {
  constexpr double kBend = 0.2;    // rad
  constexpr double kLevel = 1e-3;  // m
  if (robot.scene.constraints.empty()) return std::nullopt;
  const Stance stance(robot, start);
  for (const double bend : {kBend, -kBend}) {
    const VectorXd x = find_stance(stance, bend);
    if (!(stance.must(x).cwiseAbs().maxCoeff() < kLevel)) continue;
    std::vector<double> q = stance.place(x);
    if (holds_weight(robot.library.functions(), robot.description, q) && admits(q)) return q;
  }
  return std::nullopt;
}

}  // namespace treeline
