#include <gtest/gtest.h>

#include "mechanism/build_mechanism.hpp"
#include "mechanism/find_limbs.hpp"
#include "passes/count_operations.hpp"
#include "passes/run_passes.hpp"
#include "recursion/read_robots.hpp"
#include "recursion/trace_function.hpp"

// Would catch: traces of limbs that come apart, by a constant that vanishes in one of them, a sign,
// or a pass that treats one limb otherwise. That they compute the right thing is tested with all
// other routes, see CheckedPrograms.
namespace treeline::tests {
namespace {

const RobotInScene& humanoid() {
  static const RobotInScene found = [] {
    for (RobotInScene& robot : read_robots()) {
      if (robot.name.find("humanoid24") != std::string::npos && robot.scene.objects.empty() &&
          robot.scene.operational_points.size() == 2 && robot.scene.base == Base::fixed) {
        return robot;
      }
    }
    throw std::logic_error("no humanoid");
  }();
  return found;
}

/// Of the operations of the arms, 14 of the humanoid's 24 joints, how many are in lanes.
double share_in_lanes(Function function) {
  Mechanism mechanism = reduced_mechanism(humanoid().robot, humanoid().scene);
  mechanism.limbs = find_limbs(mechanism, 2);
  std::vector<PassReport> log;
  const Program program = reduce_operations(trace_function(mechanism, function, 2)[0], log);
  return 2.0 * static_cast<double>(program.packs.size()) / count_operations(program).flops();
}

TEST(Limbs, ArmsOfTheHumanoidRunInLanes) {
  EXPECT_GT(share_in_lanes(Function::inverse_dynamics), 0.65);
  EXPECT_GT(share_in_lanes(Function::mass_matrix), 0.75);
  EXPECT_GT(share_in_lanes(Function::forward_dynamics), 0.4);
}

}  // namespace
}  // namespace treeline::tests
