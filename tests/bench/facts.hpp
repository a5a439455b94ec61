#pragma once

#include <string>

#include "subject.hpp"

namespace treeline::bench {

/// Properties of a generated function that are known without running it; zeros if a file is
/// missing.
struct Facts {
  std::string method;
  long flops = 0;  ///< + - * /, sine and cosine not counted
  long divisions = 0, sin_cos = 0;
  long code_bytes = 0, stack_bytes = 0;
  double compile_seconds = 0, compile_mib = 0;
};

/// Cost of compiling all functions of a subject: sum of the times, maximum of the memory.
struct Compilation {
  int functions = 0;
  long code_bytes = 0;
  double seconds = 0, peak_mib = 0;
  double generation_seconds = 0, generation_mib = 0;  ///< of the code of this and its fellows
};

/// Reads the facts from the manifest and from the file of the compile meter.
Facts read_facts(const Subject& subject, const std::string& function);
Compilation read_compilation(const Subject& subject);

}  // namespace treeline::bench
