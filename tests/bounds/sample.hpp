#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "bounds/domain.hpp"
#include "program/program.hpp"

namespace treeline::tests {

inline constexpr double kUnit = 0x1p-53;

/// A program of a few operations, on a domain.
struct Sample {
  Program program;
  Domain domain;

  std::vector<Expression> argument(const std::string& name, int size, double largest) {
    program.arguments.push_back({name, size, 1, ""});
    domain.sizes[name].assign(static_cast<std::size_t>(size), largest);
    std::vector<Expression> entries;
    for (int i = 0; i < size; ++i) {
      entries.push_back(program.graph.input(fmt::format("{}[{}]", name, i)));
    }
    return entries;
  }
  void result(std::vector<Expression> values) {
    const int size = static_cast<int>(values.size());
    program.results.push_back({{"r", size, 1, ""}, std::move(values)});
  }
};

}  // namespace treeline::tests
