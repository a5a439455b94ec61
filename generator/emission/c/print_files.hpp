#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "emission/backend.hpp"
#include "emission/contents.hpp"
#include "emission/emission_context.hpp"
#include "emission/generated_file.hpp"
#include "emission/syntax.hpp"
#include "program/program.hpp"
#include "text/diagnostic.hpp"

namespace treeline::c {

/// NAME.h: the conventions, and the declaration of each function below its contract. C++ may
/// include it too.
std::string print_contract(const EmissionContext& context, std::span<const Program> programs);

/// The declaration of each function below its contract.
std::string print_declarations(const EmissionContext& context, std::span<const Program> programs);

/// NAME_joints.h: names and limits of coordinates, velocities and task rows as constant arrays.
std::string print_joints(const EmissionContext& context);

/// lanes.h: types of two, four and eight lanes, as many as the functions have at most.
std::vector<GeneratedFile> print_lane_types(const Contents& contents);

/// NAME_damped.h and damped_control_torque.c, composed of others of the functions. Throws
/// std::logic_error where one of `kDampedFunctions` is not among them.
std::vector<GeneratedFile> print_damped(const Contents& contents);

/// NAME_limited.h and limited_control_torque.c, composed of others of the functions. `context` has
/// `limits`. Throws std::logic_error where a function that is called is missing.
std::vector<GeneratedFile> print_limited(const Contents& contents);

/// NAME_batch_limited.h and batch_limited_control_torque.c: limited control of several states, from
/// their functions.
std::vector<GeneratedFile> print_batch_limited(const Contents& contents);

/// Lists the texts for the holes in the templates of limited control in every language.
std::map<std::string, std::string> list_limit_holes(const EmissionContext& context);

/// NAME_batch.h, and a source for each function: in vectors where the scene asks for lanes, of
/// which they include a header, else in a loop over the states.
std::vector<GeneratedFile> print_batch(const Contents& contents);

/// `void NAME_gravity(const double q[TREELINE_NAME_ARRAY(6)], ...)`: alike in header and source.
std::string print_signature(const EmissionContext& context, const Program& program);

/// Statements that read what the function does not: C has no parameters without names. `suffix` is
/// what stands behind the names of arguments.
std::string print_unread(const Program& program, std::string_view suffix = {});

/// A parameter that is an array of so many elements.
std::string print_array(const EmissionContext& context, const char* qualifier,
                        const std::string& name, int size);

/// The declaration of the program's function, without its contract.
std::string print_declaration(const EmissionContext& context, const Program& program);

/// The source file that defines the program's function.
std::string print_source(const EmissionContext& context, const Program& program);

/// Whether the header NAME.h would hide one of C's own, as `math` does.
bool hides_header(std::string_view name);

/// Reports what a scene asks for and C does not have: in `profile: misra` functions of several
/// states in one call, and a name whose header would stand before one of C's own.
void refuse(const EmissionContext& context, Diagnostics& diagnostics);

/// Reports a robot whose header NAME.h would stand before one of C's own.
void refuse_hidden_header(const EmissionContext& context, Diagnostics& diagnostics);

/// C99, numbers of type double or float.
Syntax make_syntax(const EmissionContext& context);

/// How functions of several states are written in vectors.
Syntax make_states_syntax(const EmissionContext& context);

/// C99, freestanding: the robot's name before every name that others see, arrays by pointers with
/// their sizes, lanes as vectors of GCC and Clang.
Backend make_backend();

/// Statements around a call for one of many states, whose numbers stand in rows of them.
struct OneState {
  std::string arrays;     ///< declarations of the state's arguments and results
  std::string before;     ///< copies of what is read to these
  std::string behind;     ///< copies of results to the rows
  std::string arguments;  ///< of the call
};

/// Which arguments a call has: all, or those alone that the function reads.
enum class Passed { all, read };

/// The rows of many states.
struct Rows {
  std::string element;  ///< element i of an argument, a format of its name: `{}_rows[(i * 8) + k]`
  std::string_view counter;  ///< type of i
};

/// Prints what stands around a call of the program's function for the state k in rows: a call on
/// arrays of its own, since functions of one state take neighbouring elements.
OneState print_one_state(const EmissionContext& context, const Program& program, const Rows& rows,
                         Passed passed);

}  // namespace treeline::c
