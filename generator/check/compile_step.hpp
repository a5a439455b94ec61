#pragma once

#include <filesystem>
#include <optional>

#include "check/step_library.hpp"
#include "generation/generate_code.hpp"

namespace treeline {

/// Compiles the controller among a folder's sources for this machine without contraction, in
/// `work`, and loads it. `jobs`: cores, 0 for all. Errors: it does not compile.
std::optional<StepLibrary> compile_step(const Scene& scene, const Generation& generation, int jobs,
                                        const std::filesystem::path& sources,
                                        const std::filesystem::path& work,
                                        Diagnostics& diagnostics);

}  // namespace treeline
