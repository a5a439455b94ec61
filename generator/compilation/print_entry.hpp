#pragma once

#include <string>
#include <vector>

#include "generation/generate_code.hpp"

namespace treeline {

/// Prints a source file that is compiled with a generated folder in C++. It gives each function the
/// C symbol `entry_symbol`, a function that takes pointers to its inputs and outputs. The file
/// compiles only if the folder's header declares the functions with the shapes of the programs.
/// Composed functions, which have no source of their own, are left out.
std::string print_entry(const std::string& name, const std::vector<GeneratedFunction>& functions);

/// Prints the same for a folder in C, whose compiler knows arrays by their first elements only: it
/// compiles if the header declares the functions with as many arguments.
std::string print_c_entry(const std::string& name, const std::vector<GeneratedFunction>& functions);

/// Prints the source file with the entry of limited_control_torque, from NAME_limited.hpp or, where
/// `supported` is a batch function, NAME_batch_limited.hpp; `supported` has the arguments that it
/// takes. With `is_safe` from that of `profile: misra`.
std::string print_limited_entry(const std::string& name, const GeneratedFunction& supported);

/// Prints the entry of limited_control_torque in C. It includes limited_control_torque.c itself.
std::string print_c_limited_entry(const std::string& name, const GeneratedFunction& supported);

/// Prints the source file with the entry of a composed function, from NAME_damped.hpp.
std::string print_composed_entry(const std::string& name, const GeneratedFunction& generated);

/// Stem of the source with the entry of limited_control_torque, and the name of the entry.
std::string limited_stem(bool batch);

/// C symbol of a function's entry.
std::string entry_symbol(const std::string& function);

/// C symbol of the entry that takes the function's own arrays. For a batch function these hold all
/// states, whereas `entry_symbol` takes one state and fills in the others.
std::string raw_entry_symbol(const GeneratedFunction& generated);

}  // namespace treeline
