#pragma once

#include <string>
#include <vector>

#include "generation/generate_code.hpp"

namespace treeline {

/// A source file that is compiled with a generated folder and gives each function the C symbol
/// `entry_symbol`, which takes pointers to its inputs and to its outputs. It compiles only when the
/// folder's header declares the functions with the programs' shapes.
/// Functions that are composed of others, and have no source of their own, are left out.
std::string print_entry(const std::string& name, const std::vector<GeneratedFunction>& functions);

/// The same for one that is composed, from NAME_damped.hpp.
std::string print_composed_entry(const std::string& name, const GeneratedFunction& generated);

/// The C symbol of a function.
std::string entry_symbol(const std::string& function);

/// The C symbol that takes the function's own arrays: of a batch those of all states, where
/// `entry_symbol` takes one state's and fills the others.
std::string raw_entry_symbol(const GeneratedFunction& generated);

}  // namespace treeline
