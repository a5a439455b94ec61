#pragma once

#include <string>
#include <vector>

namespace treeline {

/// Reports keep within this.
inline constexpr std::size_t kPageColumns = 100;

/// One column of a table: its head, and whether its cells line up on the right.
struct Column {
  std::string head;
  bool right = false;
};

/// The head and the rows as lines of text, indented by two, two spaces between columns. A column
/// whose cells are all empty is left out. Width counts code points of UTF-8. Where lines would be
/// longer than `most` columns (0: never), the widest cells that line up on the left are broken into
/// several lines.
std::string align_columns(const std::vector<Column>& columns,
                          const std::vector<std::vector<std::string>>& rows, std::size_t most = 0);

}  // namespace treeline
