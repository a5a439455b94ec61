#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "emission/emission_context.hpp"
#include "emission/syntax.hpp"

namespace treeline {

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

}  // namespace treeline
