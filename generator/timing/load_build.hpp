#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "compilation/compile_folder.hpp"
#include "compilation/generated_library.hpp"

namespace treeline {

/// Flags with which users are advised to compile generated code.
inline constexpr const char* kTimedFlags = "-O3 -march=native";

/// Generated functions that are compiled with one compiler and one set of flags, and loaded.
struct TimedBuild {
  Compilation compilation;
  GeneratedLibrary library;
};

/// Compiles `functions` of the generated `folder` in `work`, which is created if necessary, and
/// loads them. Any number of builds can be loaded side by side, also with equal names. The compiler
/// is $CXX, else c++, else g++. Errors: see `compile_folder` and `GeneratedLibrary::load`.
std::optional<TimedBuild> load_build(const std::filesystem::path& folder, const Scene& scene,
                                     const std::vector<GeneratedFunction>& functions,
                                     const CompileOptions& options,
                                     const std::filesystem::path& work, Diagnostics& diagnostics);

}  // namespace treeline
