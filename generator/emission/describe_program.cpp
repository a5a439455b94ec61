#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <vector>

#include "emission/descriptions.hpp"
#include "passes/count_operations.hpp"
#include "program/ending.hpp"

namespace treeline {
namespace {

bool has_lines(const Program& program, int more_than) {
  return !program.loops && count_operations(printed_lines(program)).flops() > more_than;
}

}  // namespace

bool is_long(const Program& program) {
  constexpr int kLong = 12000;
  return has_lines(program, kLong);
}

bool is_huge(const Program& program) {
  constexpr int kHuge = 100000;
  return has_lines(program, kHuge);
}

bool reads(const Program& program, const Argument& argument) {
  return std::any_of(
      program.graph.inputs().begin(), program.graph.inputs().end(),
      [&](const std::string& input) { return input.starts_with(argument.name + "["); });
}

std::set<std::string> find_taken_names(const Program& program, std::set<std::string> taken) {
  taken.insert(program.name);
  for (const char* array : {"angles", "sines", "cosines"}) {
    taken.insert(array);
    for (int i = 2; i < 100; ++i) {
      taken.insert(array + std::to_string(i));
    }
  }
  for (const Argument& argument : program.arguments) {
    taken.insert(argument.name);
  }
  for (const Result& result : program.results) {
    taken.insert(result.argument.name);
  }
  if (program.ending) {
    taken.insert("work");
    for (const Table& table : program.ending->tables) taken.insert(table.name);
    for (const Result& array : program.ending->lines.results) taken.insert(array.argument.name);
  }
  return taken;
}

bool has_loops(std::span<const Program> programs) {
  return std::any_of(programs.begin(), programs.end(),
                     [](const Program& program) { return program.loops || program.ending; });
}

int count_loops(std::span<const Program> programs) {
  return static_cast<int>(
      std::count_if(programs.begin(), programs.end(),
                    [](const Program& program) { return program.loops != nullptr; }));
}

bool uses_lanes(const Program& program) {
  return !printed_lines(program).packs.empty();
}

bool uses_trigonometry(const Program& program) {
  return count_operations(program).sin_cos > 0;
}

std::string describe_cost(const Program& program) {
  const OperationCount count = count_operations(program);
  std::string text = fmt::format("{} flops (add {}, mul {}, div {})", count.flops(), count.add,
                                 count.mul, count.div);
  if (count.sin_cos > 0) {
    text += fmt::format(", sine and cosine of {} angle{}", count.sin_cos,
                        count.sin_cos == 1 ? "" : "s");
  }
  return text;
}

}  // namespace treeline
