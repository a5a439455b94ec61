#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "inspect/draw_states.hpp"
#include "inspect/inspect_robot.hpp"
#include "interpreter/loop_instances.hpp"
#include "oracle/model_from_robot.hpp"
#include "oracle/symmetric_matrices.hpp"

namespace treeline {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using interpreter::Loops;
using interpreter::Model;

constexpr int kPoses = 2, kGuesses = 64;
constexpr double kClosed = 1e-12;     ///< m, and the sine of an angle
constexpr double kDependent = 1e-12;  ///< squared singular value, beside the largest one

/// Squared singular values, ascending.
VectorXd squared_singular_values(const MatrixXd& J) {
  return eigenvalues_of_symmetric(J.transpose() * J);
}

int rank_of(const MatrixXd& J) {
  if (J.size() == 0) return 0;
  const VectorXd squares = squared_singular_values(J);
  const double least = kDependent * squares.maxCoeff();
  return static_cast<int>(
      std::count_if(squares.begin(), squares.end(), [&](double square) { return square > least; }));
}

/// Digits that lie between the largest singular value and the one that the rank counts as least.
double digits_between(const MatrixXd& J, int rank) {
  if (rank == 0) return 0;
  const VectorXd squares = squared_singular_values(J);
  const double ratio = squares[squares.size() - rank] / squares.maxCoeff();
  return ratio > kDependent / 100 ? -0.5 * std::log10(ratio) : kMostDigits;
}

/// A robot with loops and the poses in which they are closed.
class LoopedRobot {
 public:
  LoopedRobot(const Robot& robot, const Scene& scene)
      : model_(model_from_robot<double>(robot, scene)),
        loops_(loops_from_scene(model_, robot, scene)),
        passive_(passive_velocities(model_, robot, scene)) {}

  [[nodiscard]] const Model<double>& model() const { return model_; }
  [[nodiscard]] bool has_loops() const { return !loops_.empty(); }

  /// Looks for closed poses, and takes ranks and scales of rows and columns from them, so that
  /// units do not matter. Returns whether there are some.
  bool find_poses(DrawnStates& states) {
    std::vector<int> all(static_cast<std::size_t>(model_.nv));
    for (int v = 0; v < model_.nv; ++v) all[static_cast<std::size_t>(v)] = v;
    for (int guess = 0; guess < kGuesses && poses_.size() < kPoses; ++guess) {
      const auto q = interpreter::close_loops<double>(model_, loops_, states.draw(), all, kClosed);
      if (q && within_limits(states, *q)) poses_.push_back(*q);
    }
    if (poses_.empty()) return false;
    take_scales();
    for (const VectorXd& q : poses_) {
      const MatrixXd J = scaled_jacobian(q);
      rank_ = std::max(rank_, rank_of(J));
      passive_rank_ = std::max(passive_rank_, rank_of(J(Eigen::all, passive_)));
    }
    return true;
  }

  [[nodiscard]] const std::vector<VectorXd>& poses() const { return poses_; }
  [[nodiscard]] bool is_passive(int v) const {
    return std::find(passive_.begin(), passive_.end(), v) != passive_.end();
  }
  [[nodiscard]] bool has_passive() const { return !passive_.empty(); }
  [[nodiscard]] bool is_in_a_loop(int v) const {
    return std::find(moving_.begin(), moving_.end(), v) != moving_.end();
  }

  [[nodiscard]] LoopsReport report() const {
    const auto unheld =
        std::count_if(moving_.begin(), moving_.end(), [&](int v) { return is_passive(v); });
    return {static_cast<int>(rows_.size()), static_cast<int>(rows_.size()) - rank_,
            static_cast<int>(moving_.size()) - rank_, static_cast<int>(unheld) - passive_rank_};
  }

  /// Digits lost by rows that depend on each other more than elsewhere, and by passive joints that
  /// the motors do not hold.
  struct Loss {
    double rows = 0, hold = 0;
  };
  [[nodiscard]] Loss loss_at(const VectorXd& q) const {
    const MatrixXd J = scaled_jacobian(q);
    return {digits_between(J, rank_), digits_between(J(Eigen::all, passive_), passive_rank_)};
  }

