#include <gtest/gtest.h>

#include <algorithm>

#include "passes/passes.hpp"
#include "passes/rebuild.hpp"
#include "passes/two_link_arm.hpp"
#include "program/evaluate.hpp"

// Would catch: emitted code that nothing needs, and removed code that something needs.
namespace treeline {
namespace {

TEST(EliminateDead, KeepsExactlyWhatResultsNeed) {
  const Program arm = test::trace_two_link_arm();
  const Program alive = eliminate_dead(arm);
  EXPECT_LT(alive.graph.nodes().size(), arm.graph.nodes().size());
  const Marks live = find_live(alive);
  EXPECT_EQ(std::count(live.begin() + 1, live.end(), false), 0);
  for (std::uint32_t node = 0; node < alive.graph.nodes().size(); ++node) {
    EXPECT_NE(alive.graph.names().of(node), "waste");
  }
  EXPECT_EQ(alive.graph.names().size(), 2u);
}

TEST(EliminateDead, KeepsValuesToTheBit) {
  const Program arm = test::trace_two_link_arm();
  const std::vector<std::vector<double>> arguments = {{0.3, -1.1}, {2.0, 0.7}, {-0.4, 5.0}};
  EXPECT_EQ(evaluate(arm, arguments), evaluate(eliminate_dead(arm), arguments));
}

}  // namespace
}  // namespace treeline
