#pragma once

#include <array>
#include <string>
#include <vector>

#include "functions/function.hpp"
#include "mechanism/mechanism.hpp"
#include "program/program.hpp"
#include "recursion/tree/model_inputs.hpp"

namespace treeline {

/// The unit of a quantity in this mechanism: of joint quantities only what its joints have, "rad"
/// where none of them slides.
std::string unit_of(Quantity quantity, const Mechanism& mechanism);

/// How many entries an argument has for this mechanism.
int size_of(IndexSpace space, const Mechanism& mechanism);

/// Entries of the arguments of a function; empty where it does not take the quantity.
class TracedInputs {
 public:
  /// Adds the arguments of the function to a program that is being traced, but for those of no
  /// size.
  TracedInputs(const Mechanism& mechanism, Function function, Program& program);

  /// No entries of anything.
  TracedInputs() = default;

  /// Removes the quantity, as if the function did not take it.
  void drop(Quantity quantity) { entries_[static_cast<std::size_t>(quantity)].clear(); }

  [[nodiscard]] const std::vector<Expression>& operator[](Quantity quantity) const {
    return entries_[static_cast<std::size_t>(quantity)];
  }

 private:
  std::array<std::vector<Expression>, kQuantities.size()> entries_;
};

/// Makes the constant tree that of the robot which the arguments say. What the function does not
/// take is as in the files.
void apply_inputs(const Mechanism& mechanism, const TracedInputs& inputs, Tree<Expression>& tree);

/// The tree that traces of the function work with, for what depends on its structure alone.
/// `scratch` is to be thrown away; its graph must be open.
Tree<Expression> structure_of(const Mechanism& mechanism, Function function, Program& scratch);

}  // namespace treeline
