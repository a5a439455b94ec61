#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "passes/passes.hpp"
#include "passes/two_link_arm.hpp"
#include "program/evaluate.hpp"

// Would catch: values of different operations in one register, a value in two lanes, packs that
// wait for each other, packs that cost more than they save, and lanes that change a bit.
namespace treeline {
namespace {

/// The pairs (k_i, m_i), one per column, rotated `steps` times by angles that all columns share.
Program rotated_columns(int columns, int steps, int lanes) {
  Program program;
  program.graph.set_lane_width(lanes);
  const Graph::Scope scope(program.graph);
  const auto count = static_cast<std::size_t>(columns);
  auto k = test::input_vector("k", columns);
  auto m = test::input_vector("m", columns);
  const auto angle = test::input_vector("a", 2 * steps);
  for (int step = 0; step < steps; ++step) {
    const Expression c = angle[static_cast<std::size_t>(2 * step)];
    const Expression s = angle[static_cast<std::size_t>(2 * step + 1)];
    std::vector<Expression> turned(count);
    for (std::size_t i = 0; i < count; ++i) {
      turned[i] = c * k[i] - s * m[i];
      m[i] = s * k[i] + c * m[i];
    }
    k = turned;
    program.graph.align_lanes(k);
    program.graph.align_lanes(m);
  }
  program.arguments = {{"k", columns, 1, ""}, {"m", columns, 1, ""}, {"a", 2 * steps, 1, ""}};
  program.results = {{{"y", columns, 1, ""}, k}, {{"z", columns, 1, ""}, m}};
  return program;
}

int packed_nodes(const Program& program) {
  int count = 0;
  for (const LanePack& pack : program.packs) {
    count += static_cast<int>(pack.size() -
                              static_cast<std::size_t>(std::count(pack.begin(), pack.end(), 0U)));
  }
  return count;
}

TEST(PackLanes, AlignedColumnsShareEveryOperation) {
  const Program packed = pack_lanes(rotated_columns(4, 3, 4));
  EXPECT_EQ(packed_nodes(packed), 3 * 4 * 6);  // steps, columns, operations of a rotation
  EXPECT_EQ(packed.packs.size(), 3u * 6u);
}

TEST(PackLanes, SixColumnsFitEightLanes) {
  const Program packed = pack_lanes(rotated_columns(6, 3, 8));
  EXPECT_EQ(packed.packs.size(), 3u * 6u);
}

TEST(PackLanes, OneLaneIsNoLane) {
  EXPECT_TRUE(pack_lanes(rotated_columns(4, 3, 1)).packs.empty());
}

TEST(PackLanes, PacksAreDisjointAndOfOneOperation) {
  const Program packed = pack_lanes(rotated_columns(7, 4, 4));
  std::set<std::uint32_t> seen;
  for (const LanePack& pack : packed.packs) {
    std::set<Op> ops;
    for (const std::uint32_t node : pack) {
      if (node != 0) {
        EXPECT_TRUE(seen.insert(node).second);
        ops.insert(packed.graph.nodes()[node].op);
      }
    }
    EXPECT_EQ(ops.size(), 1u);
  }
}

/// Two groups, each with a lane that needs the other group's, so neither can be computed at once.
TEST(PackLanes, PacksThatWaitForEachOtherAreTakenApart) {
  Program program;
  program.graph.set_lane_width(2);
  const Graph::Scope scope(program.graph);
  const auto x = test::input_vector("x", 4);
  std::vector<Expression> first{x[0] * x[1], {}};
  std::vector<Expression> second{x[2] * x[3], first[0] * x[2]};
  first[1] = second[0] * x[1];
  program.graph.align_lanes(first);
  program.graph.align_lanes(second);
  program.results = {{{"y", 2, 1, ""}, first}, {{"z", 2, 1, ""}, second}};
  EXPECT_LE(schedule(pack_lanes(program)).packs.size(), 1u);
}

/// A cycle through a scalar that is reached before any of the packs on it: the second lane of an
/// older pack reads the scalar.
TEST(PackLanes, CyclesThroughScalarsAreFoundFromOutside) {
  Program program;
  program.graph.set_lane_width(2);
  const Graph::Scope scope(program.graph);
  const auto x = test::input_vector("x", 8);
  std::vector<Expression> outer{x[0] * x[1], {}};
  std::vector<Expression> inner{x[2] * x[3], {}};
  const Expression scalar = inner[0] + x[4];
  inner[1] = scalar * x[5];
  outer[1] = scalar * x[6];
  program.graph.align_lanes(outer);
  program.graph.align_lanes(inner);
  const std::vector<Expression> sums{outer[0] + x[7], outer[1] + x[7], inner[0] + x[6],
                                     inner[1] + x[6]};
  program.results = {{{"y", 2, 1, ""}, outer}, {{"z", 2, 1, ""}, inner}, {{"s", 4, 1, ""}, sums}};
  program.arguments = {{"x", 8, 1, ""}};
  const std::vector<std::vector<double>> arguments = {{1, 2, 3, 4, 5, 6, 7, 8}};
  EXPECT_EQ(evaluate(schedule(pack_lanes(program)), arguments), evaluate(program, arguments));
}

TEST(PackLanes, GatheringAndTakingOutAgainIsNotWorthOneOperation) {
  Program program;
  program.graph.set_lane_width(4);
  const Graph::Scope scope(program.graph);
  const auto x = test::input_vector("x", 8);
  std::vector<Expression> sums;
  for (std::size_t i = 0; i < 4; ++i) {
    sums.push_back((x[i] + x[7]) * x[i + 4]);
  }
  program.graph.align_lanes(sums);
  const Expression used = sums[0] / sums[1] + sums[2] / sums[3];
  program.results = {{{"y", 1, 1, ""}, {used}}};
  EXPECT_TRUE(pack_lanes(program).packs.empty());
}

TEST(PackLanes, ScheduleKeepsLanesTogetherAndValuesToTheBit) {
  const Program columns = rotated_columns(6, 3, 4);
  const Program packed = schedule(pack_lanes(columns));
  for (const LanePack& pack : packed.packs) {
    std::set<std::uint32_t> nodes(pack.begin(), pack.end());
    nodes.erase(0);
    EXPECT_EQ(*nodes.rbegin() - *nodes.begin() + 1, nodes.size());
  }
  const std::vector<std::vector<double>> arguments = {{0.1, -0.7, 2.0, 3.5, -4.0, 0.3},
                                                      {1.0, 2.0, -3.0, 0.5, 0.25, 9.0},
                                                      {0.8, 0.6, -0.6, 0.8, 0.28, 0.96}};
  EXPECT_EQ(evaluate(columns, arguments), evaluate(packed, arguments));
}

}  // namespace
}  // namespace treeline
