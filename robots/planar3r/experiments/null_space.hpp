#pragma once

#include <string>

#include "report/plot.hpp"
#include "report/table.hpp"

/// Chang section 2.4, fig. 2.4 and 2.5: a 3R planar arm holds its tip by operational forces, while
/// the gradient of an attractive potential, projected onto the null space, makes it swing without
/// damping. The runs differ only in the generalised inverse of the projection.
namespace treeline::experiments {

/// Generalised inverse J^# in N = 1 - J^# J.
enum class Inverse {
  pseudo,              ///< J^T (J J^T)^-1
  dynamic_consistent,  ///< M^-1 J^T Lambda
};

/// Largest values over a run.
struct NullSpaceFigures {
  double tip_motion = 0.0;    ///< distance of the tip from its desired place, m
  double joint_motion = 0.0;  ///< of the joint that swings most, rad
  double coupling = 0.0;      ///< acceleration of the tip by the null-space torque, m/s^2
};

/// A run of 4 s.
struct NullSpaceRun {
  report::Table table;  ///< time, tip x, y, distance, coupling, q1 to q3
  NullSpaceFigures figures;
};

NullSpaceRun run_null_space(Inverse inverse);

/// Describes both runs in words.
std::string null_space_summary(const NullSpaceRun& pseudo, const NullSpaceRun& consistent);

/// Draws both figures, one above the other.
report::Plot null_space_figure(const NullSpaceRun& pseudo, const NullSpaceRun& consistent);

/// Whether the physical claim holds: with the dynamically consistent inverse the tip stays within
/// 1e-9 m, with the pseudo-inverse it moves by more than 1 cm, and the arm swings in both runs.
bool null_space_claim_holds(const NullSpaceRun& pseudo, const NullSpaceRun& consistent);

}  // namespace treeline::experiments
