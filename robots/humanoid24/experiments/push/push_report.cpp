#include <fmt/core.h>

#include <cmath>
#include <vector>

#include "humanoid24_push_joints.hpp"
#include "humanoid_on_soles.hpp"
#include "push.hpp"

namespace treeline::experiments {
namespace {

enum Column : std::size_t {
  kTime,
  kComX,
  kComY,
  kPressureX,
  kPressureY,
  kLeftLoad,
  kRightLoad,
  kHandError,
  kTorque,
  kPush,
  kTilt
};

double end_of(const PushRun& run) {
  return run.table.at(run.table.rows() - 1, kTime);
}

std::string describe_end(const PushRun& run) {
  if (!run.fault) return "no fault";
  return describe_fault(run.fault, humanoid24_push::kCoordinateJoints,
                        humanoid24_push::kVelocityJoints);
}

std::string describe(const PushRun& run) {
  const PushFigures& f = run.figures;
  return fmt::format(
      "ends                      after {:.3f} s, {}\n"
      "{}"
      "share of the left foot    {:.3f} to {:.3f}, unpushed\n"
      "soles                     tilted by {:.2e} rad, lifted by {:.2e} m, slid {:.2e} m\n"
      "left hand off its path    {:.2e} m before, {:.2e} m while pushed\n"
      "centre of mass            {:.3f} m away, pushed; in the end {:.1e} m, joints {:.1e} rad/s\n",
      end_of(run), describe_end(run), describe_limits(f), f.least_share, f.most_share, f.tilt,
      f.lifted, f.slipped, f.hand_error, f.hand_pushed, f.away, f.end_away, f.end_speed);
}

/// A column of a run that may have ended early, as long as the other's.
std::vector<double> padded(const PushRun& run, std::size_t column, std::size_t rows) {
  std::vector<double> values = run.table.column(column);
  values.resize(rows, std::nan(""));
  return values;
}

std::vector<double> scaled(std::vector<double> values, double factor) {
  for (double& value : values) value *= factor;
  return values;
}

}  // namespace

std::string push_summary(const PushRun& limited, const PushRun& unlimited) {
  return "the humanoid stands on two feet, leans, reaches, and is pushed thrice\n\nwithin "
         "limits\n" +
         describe(limited) + "\nby the unlimited law\n" + describe(unlimited);
}

std::string push_page_table(const PushRun& limited, const PushRun& unlimited) {
  const PushFigures& f = limited.figures;
  const PushFigures& u = unlimited.figures;
  return fmt::format(
      "| over {:.0f} s | within limits | unlimited law |\n|---|---|---|\n"
      "| ends | at rest, {:.1f} mm from where it began | {:.1f} s after the first push, falling, "
      "its forces {:.0f} N beyond a cone |\n"
      "| largest torque of a motor, of its limit | {:.3f} | {:.1f} |\n"
      "{}"
      "| soles tilt by, lift by | {:.1f} mrad, {:.1f} mm | {:.0f} mrad, {:.0f} mm |\n"
      "| load of the left foot, leaning | {:.0f} to {:.0f} % | {:.0f} to {:.0f} % |\n"
      "| hand off its path, unpushed and pushed | {:.0f} µm, {:.1f} mm | {:.0f} µm, {:.1f} mm |\n",
      end_of(limited), 1e3 * f.end_away, end_of(unlimited) - kFirstPush, u.beyond, f.torque,
      std::fabs(unlimited.fault.value / unlimited.fault.limit), rows_of_limits(f), 1e3 * f.tilt,
      1e3 * f.lifted, 1e3 * u.tilt, 1e3 * u.lifted, 1e2 * f.least_share, 1e2 * f.most_share,
      1e2 * u.least_share, 1e2 * u.most_share, 1e6 * f.hand_error, 1e3 * f.hand_pushed,
      1e6 * u.hand_error, 1e3 * u.hand_pushed);
}

report::Plot push_figure(const PushRun& limited, const PushRun& unlimited) {
  const report::Table& table = limited.table;
  const std::size_t rows = table.rows();
  report::Plot plot;
  plot.title = "A humanoid on two feet leans, reaches, and recovers from pushes";
  plot.x_label = "time (s)";
  plot.x = table.column(kTime);
  plot.panels.push_back({"Centres of mass and of pressure, forward",
                         "x (m)",
                         {{"pressure", table.column(kPressureX), false},
                          {"mass", table.column(kComX), false},
                          {"heel, toe", std::vector<double>(rows, HumanoidOnSoles::kHeel), true},
                          {"", std::vector<double>(rows, HumanoidOnSoles::kToe), true}},
                         0.0});
  plot.panels.push_back(
      {"Load of the feet",
       "force (N)",
       {{"left", table.column(kLeftLoad), false}, {"right", table.column(kRightLoad), false}},
       0.0});
  plot.panels.push_back(
      {"Push on the chest", "force (N)", {{"push", table.column(kPush), false}}, 0.0});
  plot.panels.push_back({"Largest torque of a motor as a share of its limit",
                         "share",
                         {{"within limits", table.column(kTorque), false},
                          {"unlimited", padded(unlimited, kTorque, rows), false}},
                         0.0});
  plot.panels.push_back({"Tilt of the soles",
                         "angle (mrad)",
                         {{"within limits", scaled(table.column(kTilt), 1e3), false},
                          {"unlimited", scaled(padded(unlimited, kTilt, rows), 1e3), false}},
                         0.0});
  plot.panels.push_back({"Hand's distance from its path",
                         "distance (mm)",
                         {{"hand", scaled(table.column(kHandError), 1e3), false}},
                         0.0});
  return plot;
}

bool push_claim_holds(const PushRun& limited, const PushRun& unlimited) {
  const PushFigures& f = limited.figures;
  const bool kept = !limited.fault && f.kept();
  const bool moved = f.least_share < 0.45 && f.most_share > 0.55 && f.away > 0.05 && f.limited > 0;
  const bool stood = f.tilt < 0.01 && f.lifted < 3e-3 && f.slipped < 0.02 && f.hand_error < 1e-4 &&
                     f.hand_pushed < 5e-3 && f.end_away < 5e-3 && f.end_speed < 0.02;
  const bool falls = unlimited.fault && unlimited.figures.tilt > 0.05;
  return kept && moved && stood && falls;
}

}  // namespace treeline::experiments
