#include <fmt/core.h>

#include <cmath>
#include <vector>

#include "turn_ball.hpp"

namespace treeline::experiments {
namespace {

enum Column : std::size_t {
  kTime,
  kWantedPlace,
  kWantedTurn = kWantedPlace + 3,
  kPlace = kWantedTurn + 3,
  kTurn = kPlace + 3,
  kTorque = kTurn + 3,
  kFrictionChosen,
  kFrictionFelt,
  kPressures
};
constexpr double kFrictionAllowed = 0.6;  ///< of the forces that are chosen

/// Three coordinates over those that are wanted.
report::PlotPanel path_panel(const report::Table& table, const char* title, const char* label,
                             std::size_t actual, std::size_t wanted) {
  constexpr const char* kAxes[] = {"x", "y", "z"};
  report::PlotPanel panel{title, label, {}, 0.0};
  for (std::size_t i = 0; i < 3; ++i) {
    std::vector<double> values = table.column(actual + i), goals = table.column(wanted + i);
    for (double& value : values) value *= 1e3;
    for (double& goal : goals) goal *= 1e3;
    panel.lines.push_back({kAxes[i], values, false});
    panel.lines.push_back({i == 0 ? "wanted" : "", goals, true});
  }
  return panel;
}

}  // namespace

std::string ball_summary(const BallRun& run) {
  const BallFigures& f = run.figures;
  return fmt::format(
      "{} fingers of the {} hand turn a ball by {} rad and lead it by {} mm\n\n"
      "ends                      after {:.2f} s, {}\n"
      "torque                    at the ball {} N m; of a motor {:.3f} of its limit, largest\n"
      "forces chosen             pressure {:.2f} N, least; {:.3f} of it across, largest\n"
      "forces felt               pressure {:.2f} N, least; {:.3f} of it across, largest, of {}\n"
      "contacts                  slipped {:.1e} m, rolled by {:.4f} m\n"
      "speed of a joint          {:.3f} of its limit, largest\n"
      "ball off its path         {:.1e} m, {:.1e} rad; in the end {:.1e} m, {:.1e} rad\n",
      run.fingers, run.hand, run.plan.turn, 1e3 * run.plan.way,
      run.table.at(run.table.rows() - 1, kTime), run.fault ? run.fault_text : "no fault",
      f.ball_torque, f.torque, f.least_pressure, f.friction, f.least_felt, f.friction_felt,
      run.friction, f.slipped, f.rolled, f.speed, f.away, f.turned_away, f.end_away,
      f.end_turned_away);
}

std::string ball_page_table(const std::vector<BallRun>& runs) {
  std::vector<std::string> lines{"| in every cycle |",
                                 "|---|",
                                 "| turned to either side, led by |",
                                 "| forces chosen: least pressure, largest share across |",
                                 "| forces felt: the same |",
                                 "| tips slipped, rolled by |",
                                 "| ball off its path |",
                                 "| largest torque, speed, of their limits |"};
  for (const BallRun& run : runs) {
    const BallFigures& f = run.figures;
    const std::vector<std::string> cells{
        fmt::format("{}, {} fingers", run.hand, run.fingers),
        "",
        fmt::format("{} rad, {:.0f} mm", run.plan.turn, 1e3 * run.plan.way),
        fmt::format("{:.2f} N, {:.3f}", f.least_pressure, f.friction),
        fmt::format("{:.2f} N, {:.3f}", f.least_felt, f.friction_felt),
        fmt::format("{:.0f} mm, {:.1f} mm", 1e3 * f.slipped, 1e3 * f.rolled),
        fmt::format("{:.0f} \u00b5m, {:.1f} mrad", 1e6 * f.away, 1e3 * f.turned_away),
        fmt::format("{:.3f}, {:.3f}", f.torque, f.speed)};
    for (std::size_t i = 0; i < lines.size(); ++i) {
      lines[i] += i == 1 ? "---|" : " " + cells[i] + " |";
    }
  }
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

report::Plot ball_figure(const BallRun& run) {
  const report::Table& table = run.table;
  report::Plot plot;
  plot.title = fmt::format("{} fingers of the {} hand turn a ball", run.fingers, run.hand);
  plot.x_label = "time (s)";
  plot.x = table.column(kTime);
  plot.panels.push_back(
      path_panel(table, "Turn of the ball", "rotation vector (mrad)", kTurn, kWantedTurn));
  plot.panels.push_back(path_panel(table, "Way of the ball", "way (mm)", kPlace, kWantedPlace));
  report::PlotPanel pressures{"Pressure of the fingertips", "force (N)", {}, 0.0};
  for (int i = 0; i < run.fingers; ++i) {
    pressures.lines.push_back({i == run.fingers - 1 ? "thumb" : fmt::format("finger {}", i + 1),
                               table.column(kPressures + static_cast<std::size_t>(i)), false});
  }
  plot.panels.push_back(pressures);
  const std::vector<double> limit(table.rows(), run.friction);
  plot.panels.push_back({"Largest force across, as a share of the pressure",
                         "share",
                         {{"felt", table.column(kFrictionFelt), false},
                          {"chosen", table.column(kFrictionChosen), false},
                          {"friction", limit, true}},
                         0.0});
  plot.panels.push_back({"Largest torque of a motor as a share of its limit",
                         "share",
                         {{"torque", table.column(kTorque), false}},
                         0.0});
  return plot;
}

bool ball_claim_holds(const BallRun& run) {
  const BallFigures& f = run.figures;
  const bool kept = !run.fault && f.ball_torque == 0.0 && f.torque <= 1.0 && f.speed <= 1.0 &&
                    f.least_pressure > 0.5 && f.friction < kFrictionAllowed;
  const bool held = f.least_felt > 0.5 && f.friction_felt < run.friction && f.slipped < 1e-6;
  const bool moved = f.rolled > 0.002 && f.away < 1e-4 && f.turned_away < 3e-3 &&
                     f.end_away < 5e-5 && f.end_turned_away < 1e-3;
  return kept && held && moved;
}

}  // namespace treeline::experiments
