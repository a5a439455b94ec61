#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "board/board_report.hpp"
#include "board/cross_compile.hpp"

namespace treeline {

/// Bytes in an object file by kind of section.
struct SectionBytes {
  int text = 0, constants = 0, variables = 0;
};

/// Adds up the sections that `size -A` lists.
SectionBytes add_sections(std::string_view listing);

/// Whether a symbol belongs to the compiler's own arithmetic: libgcc, for what the processor has no
/// instruction for.
bool is_arithmetic(const std::string& symbol);

/// Symbols that `nm -u` lists.
std::vector<std::string> list_undefined(std::string_view listing);

/// Measures the compiled functions: code, stack, symbols. `cycles` of each is the mean of its
/// instructions. `name` is the namespace, or the prefix in C.
std::vector<BoardFunction> measure_objects(const BoardObjects& objects, const std::string& name,
                                           const std::vector<GeneratedFunction>& functions,
                                           const Target& target, const Tools& tools);

/// Measures a function that consists of the objects from index `first` on to `last`: the
/// controller's step, the self-test.
BoardFunction measure_unit(const BoardObjects& objects, const std::string& symbol,
                           std::size_t first, std::size_t last, const Target& target,
                           const Tools& tools);

}  // namespace treeline
