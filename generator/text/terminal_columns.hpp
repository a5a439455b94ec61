#pragma once

#include <cstddef>

namespace treeline {

/// Width of the terminal that tables have to fit; 0, any, before `fit_to_terminal`, and where
/// nobody reads on a terminal.
std::size_t terminal_columns();

/// Width of a report's text: 100 columns, or those of the terminal if it has fewer.
std::size_t page_columns();

/// Measures the terminal that standard output is, if it is one.
void fit_to_terminal();

}  // namespace treeline
