#include <gtest/gtest.h>

#include "mechanism/build_mechanism.hpp"
#include "mechanism/find_limbs.hpp"
#include "passes/count_operations.hpp"
#include "passes/passes.hpp"
#include "recursion/read_robots.hpp"
#include "recursion/routes/trace_function.hpp"

// Would catch: traces of limbs that become different because a constant or sign vanishes in one of
// them, or because a pass treats one limb differently. The results are tested together with all
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

/// Share of operations in lanes, for the arms, which have 14 of the humanoid's 24 joints.
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
