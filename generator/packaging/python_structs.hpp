#pragma once

#include <string>
#include <vector>

#include "description/scene.hpp"
#include "generation/generate_code.hpp"
#include "packaging/describe_package.hpp"
#include "program/program.hpp"

namespace treeline {

/// A function of C that takes structs, as the extension's table of functions has it.
struct StructCall {
  std::string name;    ///< in Python, behind `_`: `step`
  std::string call;    ///< the statement of C; `in` and `out` are arrays of pointers
  std::string result;  ///< type of several results
  int inputs = 0, outputs = 0;
  int kept = -1;          ///< the argument that it writes to
  std::string arguments;  ///< entries of the table
  int operations = 0;
};

/// The class of several results, as Python's checkers of types see it.
std::string print_result_class(const std::string& type, const std::vector<Result>& results);

/// What a package for Python has beside functions of numbers: the controller, and control within
/// limits, with their structs as objects. Empty where the scene has neither.
struct PythonStructs {
  std::vector<StructCall> calls;
  std::string header;    ///< extension/structs.h
  std::string module;    ///< structs.py
  std::string imports;   ///< of __init__: what of structs.py the package has too
  std::string exported;  ///< the names of that, with commas
  std::string types;     ///< for __init__.pyi: the results of limited control
  std::string includes;  ///< of functions.h
  std::string inputs;    ///< numbers that arguments have, more than those of functions
};

PythonStructs make_python_structs(const PackageFacts& facts, const Scene& scene,
                                  const Generation& generation);

}  // namespace treeline
