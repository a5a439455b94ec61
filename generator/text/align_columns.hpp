#pragma once

#include <string>
#include <vector>

namespace treeline {

/// Largest width of a report, in columns of text.
inline constexpr std::size_t kPageColumns = 100;

/// One column of a table: its head, and whether its cells are aligned on the right.
struct Column {
  std::string head;
  bool right = false;
};

/// Prints a table: head and rows as lines of text, indented by two, with two spaces between
/// columns. Columns whose cells are all empty are left out. Width counts code points of UTF-8. If
/// lines would be longer than `most` columns (0: no limit), the widest left-aligned cells are
/// broken into several lines.
std::string align_columns(const std::vector<Column>& columns,
                          const std::vector<std::vector<std::string>>& rows, std::size_t most = 0);

}  // namespace treeline
