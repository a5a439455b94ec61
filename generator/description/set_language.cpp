#include "description/set_language.hpp"

namespace treeline {

void set_language(Language language, Scene& scene) {
  scene.language = language;
  if (!scene.asks_for_lanes) scene.lanes = language == Language::c ? 1 : Scene().lanes;
}

}  // namespace treeline
