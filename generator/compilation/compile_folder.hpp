#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "compilation/run_commands.hpp"
#include "generation/generate_code.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// A source that is compiled and linked with a folder's.
struct WorkSource {
  std::string stem, text;
};

struct CompileOptions {
  /// Added to the language's standard and a library's flags. For GCC extra passes are added.
  std::string flags = "-O2 -ffp-contract=off";
  std::string long_flags = {};          ///< for long functions (`is_long`); empty: the same flags
  Optimize optimize = Optimize::speed;  ///< of the scene: which functions are to be small code
  int jobs = 0;                         ///< 0: as many as there are cores
  std::function<void(int, int)> progress = {};  ///< receives number of sources done and of all
  std::string compiler = {};                    ///< empty: see `find_compiler`
  Language language = Language::cpp;            ///< of the sources
  std::vector<WorkSource> more = {};            ///< see `WorkSource`
  /// Stems of further sources of the folder, such as those of a controller.
  std::vector<std::string> stems = {};
};

/// Properties of one compiled function.
struct CompiledFunction {
  double seconds = 0;
  bool is_long = false;            ///< compiled with `CompileOptions::long_flags`
  bool is_small = false;           ///< compiled to small code, as `CompileOptions::optimize` says
  std::optional<int> code_bytes;   ///< of the function and what it calls; absent without `nm`
  std::optional<int> stack_bytes;  ///< with its callees; absent if the compiler does not state it
};

struct Compilation {
  std::filesystem::path library;
  std::string command;             ///< compiler and flags
  std::string long_command = {};   ///< for long functions; empty: no long ones, or the same
  std::string small_command = {};  ///< for functions that are small code; empty: there is none
  double seconds = 0;              ///< until linked, with `jobs` files at a time
  long peak_kib = 0;               ///< of the largest compiler process
  std::map<std::string, CompiledFunction> functions;
};

/// Returns the command of the compiler that `options` name, else $CXX, both split into words as a
/// shell would do, else c++ or g++, whichever starts. For C: else $CC, the compiler of C beside
/// $CXX, cc or gcc. Errors: the compiler does not start.
std::optional<Command> find_compiler(const CompileOptions& options,
                                     const std::filesystem::path& work, Diagnostics& diagnostics);

/// Returns the compiler of C that belongs to one of C++: `arm-none-eabi-g++` has
/// `arm-none-eabi-gcc`. Empty where the name does not tell.
std::string c_compiler_beside(const std::string& cpp_compiler);

/// Compiles the sources of a generated folder with a C entry for each function, and links a shared
/// library. GCC makes the passes that the emitted CMakeLists.txt asks of it. Everything is written
/// to `work`, which must exist and be empty. Errors: no compiler; a source that does not compile,
/// with the first lines of the compiler's output.
std::optional<Compilation> compile_folder(const std::filesystem::path& folder,
                                          const std::string& name,
                                          const std::vector<GeneratedFunction>& functions,
                                          CompileOptions options, const std::filesystem::path& work,
                                          Diagnostics& diagnostics);

/// Bytes of the numbers and tables beside a function's code; absent without `size`. The folder that
/// was compiled in must still be there.
std::optional<int> measure_constants(const Compilation& compilation, const std::string& stem);

/// Adds up the bytes of code in the output of `nm -S`: the sizes of all symbols in the text
/// section.
std::optional<int> add_code_bytes(const std::string& nm_output);
/// Adds up the bytes of constants in the output of `size -A`: the sections that are only read.
std::optional<int> add_constant_bytes(const std::string& size_output);
/// Adds up the bytes of stack of all functions in a `.su` file of -fstack-usage.
std::optional<int> add_stack_bytes(const std::string& stack_usage);

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

/// Prints a source file in C++ with the entries of `print_entry` for a folder in OpenCL C. Each
/// runs a kernel for several states, of which it is given one. The driver of a device compiles the
/// folder, when `treeline_check_fault` is called: it returns what went wrong, else null.
std::string print_opencl_entry(const std::filesystem::path& folder, const std::string& name,
                               const std::vector<GeneratedFunction>& functions);

/// The value of an environment variable; empty where it is blank or not set.
std::string environment_value(const char* variable);

}  // namespace treeline
