#pragma once

#include <string>

#include "command_line/limit_figures.hpp"
#include "report/plot.hpp"
#include "report/table.hpp"
#include "servo/safety.hpp"

/// The humanoid stands on two feet that can tip, shifts its weight, reaches far, and is pushed at
/// its chest from behind, from before and from the side. Torques and forces of the feet are kept
/// within their limits, so that it recovers. With the unlimited law it falls.
namespace treeline::experiments {

struct PushFigures : LimitFigures {
  double tilt = 0.0;         ///< largest angle of the soles with the ground, rad
  double lifted = 0.0;       ///< largest height of a corner of a sole, m
  double slipped = 0.0;      ///< way that corners slid, all together, m
  double least_share = 1.0;  ///< least and largest share of the load on the left foot, unpushed
  double most_share = 0.0;
  double hand_error = 0.0;   ///< largest distance of the hand from its path before the pushes, m
  double hand_pushed = 0.0;  ///< the same from then on
  double away = 0.0;         ///< largest way of the centre of mass from where it was, pushed, m
  double end_away = 0.0;     ///< in the end: the same,
  double end_speed = 0.0;    ///< and the fastest joint, rad/s
};

struct PushRun {
  report::Table table;  ///< one row per millisecond
  PushFigures figures;
  servo::Fault fault;  ///< of the servo loop, which stops at any limit of a joint
};

/// When the first push begins, s.
inline constexpr double kFirstPush = 13.0;

/// Simulates 23 s at 1 kHz through the servo loop, or until a fault; `within_limits` false: by the
/// unlimited law.
PushRun run_push(bool within_limits);

std::string push_summary(const PushRun& limited, const PushRun& unlimited);
/// The table of the page.
std::string push_page_table(const PushRun& limited, const PushRun& unlimited);
report::Plot push_figure(const PushRun& limited, const PushRun& unlimited);

/// Whether the claim holds. Within limits no fault stops the loop, the base has no torque at all,
/// no motor is beyond its limit, every cycle's program is solved, and its forces are within all
/// cones, none of them widened. The load of a foot goes from less than 40 to more than 60 % by
/// leaning; the hand stays within 0.1 mm of its path, pushed within 5 mm. Pushes move the centre of
/// mass by more than 5 cm, soles neither tilt by 0.01 rad nor lift by 3 mm nor slide by 2 cm, and
/// in the end the body is at rest where it began, to 5 mm. By the unlimited law soles tip by more
/// than 0.05 rad and a motor is asked for more than it has.
bool push_claim_holds(const PushRun& limited, const PushRun& unlimited);

}  // namespace treeline::experiments
