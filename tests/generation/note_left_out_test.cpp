#include "generation/note_left_out.hpp"

#include <gtest/gtest.h>

// Would catch: a header for C that a scene has reason to expect and that is left out without a
// word, and words where nothing is left out.
namespace treeline {
namespace {

std::vector<std::string> keys_of(const Scene& scene) {
  Diagnostics diagnostics;
  note_left_out(scene, diagnostics);
  std::vector<std::string> keys;
  for (const Diagnostic& diagnostic : diagnostics.list()) {
    EXPECT_EQ(diagnostic.severity, Severity::note);
    EXPECT_FALSE(diagnostic.remedy.empty());
    keys.push_back(diagnostic.element);
  }
  return keys;
}

TEST(NoteLeftOut, SaysWhatIsMissing) {
  using Keys = std::vector<std::string>;
  Scene scene;
  scene.name = "arm";
  EXPECT_EQ(keys_of(scene), Keys{});
  scene.name = "math";
  EXPECT_EQ(keys_of(scene), Keys{"name"});
  scene.language = Language::c;
  EXPECT_EQ(keys_of(scene), Keys{});
}

}  // namespace
}  // namespace treeline
