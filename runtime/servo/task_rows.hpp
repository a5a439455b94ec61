#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace treeline::servo {

/// Which direction of which operational point a row of the task is.
struct TaskRow {
  int point = 0;
  int axis = 0;  ///< in x y z rx ry rz
};

/// Reads the rows of a generated NAME_joints.hpp: kTaskRowNames, such as "tool x".
template <std::size_t rows>
constexpr std::array<TaskRow, rows> task_rows(const char* const (&names)[rows]) {
  constexpr std::string_view kAxes[] = {"x", "y", "z", "rx", "ry", "rz"};
  std::array<TaskRow, rows> read{};
  std::string_view last;
  int point = -1;
  for (std::size_t row = 0; row < rows; ++row) {
    const std::string_view name = names[row];
    const std::size_t space = name.rfind(' ');
    if (row == 0 || name.substr(0, space) != last) ++point;
    last = name.substr(0, space);
    read[row].point = point;
    for (int axis = 0; axis < 6; ++axis) {
      if (name.substr(space + 1) == kAxes[axis]) read[row].axis = axis;
    }
  }
  return read;
}

/// The rows of the task of F, a struct as for RobotFunctions: those of its kTaskRowNames, else all
/// six of each point.
template <class F>
constexpr std::array<TaskRow, static_cast<std::size_t>(F::kTaskRows)> task_rows_of() {
  if constexpr (requires { F::kTaskRowNames; }) {
    return task_rows(F::kTaskRowNames);
  } else {
    static_assert(F::kTaskRows % 6 == 0, "name the rows: kTaskRowNames");
    std::array<TaskRow, static_cast<std::size_t>(F::kTaskRows)> rows{};
    for (int row = 0; row < F::kTaskRows; ++row) {
      rows[static_cast<std::size_t>(row)] = {row / 6, row % 6};
    }
    return rows;
  }
}

/// How many operational points the task of F has.
template <class F>
inline constexpr int kTaskPoints = task_rows_of<F>().back().point + 1;

}  // namespace treeline::servo
