#include "generation/note_left_out.hpp"

#include <fmt/format.h>

#include "emission/c/hides_header.hpp"

namespace treeline {

void note_left_out(const Scene& scene, Diagnostics& diagnostics) {
  if (scene.language != Language::cpp || !c::hides_header(scene.name)) return;
  diagnostics.add(
      {Severity::note, scene.file, 0, "name",
       fmt::format("no header for C is written: {0}.h would hide C's own <{0}.h>", scene.name),
       "Choose another name in the scene (key `name`) or with --name, if C is to call the "
       "functions."});
}

}  // namespace treeline
