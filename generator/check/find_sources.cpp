#include <algorithm>
#include <array>

#include "check/check.hpp"
#include "compilation/run_commands.hpp"
#include "emission/backend.hpp"
#include "emission/write_files.hpp"

namespace treeline {
namespace {

namespace fs = std::filesystem;

bool refuse_fast_math(const std::string& flags, Diagnostics& diagnostics) {
  constexpr std::array kRefused = {"-ffast-math", "-Ofast", "-funsafe-math-optimizations",
                                   "-fassociative-math", "-freciprocal-math"};
  for (const std::string& flag : split_words(flags)) {
    if (std::find(kRefused.begin(), kRefused.end(), flag) == kRefused.end()) continue;
    diagnostics.add({Severity::error, "", 0, flag,
                     "generated code relies on the order of its operations",
                     "Leave this flag out, here and where the code is used."});
    return true;
  }
  return false;
}

/// Whether the folder exists and contains the robot's header. C++ output has a header for C too.
bool has_header(const fs::path& folder, const Scene& scene, Diagnostics& diagnostics) {
  const fs::path of_cpp = folder / (scene.name + std::string(backend_of(Language::cpp).header));
  if (scene.language == Language::c && fs::exists(of_cpp)) {
    diagnostics.add({Severity::error, folder, 0, "", "its code is C++, and C is asked for",
                     "name another folder, or take --language c++"});
    return false;
  }
  const fs::path header = folder / (scene.name + std::string(backend_of(scene.language).header));
  if (fs::exists(header)) return true;
  diagnostics.add({Severity::error, header, 0, "", "there is no such file",
                   "Name a folder that `treeline generate` has written for this scene."});
  return false;
}

}  // namespace

bool asks_contraction(const std::string& flags) {
  bool contracted = true;
  for (const std::string& flag : split_words(flags)) {
    if (flag.starts_with("-ffp-contract=")) contracted = flag != "-ffp-contract=off";
  }
  return contracted;
}

std::optional<fs::path> find_sources(const Scene& scene, const Generation& generation,
                                     const CheckOptions& options, const fs::path& work,
                                     Diagnostics& diagnostics) {
  if (refuse_fast_math(options.compile.flags, diagnostics)) return std::nullopt;
  if (!options.folder.empty()) {
    if (!has_header(options.folder, scene, diagnostics)) return std::nullopt;
    return options.folder;
  }
  const fs::path sources = work / scene.name;
  if (!write_files(sources, generation.files, diagnostics)) return std::nullopt;
  return sources;
}

}  // namespace treeline
