#pragma once

#include <string>

#include "compilation/compile_folder.hpp"

namespace treeline {

/// How the source of one function is compiled.
struct FunctionFlags {
  std::string flags;
  bool is_long = false;   ///< by `CompileOptions::long_flags`
  bool is_small = false;  ///< to small code
};

/// Adds the extra passes that the emitted CMakeLists.txt has GCC make where it optimises.
std::string add_extra_passes(const std::string& flags);

/// Returns the flags for a function. Where the emitted CMakeLists.txt compiles it to small code, so
/// do these flags, however long it is: what is judged is what is delivered.
FunctionFlags choose_flags(const GeneratedFunction& generated, const CompileOptions& options);

}  // namespace treeline
