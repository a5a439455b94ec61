#include "timing/load_build.hpp"

#include <utility>

namespace treeline {

std::optional<TimedBuild> load_build(const std::filesystem::path& folder, const Scene& scene,
                                     const std::vector<GeneratedFunction>& functions,
                                     const CompileOptions& options,
                                     const std::filesystem::path& work, Diagnostics& diagnostics) {
  std::filesystem::create_directories(work);
  CompileOptions in_language = options;
  in_language.language = scene.language;
  auto compilation = compile_folder(folder, scene.name, functions, in_language, work, diagnostics);
  if (!compilation) return std::nullopt;
  auto library = GeneratedLibrary::load(compilation->library, functions, scene.real, diagnostics);
  if (!library) return std::nullopt;
  return TimedBuild{std::move(*compilation), std::move(*library)};
}

}  // namespace treeline
