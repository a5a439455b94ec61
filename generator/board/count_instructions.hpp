#pragma once

#include <string_view>

#include "target/target.hpp"

namespace treeline {

/// Kinds of instructions whose cycles differ.
enum class InstructionKind {
  other,
  memory,
  branch,
  arithmetic,
  fused,
  divide_float,
  divide_double
};

/// Kind of an instruction of Arm or RISC-V, as objdump prints it.
InstructionKind kind_of_instruction(std::string_view mnemonic, std::string_view operands);

/// Number of registers that an instruction loads or stores: those between braces, at least 1.
int count_registers(std::string_view operands);

/// Mean cycles of the instructions in objdump's listing; 1 if there are none.
double mean_cycles(std::string_view listing, const CycleCosts& costs);

}  // namespace treeline
