#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "emission/adapt.hpp"
#include "emission/contents.hpp"
#include "emission/controller_unit.hpp"
#include "emission/emission_context.hpp"
#include "emission/generated_file.hpp"
#include "emission/ground_unit.hpp"
#include "emission/keep_named.hpp"
#include "emission/list_sources.hpp"
#include "program/program.hpp"

namespace treeline {

/// The statements of a function that loops over a table of links: constants, work space, a call.
std::string print_loop_body(const EmissionContext& context, const Program& program);

/// NAME_links, the tables of links, and link_functions, the loops over them: the headers
/// `runtime/emitted/link_*.h` as one, with what the functions need.
std::vector<GeneratedFile> print_loops(const Contents& contents);

/// Whether a function takes sines and cosines of joints' angles.
bool takes_sines(const Program& program);

/// How code outside of the loops over links names what is in them.
Adaptation name_loops(const EmissionContext& context);

/// The headers `runtime/emitted/link_*.h` as one, of which each function of a folder names some.
std::string adapt_loops(const Contents& contents, std::span<const NameSet> named);

/// Stem of the source that defines the step on the ground.
inline constexpr const char* kGroundStem = "ground";

/// The most points of a robot that count at once: four of each group, sixteen of all.
int count_ground_contacts(const GroundUnit& unit);

/// `NAME_ground.h`, for C99 and C++17; the source `ground`, which defines the step, with its
/// headers; and a source for each function that it calls.
std::vector<GeneratedFile> print_ground(const Contents& contents);

/// Sizes that runtime/emitted/ground_robot.h lists, and how many entries a factor has.
std::string print_ground_sizes(const GroundUnit& unit, const Adaptation& own);

/// Tables of the step on the ground: what of the robot may touch it, and which velocities move
/// that.
std::string print_ground_tables(const EmissionContext& context, const GroundUnit& unit);

/// The body of a function whose straight lines end with a routine, see `Ending`: tables and locals
/// before the lines, the call behind them. Bodies of other functions are their lines.
std::string add_ending(const EmissionContext& context, const Program& program,
                       const std::string& lines);

/// The line that includes the header of the routine; empty for other functions.
std::string print_ending_include(const EmissionContext& context, const Program& program);

/// The headers that the routines need, and whether a function has one.
std::vector<GeneratedFile> print_ending_headers(const Contents& contents);
bool wants_endings(const Contents& contents);

/// Stem of the source.
inline constexpr const char* kSelftestStem = "selftest";

/// NAME_selftest.h and the source that calls the functions, of the context's numbers for it.
std::vector<GeneratedFile> print_selftest(const Contents& contents);

/// Constants and types that NAME_limited.h declares: sizes, outcomes, limits. In C++ they stand in
/// torque_limits.hpp.
std::string print_limit_types(const EmissionContext& context);

/// The headers of runtime/emitted that limited control includes, but square_root.h, with those of a
/// robot's sizes. `context` has `limits`.
std::vector<GeneratedFile> print_limit_headers(const EmissionContext& context);

/// The headers of runtime/emitted that damped control includes, but square_root.h, with its sizes:
/// damped_solve.h, symmetric_eigen.h, ldlt.h and damped_sizes.h, in C++ with endings of C++.
std::vector<GeneratedFile> print_damped_headers(const EmissionContext& context);

/// sin_cos.h: sine and cosine of one angle, and of several; for `profile: misra` without bits of
/// numbers, and then in C++ sin_cos.hpp too.
GeneratedFile print_sin_cos(const EmissionContext& context);

/// The header sin_cos.hpp of the runtime, for lanes of any number type, with the steps of
/// runtime/emitted in place of its includes. Throws std::out_of_range where one is missing.
std::string print_sines_in_lanes();

/// Sines by pointers, as headers of runtime/emitted take them, where a language has them by
/// references.
inline constexpr std::string_view kSinesByPointers =
    "TL_INLINE void tl_sin_cos_of(real x, real* sine, real* cosine) {\n"
    "  sin_cos(x, *sine, *cosine);\n}\n";

/// square_root.h, in C++ square_root.hpp, which includes that of sines. For `profile: misra` it is
/// Heron's steps, whose last digit integers decide, and includes nothing.
GeneratedFile print_square_root(const EmissionContext& context);

/// The header STEM_functions: declares functions that only an add-on calls, whose contract is
/// NAME_STEM.h. `what` says who calls them: "the controller".
std::string print_own_functions(const EmissionContext& context,
                                const std::vector<const Program*>& programs,
                                const std::string& stem, const std::string& what);

/// The source of one of them, which includes that header.
std::string print_own_source(const EmissionContext& context, const Program& program,
                             const std::string& stem);

/// The call of one of them, or of another function of the robot, in a hole of a body. `arguments`
/// are written, with commas between.
std::string print_own_call(const EmissionContext& context, const Program& program,
                           const std::string& arguments);

/// Stem of the source that defines NAME_id.
inline constexpr const char* kIdentityStem = "id";

/// SHA-256 of what `LC_ALL=C sha256sum` prints of the files in order of their names: of all but the
/// manifest and the source of NAME_id, which have this digest in them.
std::string digest_of_files(const std::vector<GeneratedFile>& files);

/// Elements of NAME_id, with the zero at its end.
std::size_t size_of_identity(const EmissionContext& context);

/// The source that defines NAME_id: the generator's version, the robot's name, and the digest of
/// the other files.
GeneratedFile print_identity(const EmissionContext& context,
                             const std::vector<GeneratedFile>& files);

/// CMakeLists.txt, which builds the folder as part of another project. GCC makes extra passes where
/// it optimises, but for long functions.
std::string print_project(const EmissionContext& context, const std::vector<Source>& sources);

/// Stem of the source of a controller's step.
inline constexpr const char* kControllerStem = "controller";

/// `NAME_controller.h`, for C99 and C++17; the source `controller`, which defines the step, with
/// its headers; and a source for each function that it calls.
std::vector<GeneratedFile> print_controller(const Contents& contents);

/// The step in C++, in numbers of a type `Real` that another header has, for references.
std::vector<GeneratedFile> print_reference_laws(const EmissionContext& context,
                                                const ControllerUnit& unit);

/// How the headers of a controller are written for a robot. For a reference their numbers are of a
/// type `Real`.
Adaptation adapt_controller(const EmissionContext& context, const ControllerUnit& unit,
                            bool for_reference);

/// Prints NAME_controller.h: the contract of the controller's step, its types and its functions.
std::string print_controller_header(const EmissionContext& context, const ControllerUnit& unit);

/// Text for the holes of a template, by name.
using Holes = std::map<std::string, std::string>;

/// Adds the numbers of an emitted controller: the configuration's defaults in the order of its
/// members, which joints turn without end, and which rows of the points it controls.
void add_controller_numbers(const EmissionContext& context, const ControllerUnit& unit,
                            Holes& holes);

}  // namespace treeline
