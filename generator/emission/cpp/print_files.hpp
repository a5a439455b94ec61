#pragma once

#include <span>
#include <string>
#include <vector>

#include "emission/contents.hpp"
#include "emission/emission_context.hpp"
#include "emission/generated_file.hpp"
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

}  // namespace treeline::cpp
