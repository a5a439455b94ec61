#pragma once

#include <array>
#include <string>
#include <vector>

#include "limbed_robot.hpp"
#include "mechanism/mechanism.hpp"

/// Growth of the number of operations with the size of robots and tasks. The counts are those of
/// traced and canonicalized programs, so they do not depend on machine or compiler.
namespace treeline::growth {

/// See `tests::make_limbed_robot`.
using Shape = tests::LimbedShape;
Mechanism make_robot(const Shape& shape);

/// Ways to compute Lambda^-1. `dense` is J M^-1 J^T by an LDL^T of M without use of zeros, O(n^3).
enum class Way { unit_forces, branching, sparse_factors, dense };
inline constexpr std::array kWays = {Way::unit_forces, Way::branching, Way::sparse_factors,
                                     Way::dense};
const char* name_of(Way way);

/// Number of operations (+ - * /) of Lambda^-1, and of the control torque of Chang table 6.1 with
/// it.
int lambda_inverse_flops(const Mechanism& robot, Way way);
int control_torque_flops(const Mechanism& robot, Way way);
/// Number of operations for the inverse inertias of all links: by the recursion over links, or link
/// by link from M.
int link_inertias_flops(const Mechanism& robot, bool by_recursion);

/// Counts for robots of growing size: a row for each size, a column for each way.
struct Series {
  std::string name;  ///< of the figure and file: "lambda_inverse_over_n"
  std::string size;  ///< what grows: "links n"
  std::vector<int> sizes;
  std::vector<std::string> ways;
  std::vector<std::vector<int>> flops;  ///< by way, then by size
};

/// Counts Lambda^-1, control torque and links' inertias for chains and trees of 4 to 64 links with
/// one or two hands, and for one to eight hands of a tree.
std::vector<Series> count_all();

/// Prints `size,way,way` and a line for each size.
std::string csv_text(const Series& series);

}  // namespace treeline::growth
