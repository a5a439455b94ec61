#pragma once

#include "description/scene.hpp"

namespace treeline {

/// Makes `language` that of the scene's code. C has lanes only through an extension of GCC and
/// Clang: it gets them where the scene asks for lanes, else scalar code.
void set_language(Language language, Scene& scene);

}  // namespace treeline
