// reproducibility_report ROBOTS FILE.csv: compiles four robots in every way that must give the same
// bits, and in ways that may not, compares the results, prints a table and writes a CSV file. Exit
// status: 0 as claimed, 1 something fails, 2 usage, 3 a claim is broken.
#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <fstream>

#include "reproducibility/reproduce.hpp"

namespace {

using namespace treeline;         // NOLINT: a program, not a header
using namespace treeline::tests;  // NOLINT

constexpr int kStates = 300;
constexpr const char* kFused = "-march=native -ffp-contract=fast";

using Rows = std::vector<Difference>;

/// Prints the rows and appends them.
void append(Rows& rows, const Rows& more) {
  const std::string table = print_table(more);
  fmt::print("{}", rows.empty() ? table : table.substr(table.find('\n') + 1));
  std::fflush(stdout);
  rows.insert(rows.end(), more.begin(), more.end());
}

/// The robot's code, and variants in float, with one lane, and with four states per call.
struct Variants {
  Original original, in_float, one_lane, batch;
};

Variants load_variants(const char* robots, const char* name) {
  const auto load = [&](Real real, int lanes, int batch) {
    return load_original(robots, name, kStates, {}, real, lanes, batch);
  };
  return {load(Real::float64, 8, 0), load(Real::float32, 8, 0), load(Real::float64, 1, 0),
          load(Real::float64, 8, 4)};
}

/// Compares builds that must give the graph's bits.
void compare_exact(const Variants& variants, const std::string& compiler, Rows& rows) {
  const std::string for_machine = fmt::format(" {}", separate_for_machine(compiler));
  for (const std::string& machine : {std::string(" -ffp-contract=off"), for_machine}) {
    for (const char* level : {"-O0", "-O1", "-O2", "-O3"}) {
      append(rows, compare_with_graph(variants.original, {compiler, level + machine}));
    }
  }
  for (const Original* other : {&variants.one_lane, &variants.batch}) {
    auto more = compare_with_graph(*other, {compiler, fmt::format("-O3{}", for_machine)});
    for (Difference& row : more) row.robot += other == &variants.batch ? " x4" : " l1";
    append(rows, more);
  }
}

/// Compares builds that may give other bits.
void compare_bounded(const Variants& variants, const std::string& compiler, Rows& rows) {
  const std::string fused = std::string("-O3 ") + kFused;
  append(rows, compare_with_graph(variants.original, {compiler, std::string("-O2 ") + kFused}));
  append(rows, compare_with_graph(variants.original, {compiler, fused}));
  append(rows,
         compare_with_graph(variants.original, {compiler, "-O3 -march=native -ffp-contract=off"}));
  for (const std::string& flags : {std::string("-O3 -ffp-contract=off"), fused}) {
    append(rows, compare_with_double(variants.in_float, variants.original, {compiler, flags}));
  }
  auto lanes = compare_with_graph(variants.original, {compiler, "-O3 -ffp-contract=off"},
                                  &variants.one_lane);
  for (Difference& row : lanes) row.build.flags += " (lanes: 1 against 8)";
  append(rows, lanes);
}

int report(const char* robots, const char* path) {
  Rows exact, bounded;
  for (const char* name : {"puma560", "ur10e", "samm", "humanoid24"}) {
    const Variants variants = load_variants(robots, name);
    for (const char* compiler : {"g++", "clang++"}) {
      if (!has_compiler(compiler)) {
        fmt::print("{}: not here, left out\n", compiler);
        continue;
      }
      compare_exact(variants, compiler, exact);
      compare_bounded(variants, compiler, bounded);
    }
  }
  const bool same = std::all_of(exact.begin(), exact.end(),
                                [](const Difference& row) { return row.bits_differ == 0; });
  const bool near = std::all_of(bounded.begin(), bounded.end(),
                                [](const Difference& row) { return row.bounded(); });
  fmt::print("same bits: {}; within bounds: {}\n", same ? "yes" : "NO", near ? "yes" : "NO");
  exact.insert(exact.end(), bounded.begin(), bounded.end());
  std::ofstream file(path);
  file << print_csv(exact);
  return !file.good() ? 1 : same && near ? 0 : 3;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    fmt::print(stderr, "usage: reproducibility_report ROBOTS FILE\n");
    return 2;
  }
  try {
    return report(argv[1], argv[2]);
  } catch (const std::exception& error) {
    fmt::print(stderr, "reproducibility_report: {}\n", error.what());
    return 1;
  }
}
