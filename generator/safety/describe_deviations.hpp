#pragma once

#include <string>

#include "description/scene.hpp"

namespace treeline {

/// Lists the rules of MISRA C:2012 or MISRA C++:2023 from which the code of the scene's language
/// and profile deviates, why, and how that is known, as Markdown.
std::string describe_deviations(const Scene& scene);

}  // namespace treeline
