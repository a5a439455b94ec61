#pragma once

#include <filesystem>
#include <optional>

#include "check/check.hpp"

namespace treeline {

/// Compile options with the sources of the controller, if there is one: to compile with a folder.
CompileOptions with_controller(const Scene& scene, const Generation& generation,
                               CompileOptions options);

/// Runs the controller's step that was compiled into `compilation`, over motions with commands and
/// switches of modes, and compares steps with the same laws in long double, whose dynamics the
/// interpreter computes in 50 digits. What no step may do is looked for in all of them. Returns
/// nothing if the reference cannot be compiled; `diagnostics` says why.
std::optional<StepReport> judge_step(const Robot& robot, const Scene& scene,
                                     const Generation& generation, const CheckOptions& options,
                                     const Compilation& compilation,
                                     const std::filesystem::path& work, Diagnostics& diagnostics);

}  // namespace treeline
