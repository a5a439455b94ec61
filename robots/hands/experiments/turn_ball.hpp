#pragma once

#include <string>
#include <vector>

#include "ball_plan.hpp"
#include "report/plot.hpp"
#include "report/table.hpp"
#include "servo/safety.hpp"

/// Fingers of a published hand, each of fewer than six joints, turn a ball and lead it around by
/// their tips, which roll on it. Simulated tips and ball only push each other, with friction.
namespace treeline::experiments {

struct BallFigures {
  // What the controller commands, of all cycles.
  double ball_torque = 0.0;     ///< largest entry of tau at the ball, which has no motor
  double torque = 0.0;          ///< largest torque of a motor as a share of its limit
  double least_pressure = 1e9;  ///< of a fingertip, N
  double friction = 0.0;        ///< largest share of the tangential in the normal force
  // What becomes of hand and ball, of all cycles.
  double least_felt = 1e9;       ///< pressure of a fingertip, N
  double friction_felt = 0.0;    ///< as above
  double slipped = 0.0;          ///< way that tips slipped on the ball, all together, m
  double rolled = 0.0;           ///< largest way of a contact on the ball from where it began, m
  double speed = 0.0;            ///< largest speed of a joint as a share of its limit
  double away = 0.0;             ///< largest distance of the ball from its path, m
  double turned_away = 0.0;      ///< largest angle, rad
  double end_away = 0.0;         ///< in the end, m
  double end_turned_away = 0.0;  ///< rad
};

struct BallRun {
  std::string hand;  ///< its name, for readers
  BallPlan plan;
  int fingers = 0;
  double friction = 0.0;  ///< of the simulated fingertips
  report::Table table;
  BallFigures figures;
  servo::Fault fault;
  std::string fault_text;  ///< the fault in words
};

/// Thumb, index and middle finger of an Allegro hand.
BallPlan plan_of_allegro();
BallRun turn_ball_by_allegro(const BallPlan& plan);
/// All five fingers of a Shadow hand, which reach less far.
BallPlan plan_of_shadow();
BallRun turn_ball_by_shadow(const BallPlan& plan);

std::string ball_summary(const BallRun& run);
/// The table of the page, with a column for each run.
std::string ball_page_table(const std::vector<BallRun>& runs);
report::Plot ball_figure(const BallRun& run);
bool ball_claim_holds(const BallRun& run);

}  // namespace treeline::experiments
