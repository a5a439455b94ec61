#include <gtest/gtest.h>

#include "passes/passes.hpp"
#include "passes/two_link_arm.hpp"
#include "program/evaluate.hpp"

// Would catch: operations of one limb that are taken for those of another, lanes in another order
// than the limbs, and operations in lanes that belong to no limb.
namespace treeline {
namespace {

Expression limb_constant_of(std::uint32_t slot, std::uint32_t limb, std::uint32_t limbs,
                            double value) {
  return {Graph::current().intern(make_limb_constant({slot, limb, limbs}, value)), false};
}

/// Limbs that use the same `x`, each with its own input q and constants, one of which is 0, and a
/// trunk that adds up their values.
Program limbs_on_a_trunk(int limbs, int lanes) {
  Program program;
  program.graph.set_lane_width(lanes);
  const Graph::Scope scope(program.graph);
  const auto x = test::input_vector("x", 2);
  const auto q = test::input_vector("q", limbs);
  std::vector<Expression> forces;
  Expression sum = x[0] * x[1];
  Graph::LimbInputs names;
  for (int i = 0; i < limbs; ++i) {
    const auto limb = static_cast<std::uint32_t>(i);
    const auto count = static_cast<std::uint32_t>(limbs);
    names.push_back("q[" + std::to_string(i) + "]");
    const Expression c = limb_constant_of(1, limb, count, i);
    const Expression d = limb_constant_of(2, limb, count, -1.5 - i);
    const Expression y = c * q[limb] - d * (x[0] + x[1]);
    forces.push_back((y * y + c * x[1]) * q[limb]);
    sum += forces.back();
  }
  program.graph.add_limb_inputs(names);
  program.arguments = {{"x", 2, 1, ""}, {"q", limbs, 1, ""}};
  program.results = {{{"f", limbs, 1, ""}, forces}, {{"s", 1, 1, ""}, {sum}}};
  return program;
}

TEST(FindIsomorphicOperations, EveryOperationOfALimbByLimb) {
  const Program program = limbs_on_a_trunk(3, 8);
  const auto groups = find_isomorphic_operations(program);
  EXPECT_EQ(groups.size(), 7u);
  for (const LanePack& group : groups) {
    EXPECT_EQ(group.size(), 4u);
    EXPECT_EQ(group[3], 0u);
    for (std::size_t limb = 0; limb < 3; ++limb) {
      EXPECT_EQ(program.graph.nodes()[group[limb]].op, program.graph.nodes()[group[0]].op);
    }
  }
  const std::size_t last = groups.size() - 1;
  for (std::size_t limb = 0; limb < 3; ++limb) {
    EXPECT_EQ(groups[last][limb], program.results[0].values[limb].node());
  }
}

TEST(FindIsomorphicOperations, NoMoreLimbsThanLanes) {
  EXPECT_TRUE(find_isomorphic_operations(limbs_on_a_trunk(3, 2)).empty());
}

TEST(FindIsomorphicOperations, LanesChangeNoBit) {
  for (const int limbs : {2, 3, 4, 7}) {
    const Program program = limbs_on_a_trunk(limbs, 8);
    const Program packed = pack_lanes(program);
    EXPECT_EQ(packed.packs.size(), 7u) << limbs;
    const std::vector<std::vector<double>> arguments = {{0.3, -7.1},
                                                        {1, -2, 0.5, 4.4, -0.25, 8, 0.125}};
    EXPECT_EQ(evaluate(packed, arguments), evaluate(program, arguments));
  }
}

}  // namespace
}  // namespace treeline
