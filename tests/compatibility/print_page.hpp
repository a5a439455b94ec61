#pragma once

#include <string>
#include <vector>

#include "compatibility/measure_row.hpp"

namespace treeline::tests {

/// Prints the columns that are the same on every machine: `| fetch | fixed | 8 | 11 of 11 | 1234 |
/// ...`.
std::string print_counts(const CompatibilityRow& row);

/// Prints the whole page.
std::string print_page(const std::vector<CompatibilityRow>& rows);

}  // namespace treeline::tests
