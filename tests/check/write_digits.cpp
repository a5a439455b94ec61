// Writes the table of remaining digits: write_digits ROBOTS FILE. Exit status: 0 written, 1 not
// written, 2 usage.
#include <fmt/core.h>

#include <chrono>
#include <cstdio>
#include <exception>
#include <fstream>

#include "check/digits.hpp"

namespace {

using namespace treeline::tests;  // NOLINT: a program, not a header

int write_table(const char* robots, const char* path) {
  std::vector<DigitsLeft> rows;
  for (const DigitsSubject& subject : list_subjects(robots)) {
    const auto start = std::chrono::steady_clock::now();
    const auto own = measure_digits(subject);
    rows.insert(rows.end(), own.begin(), own.end());
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    fmt::print(stderr, "{:<28} {:>2} functions {:6.1f} s\n", subject.name, own.size(),
               taken.count());
  }
  std::ofstream file(path);
  file << print_digits(rows);
  return file.good() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    fmt::print(stderr, "usage: write_digits ROBOTS FILE\n");
    return 2;
  }
  try {
    return write_table(argv[1], argv[2]);
  } catch (const std::exception& error) {
    fmt::print(stderr, "write_digits: {}\n", error.what());
    return 1;
  }
}
