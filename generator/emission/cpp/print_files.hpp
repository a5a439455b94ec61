#pragma once

#include <set>
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

namespace treeline::cpp {

/// NAME.hpp: the conventions, and the declaration of each function below its contract.
std::string print_contract(const EmissionContext& context, std::span<const Program> programs);

/// NAME_joints.hpp: names and limits of coordinates, velocities and task rows as constexpr arrays.
std::string print_joints(const EmissionContext& context);

/// NAME_calls.hpp: every function with a struct of named inputs, and with std::array.
std::string print_calls(const EmissionContext& context, std::span<const Program> programs);

/// NAME_eigen.hpp: every function for Eigen's fixed-size vectors and row-major matrices.
std::string print_eigen(const EmissionContext& context, std::span<const Program> programs);

/// `NAME_damped.hpp`: `damped_control_torque`, composed of others of the functions. Throws
/// std::logic_error where one of `kDampedFunctions` is not among them.
std::string print_damped(const EmissionContext& context, std::span<const Program> programs);

/// `NAME_limited.hpp`: `limited_control_torque`, composed of others of the functions. `context` has
/// limits. Throws std::logic_error where a function is not among `programs`.
std::string print_limited(const EmissionContext& context, std::span<const Program> programs);

/// `NAME_batch_limited.hpp`: the same for several states, composed of functions of a batch.
std::string print_batch_limited(const EmissionContext& context, std::span<const Program> batch);

/// `NAME_batch.hpp`, which declares the functions for `context.batch` states a call, a source for
/// each, and the headers that these include.
std::vector<GeneratedFile> print_batch(const Contents& contents);

/// A header of runtime/core in the robot's own namespace, so that robots generated at different
/// times live in one program, and in one folder with those that it includes.
std::string print_core_header(const EmissionContext& context, std::string_view header);

/// `void NAME(const Real (&q)[6], Real (&tau)[6]) noexcept;`, as the header declares it.
std::string print_declaration(const Program& program);

/// The source file that defines the program's function.
std::string print_source(const EmissionContext& context, const Program& program);

/// Names that no local may have.
std::set<std::string> find_taken(const EmissionContext& context, const Program& program);

/// C++17, numbers of type Real.
Syntax make_syntax(bool single_precision);
Syntax make_syntax(const EmissionContext& context);

/// Syntax of C++17 for functions of several states at once; their numbers have type `States`.
Syntax make_states_syntax(const EmissionContext& context);

/// C++17: functions in a namespace, arrays by reference, lanes and batches by the headers of
/// runtime/core.
Backend make_backend();

}  // namespace treeline::cpp
