#include "finding.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace treeline::stress {
namespace {

const Loss* find_loss(const Sample& sample, const Loss& like) {
  for (const Loss& loss : sample.losses) {
    if (loss.function == like.function && loss.algorithm == like.algorithm) return &loss;
  }
  return nullptr;
}

/// Appends the digits that an algorithm without errors of its own would keep if the whole condition
/// number were lost.
void append_condition(const std::vector<Sample>& samples, const Loss& like, Finding& finding) {
  Curve curve{function_name(like.function), "1 ulp x condition", {}, true};
  for (const Sample& sample : samples) {
    const Loss* loss = find_loss(sample, like);
    curve.y.push_back(loss == nullptr ? std::nan("") : digits_left(loss->condition));
  }
  finding.curves.push_back(std::move(curve));
}

}  // namespace

Finding make_finding(std::string name, std::string title, std::string x_label,
                     const std::vector<Sample>& samples, double allowed) {
  Finding finding{
      std::move(name), std::move(title), std::move(x_label), kDigitsLeft, {}, {}, {}, {}};
  for (const Sample& sample : samples) finding.x.push_back(sample.x);
  Function before{};
  for (const Loss& like : samples.front().losses) {
    Curve curve{function_name(like.function), like.algorithm, {}, false};
    double worst = 0;
    for (const Sample& sample : samples) {
      const Loss* loss = find_loss(sample, like);
      curve.y.push_back(loss == nullptr ? std::nan("") : digits_left(loss->error));
      if (loss != nullptr) worst = std::max(worst, loss->ratio);
    }
    const bool first = finding.curves.empty() || like.function != before;
    before = like.function;
    if (first && like.condition != 1) append_condition(samples, like, finding);
    finding.curves.push_back(std::move(curve));
    finding.said.push_back(fmt::format("{:<20} {:<66} {:>10.3g} ulp x condition",
                                       function_name(like.function), like.algorithm, worst));
    claim(worst <= allowed,
          fmt::format("{}, {}: error <= {} ulp x condition (is {:.3g})",
                      function_name(like.function), like.algorithm, allowed, worst),
          finding);
  }
  return finding;
}

void claim(bool holds, const std::string& claim, Finding& finding) {
  if (!holds) finding.broken.push_back(claim);
}

report::Table table_of(const Finding& finding) {
  std::vector<std::string> names{"x"};
  for (const Curve& curve : finding.curves) {
    std::string name = curve.panel + ": " + curve.name;
    std::replace(name.begin(), name.end(), ',', ';');
    names.push_back(name);
  }
  report::Table table(names, finding.x.size());
  for (std::size_t i = 0; i < finding.x.size(); ++i) {
    std::vector<double> row{finding.x[i]};
    for (const Curve& curve : finding.curves) row.push_back(curve.y[i]);
    table.append(row.data());
  }
  return table;
}

report::Plot plot_of(const Finding& finding) {
  report::Plot plot;
  plot.title = finding.title;
  plot.x_label = finding.x_label;
  plot.x = finding.x;
  for (const Curve& curve : finding.curves) {
    if (plot.panels.empty() || plot.panels.back().title != curve.panel) {
      report::PlotPanel panel;
      panel.title = curve.panel;
      panel.y_label = finding.y_label;
      // No digit left. This makes the axis long enough that errors in the sixteenth digit are not
      // magnified.
      if (finding.y_label == kDigitsLeft) {
        panel.lines.push_back({"", std::vector<double>(finding.x.size(), 0.0), true});
      }
      plot.panels.push_back(std::move(panel));
    }
    report::PlotLine line;
    line.name = curve.name;
    line.values = curve.y;
    line.dashed = curve.dashed;
    plot.panels.back().lines.push_back(std::move(line));
  }
  return plot;
}

}  // namespace treeline::stress
