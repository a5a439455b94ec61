
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "driving/find_start.hpp"

namespace treeline {
namespace {

using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// How well the rows of the task can be moved.
struct Dexterity {
  double least = 0;  ///< smallest singular value by the largest
  double sum = 0;    ///< of logarithms of singular values, which grows where any of them does
};

class Task {
 public:
  Task(const drive::RobotLibrary& library, const drive::RobotDescription& robot)
      : library_(library), J_(library.task_rows, library.velocities) {
    for (const drive::DrivenPoint& point : robot.points) {
      for (const std::string& row : point.rows) is_turn_.push_back(row.front() == 'r');
    }
    slides_.assign(static_cast<std::size_t>(library.velocities), false);
    for (const drive::DrivenCoordinate& coordinate : robot.coordinates) {
      if (coordinate.velocity_index < 0) continue;
      slides_[static_cast<std::size_t>(coordinate.velocity_index)] = !drive::is_angle(coordinate);
    }
  }

  Dexterity at(const std::vector<double>& q) {
    constexpr double kSmallest = 0.01;  // below it, a direction counts as immovable
    library_.jacobian(q.data(), J_.data());
    scale();
    const Eigen::VectorXd values = Eigen::JacobiSVD<Rows>(J_).singularValues();
    Dexterity dexterity;
    for (const double value : values) dexterity.sum += std::log(value + kSmallest);
    dexterity.least = values.minCoeff() / std::max(values.maxCoeff(), kSmallest);
    return dexterity;
  }

 private:
  /// Measures lengths in the longest arm of a joint that turns, so that angles and ways compare.
  void scale() {
    double reach = 0;
    for_each_arm([&](double& entry) { reach = std::max(reach, std::fabs(entry)); });
    if (!(reach > 0)) return;
    for_each_arm([&](double& entry) { entry /= reach; });
  }
  template <class Visit>
  void for_each_arm(Visit visit) {
    for (Eigen::Index row = 0; row < J_.rows(); ++row) {
      if (is_turn_[static_cast<std::size_t>(row)]) continue;
      for (Eigen::Index column = 0; column < J_.cols(); ++column) {
        if (!slides_[static_cast<std::size_t>(column)]) visit(J_(row, column));
      }
    }
  }

  const drive::RobotLibrary& library_;
  Rows J_;
  std::vector<bool> is_turn_, slides_;
};

/// A place that differs in one joint, and how much better it is.
struct Step {
  std::vector<double> q;
  double gain = 0;
  double height = 0;  ///< of the operational points, m; of the most helpful steps alone
};

/// Every step of one joint from `from` that helps, the most helpful first.
std::vector<Step> list_steps(Task& task, const drive::RobotDescription& robot,
                             const std::vector<double>& start, const std::vector<double>& from) {
  constexpr double kMargin = 0.15;    // of a joint's range
  constexpr double kCostOfWay = 0.3;  // per rad that a joint is away from where it began
  const double now = task.at(from).sum;
  std::vector<Step> steps;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const drive::DrivenCoordinate& coordinate = robot.coordinates[i];
    if (!drive::is_single(coordinate) || !drive::is_angle(coordinate)) continue;
    const double range = coordinate.upper - coordinate.lower;
    const double margin = std::isfinite(range) ? kMargin * range : 0;
    for (const double angle : {0.4, -0.4, 0.8, -0.8, 1.2, -1.2}) {
      Step step{from};
      step.q[i] = start[i] + angle;
      if (step.q[i] < coordinate.lower + margin || step.q[i] > coordinate.upper - margin) continue;
      const double further = std::fabs(angle) - std::fabs(from[i] - start[i]);
      step.gain = task.at(step.q).sum - now - kCostOfWay * further;
      if (step.gain > 0) steps.push_back(std::move(step));
    }
  }
  std::stable_sort(steps.begin(), steps.end(),
                   [](const Step& a, const Step& b) { return a.gain > b.gain; });
  return steps;
}

/// Puts the highest first among steps that help nearly alike, such as bending an elbow up or down:
/// a table may be below.
void put_highest_first(const drive::RobotLibrary& library, const drive::RobotDescription& robot,
                       std::vector<Step>& steps) {
  constexpr double kAlike = 0.8;
  const auto end = std::find_if(steps.begin(), steps.end(), [&](const Step& step) {
    return step.gain < kAlike * steps.front().gain;
  });
  for (auto step = steps.begin(); step != end; ++step) {
    step->height = height_of_points(library, robot, step->q);
  }
  std::stable_sort(steps.begin(), end,
                   [](const Step& a, const Step& b) { return a.height > b.height; });
}

}  // namespace

std::optional<std::vector<double>> find_bent_start(const drive::RobotLibrary& library,
                                                   const drive::RobotDescription& robot,
                                                   const std::vector<double>& start,
                                                   const AdmitsStart& admits) {
  constexpr double kSingular = 0.05;  // below it, goals may ask for twenty times the usual speed
  constexpr double kFine = 0.1;
  if (library.jacobian == nullptr) return std::nullopt;
  Task task(library, robot);
  if (task.at(start).least >= kSingular) return std::nullopt;
  constexpr double kEasily = 0.7;
  const bool must_hold = holds_weight(library, robot, start);
  const double share = holds_weight(library, robot, start, kEasily) ? kEasily : 1.0;
  std::vector<double> best = start;
  for (std::size_t i = 0; i < 2 * start.size() && task.at(best).least < kFine; ++i) {
    std::vector<Step> steps = list_steps(task, robot, start, best);
    put_highest_first(library, robot, steps);
    const auto step = std::find_if(steps.begin(), steps.end(), [&](const Step& each) {
      return (!must_hold || holds_weight(library, robot, each.q, share)) && admits(each.q);
    });
    if (step == steps.end()) break;
    best = step->q;
  }
  if (task.at(best).least < kSingular) return std::nullopt;
  return best;
}

}  // namespace treeline
