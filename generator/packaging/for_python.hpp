#pragma once

#include <string>
#include <vector>

#include "description/scene.hpp"
#include "generation/generate_code.hpp"
#include "packaging/describe_package.hpp"
#include "packaging/make_package.hpp"

namespace treeline {

/// Files that pip needs beside the code: a package that compiles it as an extension of Python.
std::vector<PackageFolder> for_python(PackageFacts facts, const Scene& scene,
                                      const Generation& generation);

}  // namespace treeline
