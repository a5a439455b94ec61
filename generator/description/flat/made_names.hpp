#pragma once

#include <set>
#include <string>

#include "text/identifier.hpp"

namespace treeline {

/// Names of a file, and names that a reader makes beside them: these differ from all others as
/// identifiers of emitted code, too, where `a-b`, `a_b` and `a__b` are one name.
class MadeNames {
 public:
  void take(const std::string& name) { taken_.insert(identifier_from(name)); }

  [[nodiscard]] bool has(const std::string& name) const {
    return taken_.contains(identifier_from(name));
  }

  /// `wanted`, else the first of `wanted_2`, `wanted_3` and so on that is not taken; takes it.
  std::string make(const std::string& wanted) {
    std::string name = wanted;
    for (int number = 2; !taken_.insert(identifier_from(name)).second; ++number) {
      name = wanted + "_" + std::to_string(number);
    }
    return name;
  }

 private:
  std::set<std::string> taken_;  ///< identifiers
};

}  // namespace treeline
