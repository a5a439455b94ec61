#pragma once

#include <string>

#include "servo/plot.hpp"
#include "servo/table.hpp"

/// Chang section 2.4, fig. 2.4 and 2.5: a 3R planar arm holds its tip by operational forces while
/// the gradient of an attractive potential, projected onto the null space, makes it swing without
/// damping. Only the generalised inverse in the projection differs between the runs.
namespace treeline::experiments {

/// J^# in N = 1 - J^# J.
enum class Inverse {
  pseudo,              ///< J^T (J J^T)^-1
  dynamic_consistent,  ///< M^-1 J^T Lambda
};

/// Largest values over a run.
struct NullSpaceFigures {
  double tip_motion = 0.0;    ///< m, away from where the tip was to stay
  double joint_motion = 0.0;  ///< rad, of the joint that swings most
  double coupling = 0.0;      ///< m/s^2, the tip's acceleration by the null-space torque
};

/// One run of 4 s.
struct NullSpaceRun {
  servo::Table table;  ///< time, tip x, y, distance, coupling, q1 to q3
  NullSpaceFigures figures;
};

NullSpaceRun run_null_space(Inverse inverse);

/// Both runs in words.
std::string null_space_summary(const NullSpaceRun& pseudo, const NullSpaceRun& consistent);

/// Both figures, one above the other.
servo::Plot null_space_figure(const NullSpaceRun& pseudo, const NullSpaceRun& consistent);

/// The physical claim: with the dynamically consistent inverse the tip stays within 1e-9 m, with
/// the pseudo-inverse it moves by more than a centimetre, and in both the arm swings.
bool null_space_claim_holds(const NullSpaceRun& pseudo, const NullSpaceRun& consistent);

}  // namespace treeline::experiments
