#include "program/ending.hpp"

#include <algorithm>

namespace treeline {

bool is_only_read(const Ending& ending, const Result& array) {
  return std::none_of(ending.results.begin(), ending.results.end(),
                      [&](const Argument& result) { return result.name == array.argument.name; });
}

const Program& printed_lines(const Program& program) {
  return program.ending ? program.ending->lines : program;
}

}  // namespace treeline
