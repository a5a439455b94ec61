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

/// Which numbers of the points' errors, position over rotation vector in world axes, are of a row
/// of the task: of points whose rows have their own axes, those of parts that have all three rows.
template <std::size_t points, class Rows, class LocalAxes>
constexpr std::array<std::array<bool, 6>, points> compared_rows(const Rows& rows,
                                                                const LocalAxes& local_axes) {
  std::array<std::array<bool, 6>, points> has{};
  for (const auto& row : rows) {
    has[static_cast<std::size_t>(row.point)][static_cast<std::size_t>(row.axis)] = true;
  }
  for (std::size_t k = 0; k < points; ++k) {
    for (std::size_t i = 0; i < 6 && local_axes[k]; i += 3) {
      const bool whole = has[k][i] && has[k][i + 1] && has[k][i + 2];
      has[k][i] = has[k][i + 1] = has[k][i + 2] = whole;
    }
  }
  return has;
}

/// How far a point is from its reference, m or rad: the largest number of its error that counts.
constexpr double away_of(const double (&error)[6], const std::array<bool, 6>& counts) noexcept {
  double most = 0.0;
  for (std::size_t i = 0; i < 6; ++i) {
    const double size = error[i] < 0.0 ? -error[i] : error[i];
    if (counts[i] && !(size <= most)) most = size;  // NaN too
  }
  return most;
}

/// How many operational points the task of F has.
template <class F>
inline constexpr int kTaskPoints = task_rows_of<F>().back().point + 1;

}  // namespace treeline::servo
