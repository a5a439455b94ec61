#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace treeline {

/// Width of the terminal that tables have to fit; 0, any, before `fit_to_terminal`, and where
/// nobody reads on a terminal.
std::size_t terminal_columns();

/// Width of a report's text: 100 columns, or those of the terminal if it has fewer.
std::size_t page_columns();

/// Measures the terminal that standard output is, if it is one.
void fit_to_terminal();

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

/// Width of the text in code points of UTF-8.
std::size_t width_of(const std::string& text);

/// Breaks the text into lines of at most `columns` columns: after spaces, else after the characters
/// that join the parts of a name (`_ - / .`), else anywhere. All lines have the indentation of the
/// first.
std::vector<std::string> wrap_cell(const std::string& text, std::size_t columns);

/// Prints `label` followed by the text, broken at spaces to `columns` columns in total. Lines after
/// the first begin below the text.
std::string wrap_labelled(const std::string& label, const std::string& text, std::size_t columns);

}  // namespace treeline
