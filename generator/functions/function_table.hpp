#pragma once

#include <algorithm>

#include "functions/function.hpp"

namespace treeline {

/// The row of a function in a table that says what a switch over functions would say. Rows have a
/// member `function`. Null if there is none.
template <class Rows>
constexpr auto find_row(const Rows& rows, Function function) -> decltype(rows.data()) {
  const auto found = std::find_if(rows.begin(), rows.end(),
                                  [=](const auto& row) { return row.function == function; });
  return found == rows.end() ? nullptr : &*found;
}

/// Whether the table has one row for each function that satisfies the predicate and none for any
/// other. For a `static_assert` beside the table: a new function then does not compile without its
/// row.
template <bool (*has_row)(const FunctionInfo&), class Rows>
constexpr bool covers(const Rows& rows) {
  return std::all_of(kFunctions.begin(), kFunctions.end(), [&](const FunctionInfo& info) {
    const auto count = std::count_if(
        rows.begin(), rows.end(), [&](const auto& row) { return row.function == info.function; });
    return count == (has_row(info) ? 1 : 0);
  });
}

}  // namespace treeline
