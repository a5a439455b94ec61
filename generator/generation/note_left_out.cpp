#include "generation/note_left_out.hpp"

#include <fmt/format.h>

#include <utility>

#include "emission/c/hides_header.hpp"
#include "generation/choose_loops.hpp"

namespace treeline {

void note_left_out(const Scene& scene, Diagnostics& diagnostics) {
  const auto note = [&](const char* key, std::string fault, const char* remedy) {
    diagnostics.add({Severity::note, scene.file, 0, key, std::move(fault), remedy});
  };
  if (scene.language == Language::cpp && c::hides_header(scene.name)) {
    note("name",
         fmt::format("no header for C is written: {0}.h would hide C's own <{0}.h>", scene.name),
         "Choose another name in the scene (key `name`) or with --name, if C is to call the "
         "functions.");
  }
  if (scene.optimize == Optimize::size && !prefers_loops(scene)) {
    note("optimize", "loops over links, the smallest code, are written in `profile: plain` alone",
         "Functions stay straight lines for -Os.");
  }
}

}  // namespace treeline