  /// Velocities of passive joints that take part in the motion that the motors hold least.
  [[nodiscard]] std::vector<int> least_held(const VectorXd& q) const {
    const MatrixXd J = scaled_jacobian(q)(Eigen::all, passive_);
    const MatrixXd combinations = decompose_symmetric(J.transpose() * J).vectors;
    const VectorXd motion = combinations.col(J.cols() - passive_rank_);
    std::vector<int> velocities;
    for (Eigen::Index i = 0; i < motion.size(); ++i) {
      if (std::abs(motion[i]) < 0.1) continue;
      velocities.push_back(passive_[static_cast<std::size_t>(i)]);
    }
    return velocities;
  }

  /// The closed pose near q at which one joint has this coordinate; nothing if there is none. The
  /// other joints start from where the loops' rates lead them.
  [[nodiscard]] std::optional<VectorXd> pose_at(const VectorXd& q, const JointReport& joint,
                                                double value) const {
    std::vector<int> others = moving_;
    std::erase(others, joint.v);
    const MatrixXd J = interpreter::loop_jacobian<double>(model_, loops_, q);
    VectorXd change = VectorXd::Zero(model_.nv);
    change[joint.v] = value - q[joint.q];
    change(others) = interpreter::least_motion<double>(J(Eigen::all, others), -J * change);
    if (change.norm() > 1) return std::nullopt;
    VectorXd guess = interpreter::move_coordinates<double>(model_, q, change, 1);
    guess[joint.q] = value;
    return interpreter::close_loops<double>(model_, loops_, guess, others, kClosed);
  }

 private:
  static bool within_limits(const DrawnStates& states, const VectorXd& q) {
    const auto& joints = states.joints();
    return std::all_of(joints.begin(), joints.end(), [&](const JointReport* joint) {
      return q[joint->q] >= joint->lower && q[joint->q] <= joint->upper;
    });
  }

  void take_scales() {
    columns_ = VectorXd::Zero(model_.nv);
    std::vector<MatrixXd> all;
    for (const VectorXd& q : poses_) {
      all.push_back(interpreter::loop_jacobian<double>(model_, loops_, q));
      columns_ = columns_.cwiseMax(all.back().colwise().norm().transpose());
    }
    for (int v = 0; v < model_.nv; ++v) {
      if (columns_[v] > 0) moving_.push_back(v);
      columns_[v] = columns_[v] > 0 ? 1 / columns_[v] : 0;
    }
    rows_ = VectorXd::Zero(all.front().rows());
    for (const MatrixXd& J : all)
      rows_ = rows_.cwiseMax((J * columns_.asDiagonal()).rowwise().norm());
    for (double& row : rows_) row = row > 0 ? 1 / row : 0;
  }

  [[nodiscard]] MatrixXd scaled_jacobian(const VectorXd& q) const {
    return rows_.asDiagonal() * interpreter::loop_jacobian<double>(model_, loops_, q) *
           columns_.asDiagonal();
  }

  Model<double> model_;
  Loops<double> loops_;
  std::vector<int> passive_;  ///< velocities without a motor
  std::vector<int> moving_;   ///< velocities that move a row
  std::vector<VectorXd> poses_;
  VectorXd rows_, columns_;  ///< scales
  int rank_ = 0, passive_rank_ = 0;
};

/// The worst pose on a joint's way.
struct Worst {
  double digits = 0;
  VectorXd q;
};

/// Leads a joint through its range, without limits half a turn or 1 m to either side of where it
/// starts, and to the worst pose as far as a double can tell.
class JointWalk {
 public:
  using Measure = double LoopedRobot::Loss::*;

  JointWalk(const LoopedRobot& robot, const JointReport& joint) : robot_(robot), joint_(joint) {}

