#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "description/scene.hpp"
#include "functions/function.hpp"
#include "mechanism/mechanism.hpp"
#include "program/ending.hpp"
#include "program/program.hpp"

namespace treeline {

/// The function for this mechanism as expression graphs: one for every algorithm that computes it,
/// in each of its coordinates, each naming its own in `route`; of long ones that are pruned in
/// the first coordinates these alone. At least one. The caller has seen to it that the scene
/// permits the function (operational points, objects where it needs them). `lanes`: how many values
/// of Real the emitted code may compute together.
std::vector<Program> trace_function(const Mechanism& mechanism, Function function, int lanes = 1);

/// Whether a trace keeps the names of its values, and its sections.
enum class Names { kept, forgotten };

/// Traces the function by this route alone, to be counted, each time that it is
/// called: as the mechanism is then, of which only choices within links may have changed. Names,
/// and sections with them, are kept where `names` says so.
std::function<Program(Names names)> prepare_route(const Mechanism& mechanism, Function function,
                                                  const RouteId& id);

/// The world's z axis in the axes of each operational point, and the height of its origin: four
/// entries for a point, of `q`. The caller gives programs of this header their names.
Program trace_heights(const Mechanism& mechanism, int lanes);

/// What the mechanism is at a pose for impulses at points near its operational points, of `q`:
/// positions and rotations of these, the motion [v; w] that each velocity makes, and the factors
/// of M = L^T D L: of each row of L the entries of the velocities that carry it, in the order of
/// `velocities_before`, and one over D. All places are relative to `origin`: a floating base's, so
/// that no digits are lost far from the world's. The mechanism has no mimic joints.
Program trace_for_impulses(const Mechanism& mechanism, int lanes);

/// Lists, for each velocity, the velocities that carry it, from the root outward.
std::vector<std::vector<int>> velocities_before(const Mechanism& mechanism);

/// Kinetic plus potential energy, of `q` and `qd`.
Program trace_energy(const Mechanism& mechanism, int lanes);

/// Key of the route by loops over a table of links, which `--choices` may name.
inline constexpr const char* kLoopsKey = "loops";

/// Whether the function may have such a form; of some robots it has none.
bool has_loop_form(Function function);

/// The function as a loop over a table of links, for small code; nothing where it has no such form.
/// The graph is the trace of `runtime/emitted/link_functions.h`: it has the operations that the
/// loops execute, in their order, but for products and sums with the constants 0 and 1, which are
/// exact (a zero may have another sign). So what is evaluated, bounded and proven of the graph
/// holds for the loops, as long as no pass changes it. `lines` is the function as straight lines.
/// With `given_sines` it reads sin_q[i] and cos_q[i] of angles; its
/// arguments do not list them.
std::optional<Program> trace_loops(const Mechanism& mechanism, Function function,
                                   const Program& lines, bool given_sines);

/// Functions about the robot or its operational points as one program with the results of all, so
/// that what they share is computed once: each by its first route, on the same tree. At most one of
/// them may depend on inertias, whose arguments (`payload`) would else count twice. The caller
/// gives the program its name and equation.
Program trace_together(const Mechanism& mechanism, std::span<const Function> functions, int lanes);

/// tau = -J_ext^T f_ext alone: the joint forces against the mechanism's external forces, of `q` and
/// `f_ext`, by the inward pass of Newton and Euler without motion and gravity.
Program trace_against_forces(const Mechanism& mechanism, int lanes);

/// The function whose straight lines end with this call: its graph is that of the lines and the
/// operations of the routine as they are written, which emitted code executes.
Program end_lines(Ending ending);

/// `change` of the straight lines of a program, which are all of it if nothing follows.
template <class Change>
Program change_lines(Program program, const Change& change) {
  if (!program.ending) return change(std::move(program));
  Ending ending = *program.ending;
  ending.lines = change(std::move(ending.lines));
  return end_lines(std::move(ending));
}

}  // namespace treeline
