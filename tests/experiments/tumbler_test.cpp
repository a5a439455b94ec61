#include <gtest/gtest.h>

#include "drop.hpp"
#include "strike.hpp"

// Dropped and struck mechanisms: the physical claims. Would catch: energy or momentum that appears
// in a blow or in flight, shapes in the wrong place, and a solver that fails.

namespace treeline::experiments {
namespace {

simulation::Model tumbler() {
  std::string error;
  const auto model =
      load_floating(std::string(TREELINE_ROBOTS_DIR) + "/tumbler/tumbler.urdf", error);
  EXPECT_TRUE(model) << error;
  return model.value();
}

TEST(Tumbler, BouncesAsRestitutionAndFrictionSay) {
  for (const DropRun& run : run_drops(tumbler(), 1.2)) {
    EXPECT_TRUE(drop_claims_hold(run)) << drop_summary(run);
  }
}

// Half the step reduces the integrator's share of the energy error, not that of the blows.
TEST(Tumbler, DriftsLessWithShorterSteps) {
  DropSettings settings;
  settings.duration = 0.8;
  settings.step = 5e-4;
  const double coarse = std::abs(run_drop(tumbler(), settings).drift);
  settings.step = 1.25e-4;
  EXPECT_LT(std::abs(run_drop(tumbler(), settings).drift), 0.1 * coarse);
}

TEST(Tumbler, TakesUpABlowAtAnyLink) {
  const StrikeRun run = run_strikes(tumbler(), 1, 0.5);
  ASSERT_EQ(run.links.size(), 9U);
  EXPECT_TRUE(strike_claims_hold(run)) << strike_summary(run);
}

}  // namespace
}  // namespace treeline::experiments
