#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "check/run_commands.hpp"
#include "description/diagnostic.hpp"
#include "generation/generate_code.hpp"

namespace treeline {

struct CompileOptions {
  std::string flags = "-O2 -ffp-contract=off";  ///< beside -std=c++17 and what a library needs
  std::string long_flags = {};  ///< of functions that are long (`is_long`); empty: the same
  int jobs = 0;                 ///< 0: as many as there are cores
  std::function<void(int, int)> progress = {};  ///< how many sources are compiled, of how many
  std::string compiler = {};                    ///< empty: $CXX, else c++, else g++
};

/// What the compiler made of one function's source.
struct CompiledFunction {
  double seconds = 0;
  bool is_long = false;            ///< compiled with `CompileOptions::long_flags`
  std::optional<int> code_bytes;   ///< of the function and what it calls; absent without `nm`
  std::optional<int> stack_bytes;  ///< likewise; absent when the compiler does not tell
};

struct Compilation {
  std::filesystem::path library;
  std::string command;            ///< compiler and flags
  std::string long_command = {};  ///< of long functions; empty: there is none or it is the same
  double seconds = 0;             ///< from start to linked, as many files at a time as jobs
  long peak_kib = 0;              ///< of the largest compiler process
  std::map<std::string, CompiledFunction> functions;
};

/// The compiler asked for, else $CXX, their words as a shell would split them, else c++ or g++,
/// whichever starts. Errors: it does not.
std::optional<Command> find_compiler(const std::string& asked_for,
                                     const std::filesystem::path& work, Diagnostics& diagnostics);

/// Compiles the sources of a generated folder with a C entry to each function and links a shared
/// library, all in `work`, which exists and is empty.
/// Errors: no compiler, a source that does not compile, with the compiler's first words.
std::optional<Compilation> compile_folder(const std::filesystem::path& folder,
                                          const std::string& name,
                                          const std::vector<GeneratedFunction>& functions,
                                          const CompileOptions& options,
                                          const std::filesystem::path& work,
                                          Diagnostics& diagnostics);

/// Bytes of code in the output of `nm -S`: the sizes of all symbols of the text section.
std::optional<int> add_code_bytes(const std::string& nm_output);
/// Bytes of stack in a `.su` file of -fstack-usage, those of all its functions together.
std::optional<int> add_stack_bytes(const std::string& stack_usage);

}  // namespace treeline
