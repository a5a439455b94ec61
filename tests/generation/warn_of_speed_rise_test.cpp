#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "emission/controller_unit.hpp"
#include "generation/warnings.hpp"

// Would catch: a speed_rise of the scene that is overridden without a word, and words where it is
// emitted as asked for or was not asked for.

namespace treeline {
namespace {

std::vector<Diagnostic> warnings(double asked, double emitted, int line = 7) {
  Scene scene;
  scene.controller = SceneController{};
  scene.controller->speed_rise = asked;
  scene.controller->speed_rise_line = line;
  ControllerUnit unit;
  unit.settings.speed_rise = emitted;
  Generation generation;
  generation.controller = std::make_shared<const ControllerUnit>(unit);
  Diagnostics diagnostics;
  warn_of_speed_rise(scene, generation, diagnostics);
  return diagnostics.list();
}

TEST(WarnOfSpeedRise, TellsWhatWasAskedForAndWhatIsEmitted) {
  const auto told = warnings(0.02, 0.43);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0].severity, Severity::warning);
  EXPECT_EQ(told[0].element, "controller/speed_rise");
  EXPECT_EQ(told[0].line, 7);
  EXPECT_NE(told[0].fault.find("0.02 s is asked for, and 0.43 s is emitted"), std::string::npos);
  EXPECT_NE(told[0].remedy.find("speed_rise: 0.43"), std::string::npos);
}

TEST(WarnOfSpeedRise, IsSilentWhereNothingWasOverridden) {
  EXPECT_TRUE(warnings(0.5, 0.5).empty());
  EXPECT_TRUE(warnings(SceneController{}.speed_rise, 0.43, 0).empty()) << "nobody asked";
  EXPECT_FALSE(warnings(SceneController{}.speed_rise, 0.43).empty()) << "the default by name";
}

}  // namespace
}  // namespace treeline
