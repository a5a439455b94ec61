#pragma once

#include <string>
#include <vector>

#include "text/terminal_columns.hpp"

namespace treeline {

/// One column of a table.
struct Column {
  std::string head;
  bool right = false;  ///< cells are aligned on the right, and not broken
  bool whole = false;  ///< cells are not broken
};

/// Prints a table: head and rows as lines of text, indented by two, with two spaces between
/// columns. Columns whose cells are all empty are left out. Width counts code points of UTF-8. If
/// lines would be longer than `most` columns (0: no limit), the widest left-aligned cells are
/// broken into several lines; where that does not help, the table is divided into several, each
/// with the first column.
std::string align_columns(const std::vector<Column>& columns,
                          const std::vector<std::vector<std::string>>& rows,
                          std::size_t most = terminal_columns());

}  // namespace treeline
