#include "check/compile_step.hpp"

#include "check/judge_step.hpp"
#include "compilation/compile_folder.hpp"

namespace treeline {

std::optional<StepLibrary> compile_step(const Scene& scene, const Generation& generation, int jobs,
                                        const std::filesystem::path& sources,
                                        const std::filesystem::path& work,
                                        Diagnostics& diagnostics) {
  const std::filesystem::path place = work / "host";
  std::filesystem::create_directory(place);
  CompileOptions compile = with_controller(scene, generation, CompileOptions());
  compile.jobs = jobs;
  compile.language = scene.language;
  const auto compiled = compile_folder(sources, scene.name, {}, compile, place, diagnostics);
  if (!compiled) return std::nullopt;
  return StepLibrary::load(compiled->library, diagnostics);
}

}  // namespace treeline
