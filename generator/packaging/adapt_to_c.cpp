#include "packaging/adapt_to_c.hpp"

#include "description/states_key.hpp"

namespace treeline {

void adapt_to_c(const PackageKind& kind, const std::string& text, Scene& scene,
                Diagnostics& diagnostics) {
  if (scene.language != Language::c && states_key(text, "language")) {
    diagnostics.add({Severity::note, scene.file, 0, "language",
                     std::string(kind.of_c) + " is compiled from C, whatever the scene says", ""});
  }
  scene.language = Language::c;
  if (!scene.controller || !kind.is_unit || scene.functions.empty()) return;
  scene.controller.reset();
  diagnostics.add(
      {Severity::warning, scene.file, 0, "controller",
       "it is left out: an FMU is that of the robot where the scene has functions",
       "For one of the controller write functions: []. Or generate it in C, without --package " +
           std::string(kind.option) + "."});
}

}  // namespace treeline