  void walk_from(const VectorXd& start, Measure measure) {
    const double at = start[joint_.q];
    lower_ = std::max(joint_.lower, at - DrawnStates::reach(joint_));
    upper_ = std::min(joint_.upper, at + DrawnStates::reach(joint_));
    const double first = (upper_ - lower_) / kRangeSteps;
    for (const double step : {first, -first}) {
      std::optional<VectorXd> q = start;
      while (q) {
        look_at(*q, measure);
        q = next_nearest(*q, step);
      }
    }
    if (worst_.q.size() == 0) return;
    for (double step = first / 2; step > 1e-13 * first; step /= 2) {
      for (const double sign : {-1.0, 1.0}) {
        if (const auto q = next(worst_.q, worst_.q[joint_.q] + sign * step)) look_at(*q, measure);
      }
    }
  }

  [[nodiscard]] const Worst& worst() const { return worst_; }

 private:
  [[nodiscard]] std::optional<VectorXd> next(const VectorXd& q, double value) const {
    return value >= lower_ && value <= upper_ ? robot_.pose_at(q, joint_, value) : std::nullopt;
  }

  /// One step on, or a shorter one where others move fast.
  [[nodiscard]] std::optional<VectorXd> next_nearest(const VectorXd& q, double step) const {
    for (const double part : {1.0, 0.5, 0.25, 0.125}) {
      if (auto found = next(q, q[joint_.q] + part * step)) return found;
    }
    return std::nullopt;
  }

  void look_at(const VectorXd& q, Measure measure) {
    const double digits = robot_.loss_at(q).*measure;
    if (digits > worst_.digits) worst_ = {digits, q};
  }

  const LoopedRobot& robot_;
  const JointReport& joint_;
  double lower_ = 0, upper_ = 0;
  Worst worst_;
};

std::vector<std::string> names_of(const std::vector<int>& velocities, const Report& report) {
  std::vector<std::string> names;
  for (const JointReport& joint : report.joints) {
    const auto moves = [&](int v) { return v >= joint.v && v < joint.v + joint.nv; };
    if (joint.follows.empty() && std::any_of(velocities.begin(), velocities.end(), moves)) {
      names.push_back(joint.name);
    }
  }
  return names;
}

void add_risk(const LoopedRobot& robot, const JointReport& joint, JointWalk::Measure measure,
              Report& report) {
  JointWalk walk(robot, joint);
  for (const VectorXd& start : robot.poses()) walk.walk_from(start, measure);
  const auto& [digits, q] = walk.worst();
  if (digits < kSingularDigits) return;
  const double wound = q[joint.q];
  const bool turns = joint.unit == "rad" && std::isinf(joint.upper - joint.lower);
  const double value = turns ? std::remainder(wound, 2 * std::numbers::pi) : wound;
  const std::string at = fmt::format("{:.4g} {}", std::abs(value) < 1e-6 ? 0 : value, joint.unit);
  if (measure == &LoopedRobot::Loss::rows) {
    report.risks.push_back({joint.name, "loop", digits,
                            fmt::format("leads to a fold, as at {}: the loop gains a freedom", at),
                            "Keep the joint away from there."});
  } else {
    const auto names = names_of(robot.least_held(q), report);
    report.risks.push_back(
        {joint.name, "loop", digits,
         fmt::format("leads to a dead point, as at {}: no motor holds {}", at,
                     names.empty() ? "the base" : fmt::format("{}", fmt::join(names, ", "))),
         "Keep the joint away from there, or give another joint of the loop a motor."});
  }
}

}  // namespace

void inspect_loops(const Robot& robot, const Scene& scene, Report& report) {
  LoopedRobot looped(robot, scene);
  if (!looped.has_loops()) return;
  DrawnStates states(looped.model(), report);
  if (!looped.find_poses(states)) {
    report.risks.push_back(
        {"", "loop", kMostDigits,
         fmt::format("no pose was found that closes the loops, from {} guesses", kGuesses),
         "Check `origin` and `other_origin` of the constraints, and the joints' limits."});
    return;
  }
  report.loops = looped.report();
  for (const JointReport* joint : states.joints()) {
    if (!looped.is_in_a_loop(joint->v) || looped.is_passive(joint->v)) continue;
    add_risk(looped, *joint, &LoopedRobot::Loss::rows, report);
    if (looped.has_passive()) add_risk(looped, *joint, &LoopedRobot::Loss::hold, report);
  }
}

}  // namespace treeline
