#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "emission/emission_context.hpp"
#include "emission/syntax.hpp"
#include "program/program.hpp"

namespace treeline {

/// Texts of every language's contract, by the names of the holes in its template: where the code
/// comes from, the order and units of joints and points, sizes, the range of sine and cosine.
std::map<std::string, std::string> describe_contract(const EmissionContext& context);

/// Joints, points, gravity and the range of rounding bounds: what holds for all functions, without
/// the marks of a comment.
std::string describe_conventions(const EmissionContext& context);

/// The contract of one function, without the marks of a comment.
std::string describe_function(const EmissionContext& context, const Program& program);

/// Names of the sources that a program with the controller's step compiles.
std::vector<std::string> list_controller_sources(Language language, const ControllerUnit& unit);

/// Bytes that a step is estimated to keep on the stack: what it knows of the measured state, the
/// law's own numbers, and the values of the function that keeps most.
std::size_t count_step_stack(const ControllerUnit& unit, bool misra, int bytes_of_number);

/// Equations of the laws that the controller has, by command.
std::string describe_laws(const ControllerUnit& unit);

/// Operations of the functions that a step calls.
std::string describe_step_cost(const ControllerUnit& unit);

/// Joints and points with the numbers that commands call them by.
std::string list_joint_names(const ControllerUnit& unit);

/// Files that a program with the controller compiles.
std::string describe_files(const EmissionContext& context, const ControllerUnit& unit);

/// The stack of a step, and what measures it; see `count_step_stack`.
std::string describe_step_stack(const ControllerUnit& unit, bool misra, int bytes_of_number);

/// One of the functions that `damped_control_torque` calls, and where its result goes.
struct DampedCall {
  const Program* program = nullptr;
  std::string result;
};

/// In the order of the calls. Throws std::logic_error where one of `kDampedFunctions` is not among
/// `programs`.
std::vector<DampedCall> list_damped_calls(std::span<const Program> programs);

/// Name of an argument of one of these functions in `damped_control_torque`.
std::string damped_name(const Argument& argument);

/// Arguments of `damped_control_torque`, in the order of `control_torque`: q, its sines and
/// cosines, qd, qdd_0, xdd_cmd, f_ext, and what of the robot is an argument.
std::vector<Argument> list_damped_arguments(const std::vector<DampedCall>& calls, int task_rows);

/// Cost, stack and rounding, as every function of the contract states them.
std::string describe_damped_cost(const EmissionContext& context, std::span<const Program> programs);

/// The limits of effective mass with commas between.
std::string list_effective_mass_limits(const EmissionContext& context, const Syntax& syntax);

/// A function that `limited_control_torque` calls, and the array that takes its result.
struct LimitedCall {
  const Program* program;
  const char* result;
};

/// `supported_control_torque`. Throws std::logic_error where it is not among the programs.
const Program& find_supported(std::span<const Program> programs);

/// The functions whose results the program of limits needs: M, and J_s and J_t where there are held
/// rows and a task. Throws std::logic_error where one of them is missing.
std::vector<LimitedCall> list_limited_calls(const EmissionContext& context,
                                            std::span<const Program> programs);

/// Whether constraints hold any rows.
bool holds_rows(const EmissionContext& context);

/// Freedoms of torques and internal forces, at least one.
int count_freedoms(const LimitFacts& facts);

/// How far sines and cosines go: rad up to which they are within 0.8 ulp, and up to which they are
/// those of an angle nearby; and what an angle beyond counts as.
struct SineWords {
  const char *accurate, *largest, *beyond;
};

constexpr SineWords describe_sines(bool single_precision, bool misra) {
  return {single_precision ? "4000" : "1e5", single_precision ? "2^20" : "2^32",
          single_precision || misra ? "0" : "a multiple of pi/2"};
}

/// How a language writes the layout of supports whose shares are arguments.
struct ShareWords {
  std::string scope;  ///< of functions
  std::string type, whole;
  bool by_address = false;  ///< arrays are handed on as `&array[0]`
  bool of_batch = false;    ///< for state k of several
};

/// Fills the holes of the layout that a call has: `shares`, the statements in front of it,
/// `own_layout` and `of_layout`. Where nothing comes and goes that is the constant one.
void add_share_holes(const EmissionContext& context, const Program& supported,
                     const ShareWords& words, std::map<std::string, std::string>& holes);

/// Lines for comments: the cost of a call, of one for a batch; the cones.
std::string describe_limited_cost(const EmissionContext& context,
                                  std::span<const Program> programs);
std::string describe_batch_limited_cost(const EmissionContext& context,
                                        std::span<const Program> batch);
std::string describe_cones(const LimitFacts& facts);

/// Initialisers of the structures for limits and for what is constant, without the outer braces.
/// `no_limit` stands for an infinite torque, `no_cones` where there are none.
std::string print_torque_limits(const LimitFacts& facts, const Syntax& syntax,
                                const std::string& no_limit, const std::string& no_cones);
std::string print_support_layout(const LimitFacts& facts, const Syntax& syntax);

/// Names and limits of coordinates, velocities and task rows as lists of literals.
struct JointArrays {
  std::map<std::string, std::string> holes;  ///< by their names in the languages' templates
  std::size_t task_rows = 0;
  std::string task_row_names;
};

/// The largest finite number, which stands for limits that there are not.
double largest_number(bool single_precision);

/// A limit that the URDF does not state is written as `unlimited`.
JointArrays describe_joints(const EmissionContext& context, const Syntax& syntax,
                            const std::string& unlimited);

/// Whether the function reads any element of this argument.
bool reads(const Program& program, const Argument& argument);

/// Names that no local may have: arguments, arrays of angles, and `taken`, what the language's
/// header and file declare.
std::set<std::string> find_taken_names(const Program& program, std::set<std::string> taken);

/// Whether the function has so many operations (12000) that some passes of compilers may take
/// minutes.
bool is_long(const Program& program);

/// Whether the function has so many operations (100000) that compilers take minutes and gigabytes
/// at -O2, or hours where it has several times as many.
bool is_huge(const Program& program);

/// Whether some numbers of the emitted function share registers.
bool uses_lanes(const Program& program);

/// Whether a function has loops: over a table of links, or in a routine with which it ends.
bool has_loops(std::span<const Program> programs);

/// How many functions loop over a table of links.
int count_loops(std::span<const Program> programs);

/// Whether the emitted function needs sine and cosine.
bool uses_trigonometry(const Program& program);

/// "320 flops (170 additions, 150 multiplications, 0 divisions), sine and cosine of 6 angles".
std::string describe_cost(const Program& program);

}  // namespace treeline
