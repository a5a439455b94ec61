#pragma once

#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "generation/generate_code.hpp"
#include "packaging/describe_package.hpp"
#include "packaging/package_kind.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// Files that make a Functional Mock-up Unit of FMI 2.0 or 3.0 of the code: its description, the
/// source that wraps `forward_dynamics`, or the step of a controller that has no function beside
/// it, and a project of CMake that packs both.
std::vector<PackageFolder> for_fmu2(PackageFacts facts, const Robot& robot, const Scene& scene,
                                    const Generation& generation);
std::vector<PackageFolder> for_fmu3(PackageFacts facts, const Robot& robot, const Scene& scene,
                                    const Generation& generation);

/// Refuses a scene whose motion `forward_dynamics` of q, qd, tau and external forces does not give:
/// one without that function, with closed loops, or with a model that is passed at run time.
void refuse_for_fmu(const Robot& robot, const Scene& scene, Diagnostics& diagnostics);

}  // namespace treeline
