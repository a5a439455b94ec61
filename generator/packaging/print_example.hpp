#pragma once

#include <string>

#include "description/scene.hpp"
#include "generation/generate_code.hpp"
#include "packaging/describe_package.hpp"

namespace treeline {

/// A sketch for Arduino that calls the first function and tells how long that takes.
std::string print_example(const Scene& scene, const Generation& generation,
                          const PackageFacts& facts);

}  // namespace treeline
