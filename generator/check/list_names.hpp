#pragma once

#include <string>
#include <vector>

namespace treeline {

/// Names of the functions of a report of which that holds, with commas.
template <class Function>
std::string list_names(const std::vector<Function>& functions, bool Function::*holds) {
  std::string names;
  for (const Function& f : functions) {
    if (f.*holds) names += (names.empty() ? "" : ", ") + f.name;
  }
  return names;
}

}  // namespace treeline
