#pragma once

#include <map>
#include <string>

#include "emission/emission_context.hpp"
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

}  // namespace treeline
