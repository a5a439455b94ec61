// Writes the compatibility page: compatibility_report FILE. Exit status: 0 written, 1 not written,
// 2 usage.
#include <fmt/core.h>

#include <cstdio>
#include <exception>
#include <fstream>

#include "compatibility/print_page.hpp"

namespace {

using namespace treeline::tests;  // NOLINT: a program, not a header

int write_page(const char* path) {
  std::vector<CompatibilityRow> rows;
  for (const CompatibilityCase& of : compatibility_cases()) {
    rows.push_back(measure_row(of, true));
    fmt::print(stderr, "{} {:.1f} s\n", print_counts(rows.back()), rows.back().seconds);
  }
  std::ofstream file(path);
  file << print_page(rows);
  return file.flush().good() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: compatibility_report FILE\n");
    return 2;
  }
  try {
    return write_page(argv[1]);
  } catch (const std::exception& error) {
    fmt::print(stderr, "compatibility_report: {}\n", error.what());
    return 1;
  }
}
