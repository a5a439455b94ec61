#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "circles.hpp"

namespace treeline::experiments {
namespace {

// Columns of the table.
constexpr std::size_t kTool = 1;
constexpr std::size_t kBase = 10;
constexpr std::size_t kErrors = 19;
constexpr std::size_t kTrue = 6;

/// Error given by Chang for figures 6.7, 6.10 and 6.11, as a share of the radius.
constexpr double kThesisShare = 0.04;

bool base_moves(const CircleRun& run) {
  return run.plan.base_radius > 0.0;
}

std::vector<double> scaled(std::vector<double> values, double factor) {
  for (double& value : values) {
    value *= factor;
  }
  return values;
}

report::PlotPanel path(const report::Table& table, const std::string& title, std::size_t first,
                       std::size_t across, std::size_t up, const char* x_label,
                       const char* y_label) {
  report::PlotPanel panel{title, y_label, {}, 0.01, x_label};
  panel.lines.push_back(
      {"actual", table.column(first + kTrue + up), false, table.column(first + kTrue + across)});
  panel.lines.push_back({"wanted", table.column(first + up), true, table.column(first + across)});
  return panel;
}

report::PlotPanel over_time(const report::Table& table, const std::string& title, std::size_t first,
                            std::array<std::size_t, 2> axes, std::array<const char*, 2> names) {
  report::PlotPanel panel{title, "from the start (m)", {}, 0.02};
  const auto from_start = [&table](std::size_t column, std::size_t wanted) {
    std::vector<double> values = table.column(column);
    for (double& value : values) {
      value -= table.at(0, wanted);
    }
    return values;
  };
  for (std::size_t i = 0; i < 2; ++i) {
    const std::size_t wanted = first + axes[i];
    panel.lines.push_back({names[i], from_start(wanted + kTrue, wanted), false});
  }
  for (std::size_t i = 0; i < 2; ++i) {
    const std::size_t wanted = first + axes[i];
    panel.lines.push_back({i == 0 ? "wanted" : "", from_start(wanted, wanted), true});
  }
  return panel;
}

report::PlotPanel errors(const CircleRun& run, const std::string& title, std::size_t first,
                         std::array<std::size_t, 2> axes, std::array<const char*, 2> names) {
  const bool fine = run.model == DriveModel::ideal;
  const double unit = fine ? 1e6 : 1e3;
  report::PlotPanel panel{title, fine ? "error (\u00b5m)" : "error (mm)", {}, 0.0};
  for (std::size_t i = 0; i < 2; ++i) {
    const auto wanted = run.table.column(first + axes[i]);
    auto away = run.table.column(first + kTrue + axes[i]);
    for (std::size_t row = 0; row < away.size(); ++row) {
      away[row] = unit * (wanted[row] - away[row]);
    }
    panel.lines.push_back({names[i], std::move(away), false});
  }
  const std::size_t distance = kErrors + (first == kTool ? 0 : 3);
  if (!fine) {
    panel.lines.push_back(
        {"distance by encoders", scaled(run.table.column(distance), unit), false});
  }
  return panel;
}

std::string percent(double error, double radius) {
  return radius > 0.0 ? fmt::format("{:.2g} %", 100.0 * error / radius) : "-";
}

}  // namespace

std::string file_name(const CircleRun& run) {
  return fmt::format("{}_{}", base_moves(run) ? "tool_and_base" : "tool", name_of(run.model));
}

std::string circles_summary(const std::vector<CircleRun>& runs) {
  std::string text = fmt::format(
      "Largest errors in mm, in % of the circle's radius (100 and 50 mm); the thesis, on the real "
      "robot: {:.0f} %\n{:<10}{:<8}{:>12}{:>12}{:>12}{:>10}{:>10}{:>12}{:>12}{:>12}{:>9}\n",
      100.0 * kThesisShare, "drives", "base", "tool", "", "(encoders)", "rms", "rad", "base", "",
      "(encoders)", "us");
  for (const CircleRun& run : runs) {
    const CircleErrors& e = run.errors;
    text += fmt::format(
        "{:<10}{:<8}{:>12.3g}{:>12}{:>12.3g}{:>10.3g}{:>10.2g}{:>12.3g}{:>12}{:>12.3g}{:>9.2f}{}\n",
        name_of(run.model), base_moves(run) ? "moves" : "rests", 1e3 * e.tool,
        percent(e.tool, run.plan.tool_radius), 1e3 * e.tool_seen, 1e3 * e.tool_rms, e.rotation,
        1e3 * e.base, percent(e.base, run.plan.base_radius), 1e3 * e.base_seen,
        1e-3 * run.control.median(), run.fault ? "  stopped: " + servo::describe(run.fault) : "");
  }
  return text;
}

report::Plot circles_figure(const CircleRun& run) {
  const report::Table& table = run.table;
  const bool moves = base_moves(run);
  report::Plot plot;
  plot.title = fmt::format("SAMM draws a circle, {} (Chang fig. {}); {}",
                           moves ? "the base another" : "its base at rest",
                           moves ? "6.8 to 6.11" : "6.6, 6.7", describe(run.model));
  plot.x_label = "time (s)";
  plot.x = table.column(0);
  plot.panels.push_back(path(table, "Tool", kTool, 1, 2, "y (m)", "z (m)"));
  if (moves) {
    plot.panels.push_back(path(table, "Base", kBase, 0, 1, "x (m)", "y (m)"));
  }
  plot.panels.push_back(over_time(table, "Tool over time", kTool, {1, 2}, {"y", "z"}));
  plot.panels.push_back(errors(run, "Tool's error", kTool, {1, 2}, {"y", "z"}));
  if (moves) {
    plot.panels.push_back(over_time(table, "Base over time", kBase, {0, 1}, {"x", "y"}));
  }
  plot.panels.push_back(errors(run, "Base's error", kBase, {0, 1}, {"x", "y"}));
  return plot;
}

std::string broken_circle_claims(const std::vector<CircleRun>& runs) {
  std::string broken;
  const auto claim = [&broken](bool holds, const CircleRun& run, const char* what) {
    broken += holds ? "" : fmt::format("{}: {}\n", file_name(run), what);
  };
  for (std::size_t i = 0; i + 1 < runs.size(); i += 2) {
    const CircleRun& rests = runs[i];
    const CircleRun& moves = runs[i + 1];
    // Holding torques for a millisecond causes errors of a micrometre.
    claim(moves.errors.tool < 1.25 * rests.errors.tool + 1e-6, moves, "the tool's error grows");
    claim(moves.errors.tool_rms < 1.25 * rests.errors.tool_rms + 1e-6, moves,
          "the tool's rms error grows");
    claim(moves.errors.base_travel > 1.9 * moves.plan.base_radius, moves, "the base does not move");
    for (const CircleRun* run : {&rests, &moves}) {
      claim(!run->fault && run->table.rows() == 14001, *run, "did not run to its end");
      if (run->model == DriveModel::ideal) {
        claim(run->errors.tool < 1e-5 && run->errors.base < 1e-5, *run, "leaves its circles");
      }
    }
    if (rests.model == DriveModel::friction || rests.model == DriveModel::worn) {
      for (const CircleRun* run : {&rests, &moves}) {
        const double share = run->errors.tool / run->plan.tool_radius;
        claim(share > 0.25 * kThesisShare && share < 2.0 * kThesisShare, *run,
              "tool not of the thesis's order");
      }
      const double share = moves.errors.base / moves.plan.base_radius;
      claim(share > 0.25 * kThesisShare && share < 2.0 * kThesisShare, moves,
            "base not of the thesis's order");
    }
  }
  return broken;
}

}  // namespace treeline::experiments
