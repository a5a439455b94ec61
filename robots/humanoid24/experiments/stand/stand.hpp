#pragma once

#include <string>

#include "report/plot.hpp"
#include "report/table.hpp"

/// The humanoid stands on two feet and shifts its weight from one to the other by leaning, while
/// its left hand keeps its place. The base has no motor: nothing but the ground carries it.
namespace treeline::experiments {

struct StandFigures {
  double base_torque = 0.0;  ///< largest entry of tau at the base, N or N m
  double hand_error = 0.0;   ///< largest distance of the hand from its place, m
  double drift = 0.0;        ///< largest way of the feet from where they were put, m or rad
  double least_load = 1e9;   ///< least force with which the ground carries a foot, N
  double least_share = 1.0;  ///< least and largest share of the load on the left foot
  double most_share = 0.0;
  double pressure_x = 0.0;  ///< largest distance of a centre of pressure from its foot's middle, m,
  double pressure_y = 0.0;  ///< forward and sideways
  double friction = 0.0;    ///< largest ratio of horizontal to vertical force
  /// Largest difference between the forces that the controller chose, of both feet together, and
  /// those that the simulated ground had, N.
  double force_error = 0.0;
  bool fault = false;  ///< the servo loop ended the run: a limit of the URDF was exceeded
};

struct StandRun {
  report::Table table;  ///< one row per millisecond
  StandFigures figures;
};

/// Simulates 6 s at 1 kHz on generated code.
StandRun run_stand();

std::string stand_summary(const StandRun& run);
report::Plot stand_figure(const StandRun& run);

/// Whether the claim holds: the base has no torque at all, the hand stays within 0.1 mm, the feet
/// within 1e-9 m and rad; the load of a foot goes from less than 0.4 of the weight to more than
/// 0.58, and stays within the foot's edges and a friction of 0.2; and the ground has the
/// forces that the controller chose.
bool stand_claim_holds(const StandRun& run);

}  // namespace treeline::experiments
