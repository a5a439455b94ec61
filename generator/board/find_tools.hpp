#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "compilation/run_commands.hpp"
#include "target/target.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// Programs for a target, which start.
struct Tools {
  std::string compiler;          ///< the program, for C++
  std::string c_compiler;        ///< compiler of C
  std::string prefix;            ///< of the names of nm, size and objdump
  std::string compiler_version;  ///< first line that it prints
  Command runner;                ///< takes the program's file as its last argument
};

/// Finds the compiler of a target that has a board, and QEMU unless another runner is given.
/// Errors: a program is missing, with the package of Debian that holds it.
std::optional<Tools> find_tools(const Target& target, const std::string& runner,
                                const std::filesystem::path& work, Diagnostics& diagnostics);

}  // namespace treeline
