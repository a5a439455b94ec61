#pragma once

#include <string>

#include "command_line/limit_figures.hpp"
#include "report/plot.hpp"
#include "report/table.hpp"
#include "servo/safety.hpp"
#include "trot_plan.hpp"

/// ANYmal C stands, trots in place, and walks ahead on diagonal pairs of feet, over a ground that
/// only pushes. Its base has no motor. Torques and forces stay within their limits in every cycle.
namespace treeline::experiments {

struct TrotFigures : LimitFigures {
  int steps = 0;                ///< in which both swinging feet had left the ground
  double speed = 0.0;           ///< largest speed of a joint as a share of its limit
  double tilt = 0.0;            ///< largest angle of the body with the ground, rad
  double height = 0.0;          ///< largest distance of the body from its height, m
  double away = 0.0;            ///< largest distance of the body from its path along the ground, m
  double swing_error = 0.0;     ///< largest distance of a swinging foot from its path, m
  double beyond_in_part = 0.0;  ///< most by which a foot held in part is beyond its cone, N
  double torque_step = 0.0;     ///< largest change of a torque between two cycles, N m
  double slipped = 0.0;         ///< way that feet slid along the ground, all together, m
  double way = 0.0;             ///< of the body from the first step to the end, m
  double aside = 0.0;           ///< of the body in the end, m
  double end_speed = 0.0;       ///< of joints and body in the end, rad/s or m/s
};

struct TrotRun {
  report::Table table;
  TrotFigures figures;
  servo::Fault fault;
};

TrotRun run_trot(const TrotPlan& plan);
std::string trot_summary(const TrotPlan& plan, const TrotRun& run);
/// The table of the page.
std::string trot_page_table(const TrotRun& run);
report::Plot trot_figure(const TrotRun& run);
bool trot_claim_holds(const TrotPlan& plan, const TrotRun& run);

}  // namespace treeline::experiments
