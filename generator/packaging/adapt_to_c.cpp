#include "packaging/adapt_to_c.hpp"

#include <fmt/format.h>

#include "description/states_key.hpp"

namespace treeline {

bool is_compiled_from_c(PackageKind kind) {
  return kind == PackageKind::python || kind == PackageKind::fmu;
}

std::string describe(PackageKind kind) {
  return kind == PackageKind::python ? "a package for Python" : "an FMU";
}

void adapt_to_c(PackageKind kind, const std::string& text, Scene& scene, Diagnostics& diagnostics) {
  if (scene.language != Language::c && states_key(text, "language")) {
    diagnostics.add({Severity::note, scene.file, 0, "language",
                     describe(kind) + " is compiled from C, whatever the scene says", ""});
  }
  scene.language = Language::c;
  if (!scene.controller) return;
  scene.controller.reset();
  diagnostics.add(
      {Severity::warning, scene.file, 0, "controller",
       fmt::format("it is left out: it is compiled from C++, and {} from C", describe(kind)),
       fmt::format("Generate it in C++, without --package {}.",
                   kind == PackageKind::python ? "python" : "fmu")});
}

}  // namespace treeline
