#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "description/scene.hpp"
#include "generation/generate_code.hpp"
#include "packaging/describe_package.hpp"
#include "packaging/package_kinds.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

// What packages share that let another language call the C in them.

/// Notes which parts of the code the package's language does not call. Adds nothing where it calls
/// all, or there is no package.
void note_not_called(const PackageKind* kind, const Scene& scene, Diagnostics& diagnostics);

/// Says in sentences, a line each, which parts of the code the language `caller` does not call.
std::string describe_not_called(const Scene& scene, std::string_view caller);

/// The functions that the caller's language calls: those of one state, and `damped_control_torque`.
std::vector<GeneratedFunction> list_functions(const Generation& generation);

/// The comment on a function in the headers of C, without its marks.
std::string find_comment(const std::vector<GeneratedFile>& files, const std::string& function);

/// An array of the header with names, home and limits.
struct JointArray {
  const char* name;
  bool is_text;
  bool of_velocities;  ///< else of coordinates
  const char* meaning;
};
inline constexpr JointArray kJointArrays[] = {
    {"coordinate_joints", true, false, "Of each entry of q: its joint, and what it measures."},
    {"coordinate_meanings", true, false, "Of each entry of q: its joint, and what it measures."},
    {"home", false, false,
     "A state to begin with: 0, or the limit next to it; quaternions turn nothing."},
    {"lower_limits", false, false, "Limits of each entry of q, rad or m."},
    {"upper_limits", false, false, "Limits of each entry of q, rad or m."},
    {"velocity_joints", true, true,
     "Of each entry of qd, qdd and tau: its joint, and its name with the unit of qd."},
    {"velocity_names", true, true,
     "Of each entry of qd, qdd and tau: its joint, and its name with the unit of qd."},
    {"velocity_limits", false, true,
     "The largest magnitude of each entry of qd, rad/s or m/s, and of tau, N m or N."},
    {"effort_limits", false, true,
     "The largest magnitude of each entry of qd, rad/s or m/s, and of tau, N m or N."}};

/// What other constants are.
inline constexpr const char* kHeaviest =
    "The effective mass (kg; kg m^2 in rows of rotation) beyond which a direction of the task "
    "yields.";
inline constexpr const char* kTaskRowNames =
    "Of each task row: its point, and along or about which axis it is.";

/// Flags of all sources in quotes, with those that select the processor where it is this machine's.
std::string quote_flags(const PackageFacts& facts, const Scene& scene);

}  // namespace treeline
