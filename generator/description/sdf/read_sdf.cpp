#include "description/sdf/read_sdf.hpp"

#include <dlfcn.h>

#include <filesystem>
#include <system_error>
#include <utility>

#include "description/parse_xml.hpp"
#include "text/read_text_file.hpp"

namespace treeline {
namespace {

namespace fs = std::filesystem;

/// The module, beside the program where it is installed or built; empty: it is not there.
fs::path find_module() {
  std::error_code ignored;
  const fs::path folder = fs::read_symlink("/proc/self/exe", ignored).parent_path();
  for (const char* way : {TREELINE_MODULES_FROM_PROGRAM, "../../lib/treeline"}) {
    const fs::path module = folder / way / "treeline_sdf.so";
    if (fs::exists(module, ignored)) return module;
  }
  return {};
}

void report(const std::string& file, std::string fault, const char* remedy,
            Diagnostics& diagnostics) {
  diagnostics.add({Severity::error, file, 1, "sdf", std::move(fault), remedy});
}

SdfReader* load_reader(const std::string& file, Diagnostics& diagnostics) {
  const fs::path module = find_module();
  if (module.empty()) {
#if defined(TREELINE_READS_SDF)
    report(file, "this is SDF, and the module that reads it, treeline_sdf.so, is not there",
           "install the package treeline-sdf (Debian 12), or export a URDF", diagnostics);
#else
    report(file, "this is SDF, which this program was built without",
           "install libsdformat-dev (Debian 12) and build again, or export a URDF", diagnostics);
#endif
    return nullptr;
  }
  void* const loaded = dlopen(module.c_str(), RTLD_NOW | RTLD_LOCAL);
  void* const reader = loaded == nullptr ? nullptr : dlsym(loaded, kSdfReader);
  if (reader == nullptr) {
    const char* why = dlerror();  // NOLINT(concurrency-mt-unsafe): one thread reads files
    report(file, std::string("this is SDF, and its reader cannot be loaded: ") + why,
           "install libsdformat12 (Debian 12)", diagnostics);
  }
  return reinterpret_cast<SdfReader*>(reader);
}

}  // namespace

std::optional<FlatModel> read_sdf(const std::string& text, const std::string& path,
                                  Diagnostics& diagnostics) {
  const std::string shown = shown_path(path);
  auto mended = well_formed_xml(text, shown, diagnostics);
  SdfReader* const read = mended ? load_reader(shown, diagnostics) : nullptr;
  if (read == nullptr) return std::nullopt;
  std::optional<FlatModel> model;
  read({std::move(*mended), path, shown}, model, diagnostics);
  return model;
}

}  // namespace treeline
