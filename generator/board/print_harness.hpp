#pragma once

#include <string>
#include <vector>

#include "generation/generate_code.hpp"
#include "target/target.hpp"

namespace treeline {

/// Place of one argument among the numbers of a state.
struct StatePlace {
  std::string name;
  int size = 0;
  int at = 0;
};

/// Arguments that the functions take, each once, one behind another.
std::vector<StatePlace> place_arguments(const std::vector<GeneratedFunction>& functions);

/// What the program has beside the functions.
struct HarnessFiles {
  std::string states;                          ///< file with them
  std::string id;                              ///< by which its output is told from that of others
  int count = 0;                               ///< of states
  bool selftest = false;                       ///< whether it calls NAME_selftest
  std::string step_head = {}, step_part = {};  ///< of a controller's steps; empty: it has none
};

/// Header that declares the functions to call, and their namesakes that do nothing.
std::string print_functions_header(const std::string& name,
                                   const std::vector<GeneratedFunction>& functions);
/// Header in C that declares the functions to call, and their namesakes that do nothing.
std::string print_c_functions_header(const std::string& name,
                                     const std::vector<GeneratedFunction>& functions, Real real);
/// Source of the functions that do nothing.
std::string print_empty_functions(const std::vector<GeneratedFunction>& functions);
/// Source of a function that is composed of others in a header.
std::string print_composed_function(const std::string& name, const GeneratedFunction& generated);
/// Source of the program.
std::string print_main(const std::string& name, const std::vector<GeneratedFunction>& functions,
                       const HarnessFiles& files);
/// Source of what starts it on the target's board.
std::string print_start(const Board& board);

/// Number of numbers that a function writes.
int count_outputs(const GeneratedFunction& generated);

}  // namespace treeline
