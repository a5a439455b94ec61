#pragma once

#include <array>
#include <vector>

#include "functions/function.hpp"
#include "mechanism/mechanism.hpp"
#include "program/program.hpp"

namespace treeline {

/// How many entries an argument has for this mechanism.
int size_of(IndexSpace space, const Mechanism& mechanism);

/// Entries of the arguments of a function; empty where it does not take the quantity.
class TracedInputs {
 public:
  /// Adds the arguments of the function to a program that is being traced, but for those of no
  /// size.
  TracedInputs(const Mechanism& mechanism, Function function, Program& program);

  [[nodiscard]] const std::vector<Expression>& operator[](Quantity quantity) const {
    return entries_[static_cast<std::size_t>(quantity)];
  }

 private:
  std::array<std::vector<Expression>, kQuantities.size()> entries_;
};

}  // namespace treeline
