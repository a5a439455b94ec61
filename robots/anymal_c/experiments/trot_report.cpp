#include <fmt/core.h>

#include <cmath>
#include <vector>

#include "anymal_simulated_joints.hpp"
#include "trot.hpp"

namespace treeline::experiments {
namespace {

enum Column : std::size_t { kTime, kWantedWay, kSpeed, kTilt, kTorque, kIterations, kFirstFoot };
constexpr std::size_t kWay = kFirstFoot + 8;
constexpr const char* kFootNames[] = {"left fore", "right fore", "left hind", "right hind"};

std::vector<double> scaled(std::vector<double> values, double factor) {
  for (double& value : values) value *= factor;
  return values;
}

}  // namespace

std::string trot_summary(const TrotPlan& plan, const TrotRun& run) {
  const TrotFigures& f = run.figures;
  const std::string end = run.fault ? describe_fault(run.fault, anymal_simulated::kCoordinateJoints,
                                                     anymal_simulated::kVelocityJoints)
                                    : "no fault";
  return fmt::format(
      "ANYmal C stands, trots in place and walks {} m by {} steps\n\n"
      "ends                      after {:.2f} s, {}\n"
      "{}"
      "steps                     {} with both feet in the air\n"
      "speed of a joint          {:.3f} of its limit, largest\n"
      "torque of a motor         {:.1f} N m from cycle to cycle, largest change\n"
      "feet that come or go      {:.1f} N beyond a cone, largest\n"
      "body                      tilted by {:.4f} rad, {:.4f} m off its height and {:.4f} m off "
      "its "
      "path\n"
      "feet                      {:.1e} m off their paths, slid {:.1e} m all together\n"
      "in the end                {:.4f} m ahead, {:.1e} m aside, {:.1e} rad/s\n",
      plan.way, plan.steps(), run.table.at(run.table.rows() - 1, kTime), end, describe_limits(f),
      f.steps, f.speed, f.torque_step, f.beyond_in_part, f.tilt, f.height, f.away, f.swing_error,
      f.slipped, f.way, f.aside, f.end_speed);
}

std::string trot_page_table(const TrotRun& run) {
  const TrotFigures& f = run.figures;
  return fmt::format(
      "| over {:.0f} s | |\n|---|---|\n"
      "| torque of the base, largest of a motor | {}; {:.3f} of its limit |\n"
      "{}"
      "| feet that come or go, beyond a cone | {:.1f} N |\n"
      "| largest change of a torque from cycle to cycle | {:.0f} N m |\n"
      "| largest speed of a joint | {:.2f} of its limit |\n"
      "| body: tilt, height, off its path | {:.1f} mrad, {:.1f} mm, {:.0f} mm |\n"
      "| feet: off their paths in the air, sliding at all touch-downs together | {:.1f} mm, {:.0f} "
      "cm |\n"
      "| end | {:.3f} m ahead, {:.2f} mm aside |\n",
      run.table.column(kTime).back(), f.base_torque, f.torque, rows_of_limits(f), f.beyond_in_part,
      f.torque_step, f.speed, 1e3 * f.tilt, 1e3 * f.height, 1e3 * f.away, 1e3 * f.swing_error,
      1e2 * f.slipped, f.way, 1e3 * f.aside);
}

report::Plot trot_figure(const TrotRun& run) {
  const report::Table& table = run.table;
  report::Plot plot;
  plot.title = "ANYmal C stands, trots in place and walks ten metres";
  plot.x_label = "time (s)";
  plot.x = table.column(kTime);
  plot.panels.push_back(
      {"Way of the body",
       "way (m)",
       {{"body", table.column(kWay), false}, {"wanted", table.column(kWantedWay), true}},
       0.0});
  plot.panels.push_back(
      {"Speed of the body", "speed (m/s)", {{"ahead", table.column(kSpeed), false}}, 0.0});
  report::PlotPanel loads{"Load of the feet", "force (N)", {}, 0.0};
  report::PlotPanel heights{"Height of the feet", "height (mm)", {}, 0.0};
  for (std::size_t foot = 0; foot < 4; ++foot) {
    const std::size_t column = kFirstFoot + 2 * foot;
    loads.lines.push_back({kFootNames[foot], table.column(column), false});
    heights.lines.push_back({kFootNames[foot], scaled(table.column(column + 1), 1e3), false});
  }
  plot.panels.push_back(loads);
  plot.panels.push_back(heights);
  plot.panels.push_back({"Largest torque of a motor as a share of its limit",
                         "share",
                         {{"torque", table.column(kTorque), false}},
                         0.0});
  plot.panels.push_back({"Tilt of the body",
                         "angle (mrad)",
                         {{"tilt", scaled(table.column(kTilt), 1e3), false}},
                         0.0});
  return plot;
}

bool trot_claim_holds(const TrotPlan& plan, const TrotRun& run) {
  const TrotFigures& f = run.figures;
  const bool kept = !run.fault && f.kept() && f.beyond_in_part < 10.0 && f.speed <= 1.0;
  const bool walked = f.steps == plan.steps() && std::fabs(f.way - plan.way) < 0.02 &&
                      std::fabs(f.aside) < 0.02 && f.end_speed < 0.02;
  const bool upright = f.tilt < 0.1 && f.height < 0.03 && f.away < 0.08;
  return kept && walked && upright;
}

}  // namespace treeline::experiments
