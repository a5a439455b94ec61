#pragma once

#include <array>
#include <string>
#include <vector>

#include "report/plot.hpp"
#include "report/table.hpp"
#include "singular_control.hpp"

/// The UR10e's flange moves along straight lines through singular configurations and back, at 1
/// kHz.
namespace treeline::ur10e_experiments {

enum class Line {
  reach,  ///< outward to 2 cm beyond reach: straight elbow at the workspace's border
  wrist,  ///< sideways past joint 5 = 0, 0.01 rad beside the singular orientation
  // To a pose at rest, starting from joint 5 = 0: goals and stiffness of Isaac Lab's tutorial
  // run_osc.py.
  goal_1,
  goal_2,
  goal_3,
};
inline constexpr std::array kLines{Line::reach, Line::wrist, Line::goal_1, Line::goal_2,
                                   Line::goal_3};

/// Largest values over a run, and the error at its end.
struct Figures {
  double torque = 0.0;          ///< of a joint, as a share of its effort limit
  double speed = 0.0;           ///< of a joint, as a share of its speed limit
  double torque_step = 0.0;     ///< between cycles, as a share of the effort limit
  double position_error = 0.0;  ///< m
  double rotation_error = 0.0;  ///< rad
  double final_error = 0.0;     ///< norm of m and rad together
  double ease = 1e300;          ///< smallest eigenvalue on the path, see `core::damped_solve`
  bool lost = false;            ///< a torque exceeded a thousand times its limit, or was not finite
};

struct SingularRun {
  report::Table table;  ///< time, errors, smallest eigenvalue, q, qd, tau; one row per millisecond
  Figures figures;
};

const char* title_of(Line line);
std::string file_name_of(Line line);

SingularRun run_line(Line line, Law law);

/// Prints a line for each run, in the order of kLaws.
std::string summary(Line line, const std::vector<SingularRun>& runs);
/// The runs' rows of the page's table, Markdown, and what heads them.
std::string rows_of(Line line, const std::vector<SingularRun>& runs);
inline constexpr const char* kTableHead =
    "| line | law | torque / limit | speed / limit | position error (m) | rotation error (rad) |\n"
    "|---|---|---|---|---|---|\n";
report::Plot figure(Line line, const std::vector<SingularRun>& runs);

/// Whether the claim holds. Damped by directions, torques and speeds stay within the maker's
/// limits, torques have no step, and the arm passes the singularity and comes back to its start or
/// reaches its goal. Without damping limits are exceeded manifold. Damped least squares is bounded
/// too, but leaves the line farther, because it relaxes all directions.
bool claim_holds(Line line, const std::vector<SingularRun>& runs);

}  // namespace treeline::ur10e_experiments
