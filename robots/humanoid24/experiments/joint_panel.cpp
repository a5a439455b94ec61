#include "joint_panel.hpp"

#include <algorithm>
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

}  // namespace treeline::experiments
