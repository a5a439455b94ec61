#include <gtest/gtest.h>

#include "choice/choose_loops.hpp"

// Would catch: an estimate of bytes that is that of another processor, and loops that are counted
// twice where functions share them. The bytes are those of g++ 12 -Os: code and constants.
namespace treeline {
namespace {

struct Measured {
  const char* target;
  Real real;
  Function function;
  std::size_t links;
  int flops;  ///< of the straight lines
  double lines, loops;
};

constexpr Measured kMeasured[] = {
    // PUMA 560, iiwa14 and humanoid24
    {"cortex-m4f", Real::float32, Function::inverse_dynamics, 6, 277, 1964, 2424},
    {"cortex-m4f", Real::float32, Function::lambda_inverse, 7, 850, 5000, 4242},
    {"cortex-m4f", Real::float32, Function::control_torque, 7, 1087, 6416, 6508},
    {"cortex-m4f", Real::float32, Function::forward_dynamics, 24, 4538, 33488, 6726},
    {"cortex-m4f", Real::float64, Function::inverse_dynamics, 7, 360, 6796, 4286},
    {"cortex-m7", Real::float64, Function::control_torque, 7, 1160, 9256, 8288},
    {"cortex-m0", Real::float32, Function::mass_matrix, 7, 194, 2580, 3436},
    {"rv32imfc", Real::float32, Function::mass_matrix, 7, 194, 1976, 3384},
    {"rv64gc", Real::float64, Function::lambda_inverse, 6, 566, 4226, 5830},
    {"aarch64", Real::float64, Function::forward_dynamics, 7, 744, 7352, 7724},
    {"generic", Real::float64, Function::inverse_dynamics, 7, 360, 6401, 4950},
    {"generic", Real::float64, Function::control_torque, 7, 1160, 15345, 12185},
    {"x86-64-v3", Real::float64, Function::lambda_inverse, 7, 850, 10367, 7131},
    {"x86-64-v4", Real::float64, Function::control_torque, 7, 1160, 10978, 10603},
};

LinkLoops loops_of(Function function, std::size_t links) {
  LinkLoops loops;
  loops.table.links.resize(links);
  loops.uses_factors = function != Function::inverse_dynamics;
  loops.uses_rows = function == Function::lambda_inverse || function == Function::control_torque;
  return loops;
}

TEST(EstimateCodeSize, IsNearTheBytesMeasured) {
  for (const Measured& each : kMeasured) {
    SCOPED_TRACE(each.target);
    Scene scene;
    scene.target = each.target;
    scene.real = each.real;
    // Operations differ: `CodeSizes` says how far functions are from the mean.
    EXPECT_NEAR(bytes_of_lines(scene, each.flops) / each.lines, 1, 0.3);
    LoopNeeds needs;
    needs.add(each.function, loops_of(each.function, each.links));
    EXPECT_NEAR(needs.bytes(scene) / each.loops, 1, 0.12);
  }
}

TEST(EstimateCodeSize, CountsSharedLoopsOnce) {
  const Scene scene;
  LoopNeeds control;
  control.add(Function::control_torque, loops_of(Function::control_torque, 24));
  LoopNeeds all = control;
  all.add(Function::inverse_dynamics, loops_of(Function::inverse_dynamics, 24));
  all.add(Function::lambda_inverse, loops_of(Function::lambda_inverse, 24));
  EXPECT_EQ(all.bytes(scene), control.bytes(scene));
  all.add(Function::forward_dynamics, loops_of(Function::forward_dynamics, 24));
  EXPECT_GT(all.bytes(scene), control.bytes(scene));
}

}  // namespace
}  // namespace treeline
