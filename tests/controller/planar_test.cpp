// Would catch: a point of which a task has not all three directions, that is blocked and pressed
// for ever without a fault.
#include <gtest/gtest.h>

#include <algorithm>

#include "planar_arm.hpp"
#include "planar_arm_controller.h"

namespace treeline::tests {
namespace {

TEST(PlanarController, FindsABlockedPoint) {
  planar_arm_config config{};
  planar_arm_state state{};
  planar_arm_input input{};
  planar_arm_output output{};
  planar_arm_default_config(&config);
  const double held[] = {0.3, 0.8, 0.6};
  std::copy_n(held, 3, input.q);
  input.command.kind = PLANAR_ARM_START;
  input.command.sequence = 1;
  planar_arm_step(&config, &state, &input, &output);
  double R[9];
  planar_arm::forward_kinematics(input.q, input.command.position, R);
  std::copy_n(R, 9, input.command.rotation);
  input.command.position[0] -= 0.4;
  input.command.duration = 1;
  input.command.kind = PLANAR_ARM_MOVE_POINT;
  ++input.command.sequence;
  int steps = 0;
  for (; steps < 3000 && output.mode == PLANAR_ARM_RUNNING; ++steps) {
    planar_arm_step(&config, &state, &input, &output);
    ASSERT_EQ(output.refused, PLANAR_ARM_ACCEPTED);
  }
  EXPECT_EQ(output.faults, static_cast<unsigned>(PLANAR_ARM_FAULT_FOLLOWING));
  EXPECT_LT(steps, 1500) << "half a second after the reference stood";
}

}  // namespace
}  // namespace treeline::tests
