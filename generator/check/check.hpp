#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "check/report.hpp"
#include "compilation/compile_folder.hpp"
#include "oracle/reference.hpp"

namespace treeline {

struct CheckOptions {
  ReferenceOptions references;
  CompileOptions compile;
  /// Folder to compile instead of the code generated now. Empty: none.
  std::filesystem::path folder;
};

/// Compiles the generated code, or `options.folder`, runs it at many states, and compares it with
/// the interpreter in 50 digits and with the expression graph. Returns nothing if the code cannot
/// be compiled or loaded; `diagnostics` says why. A report that has not passed is no diagnostic.
std::optional<CheckReport> check(const Robot& robot, const Scene& scene,
                                 const Generation& generation, const CheckOptions& options,
                                 Diagnostics& diagnostics);

/// Compiles and compares the code as `check` above does, but with references that `make_references`
/// has already made for the same robot and scene.
std::optional<CheckReport> check(const Scene& scene, const Generation& generation,
                                 const std::vector<StateReference>& references,
                                 const CheckOptions& options, Diagnostics& diagnostics);

/// Whether these flags let GCC fuse products and sums: the last one about it does not turn it off.
bool asks_contraction(const std::string& flags);

/// Returns the folder to compile: the given one, or a new one in `work` with the code generated
/// now. Errors: flags that change results, such as -ffast-math; the given folder is of another
/// scene.
std::optional<std::filesystem::path> find_sources(const Scene& scene, const Generation& generation,
                                                  const CheckOptions& options,
                                                  const std::filesystem::path& work,
                                                  Diagnostics& diagnostics);

}  // namespace treeline
