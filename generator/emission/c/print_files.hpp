#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "emission/contents.hpp"
#include "emission/emission_context.hpp"
#include "emission/generated_file.hpp"
#include "program/program.hpp"

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

}  // namespace treeline::c
