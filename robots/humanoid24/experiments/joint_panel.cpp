#include "joint_panel.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace treeline::experiments {
namespace {

/// Indices of the joints whose columns have the largest span, the largest first. Their columns
/// begin at `first`.
std::vector<std::size_t> busiest(const report::Table& table, std::size_t first, std::size_t joints,
                                 std::size_t count) {
  std::vector<double> spans(joints);
  std::vector<std::size_t> order(joints);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = 0; i < joints; ++i) {
    const std::vector<double> values = table.column(first + i);
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    spans[i] = values.empty() ? 0.0 : *high - *low;
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return spans[a] > spans[b]; });
  order.resize(std::min(count, joints));
  return order;
}

/// The largest size of a change from row to row.
double largest_step(const std::vector<double>& values) {
  double step = 0.0;
  for (std::size_t i = 1; i < values.size(); ++i) {
    step = std::max(step, std::abs(values[i] - values[i - 1]));
  }
  return step;
}

/// The joints' indices, those with the greatest value first.
std::vector<std::size_t> by_size(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return values[a] > values[b]; });
  return order;
}

std::string spaced(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

}  // namespace

report::PlotPanel joint_panel(const report::Table& table, const Plan& plan,
                              const std::string& title, const std::string& y_label,
                              std::size_t first, bool from_start) {
  constexpr std::size_t kMost = 7;
  report::PlotPanel panel{title, y_label, {}, 0.0};
  for (const std::size_t joint : busiest(table, first, plan.joints.size(), kMost)) {
    std::vector<double> values = table.column(first + joint);
    for (double& value : values) {
      value -= from_start ? plan.start[joint] : 0.0;
    }
    panel.lines.push_back({spaced(plan.joints[joint]), std::move(values), false});
  }
  return panel;
}

JointWords describe_joints(const report::Table& table, const Plan& plan, const JointLimits& limits,
                           std::size_t first) {
  const std::size_t count = plan.joints.size();
  std::vector<double> margins(count), speeds(count), torques(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::vector<double> q = table.column(first + i);
    const auto [low, high] = std::minmax_element(q.begin(), q.end());
    margins[i] = -std::min(*low - limits.lower[i], limits.upper[i] - *high);
    speeds[i] = plan.rate * largest_step(q);
    for (const double tau : table.column(first + count + i)) {
      torques[i] = std::max(torques[i], std::abs(tau));
    }
  }
  const std::size_t nearest = by_size(margins)[0];
  const std::size_t fastest = by_size(speeds)[0];
  std::string greatest;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t joint = by_size(torques)[k];
    greatest +=
        fmt::format("{}`{}` {:.0f}", k == 0 ? "" : ", ", plan.joints[joint], torques[joint]);
  }
  return {fmt::format("{:.3f} rad away (`{}`)", -margins[nearest], plan.joints[nearest]),
          fmt::format("{:.2f} rad/s (`{}`)", speeds[fastest], plan.joints[fastest]),
          greatest + " N m"};
}

}  // namespace treeline::experiments
