#pragma once

#include <string>

#include "program/program.hpp"

namespace treeline {

/// What `print` makes of each argument (which is "const ") and each result (which is ""), with
/// commas between.
template <class Print>
std::string join_arguments(const Program& program, Print print) {
  std::string list;
  const auto append = [&](const std::string& one) { list += (list.empty() ? "" : ", ") + one; };
  for (const Argument& argument : program.arguments) append(print(argument, "const "));
  for (const Result& result : program.results) append(print(result.argument, ""));
  return list;
}

}  // namespace treeline
