// Would catch: a target with a gap in its row, lanes that its registers cannot hold, a board that
// no listed package provides, and a change of what is generated where no target is named.
#include "target/target.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>
#include <stdexcept>
#include <string>

namespace treeline {
namespace {

const Target& named(const char* name) {
  const Target* const target = find_target(name);
  if (target == nullptr) throw std::runtime_error(name);
  return *target;
}

TEST(Targets, HaveCompleteRows) {
  std::set<std::string_view> names;
  for (const Target& target : all_targets()) {
    EXPECT_TRUE(names.insert(target.name).second) << target.name;
    EXPECT_STRNE(target.about, "") << target.name;
    EXPECT_STRNE(target.package, "") << target.name;
    EXPECT_EQ(*target.flags != '\0', is_particular(target)) << target.name;
    EXPECT_EQ(find_target(target.name), &target);
  }
  for (const char* name :
       {"generic", "cortex-m0", "cortex-m3", "cortex-m4f", "cortex-m7", "cortex-m33", "cortex-m55",
        "rv32imfc", "rv64gc", "aarch64", "x86-64-v3", "x86-64-v4"}) {
    EXPECT_TRUE(names.contains(name)) << name;
  }
  EXPECT_EQ(find_target("cortex-m8"), nullptr);
}

TEST(Targets, HaveBoardsWithCosts) {
  int boards = 0;
  for (const Target& target : all_targets()) {
    if (target.board.kind == BoardKind::none) continue;
    ++boards;
    for (const char* text : {target.prefix, target.board.simulator, target.board.machine,
                             target.board.package, target.board.linker, target.cycles.source}) {
      EXPECT_STRNE(text, "") << target.name;
    }
    const CycleCosts& costs = target.cycles;
    for (const double cycles : {costs.other, costs.memory, costs.branch, costs.arithmetic,
                                costs.fused, costs.divide_float, costs.divide_double}) {
      EXPECT_GT(cycles, 0) << target.name;
      EXPECT_LE(cycles, 100) << target.name;
    }
    EXPECT_EQ(target.board.clock_mhz > 0, target.board.kind == BoardKind::cortex_m) << target.name;
  }
  EXPECT_EQ(boards, 9);
}

// Would catch: a processor on which `optimize: size` takes one of its forms for free.
TEST(Targets, HaveSizesOfCode) {
  for (const Target& target : all_targets()) {
    for (const int bytes : {4, 8}) {
      const CodeSizes& sizes = code_sizes(target, bytes);
      EXPECT_GE(sizes.operation, 4) << target.name;
      EXPECT_GT(sizes.start, 0) << target.name;
      EXPECT_GE(sizes.loops, 1) << target.name;
    }
  }
}

// Would catch: other code where no target is named, and a processor whose operations cost nothing.
TEST(Targets, HaveCostsOfOperations) {
  const OperationCosts common;
  for (const Target& target : all_targets()) {
    for (const int bytes : {4, 8}) {
      const OperationCosts& costs = operation_costs(target, bytes);
      EXPECT_STRNE(costs.source, "") << target.name;
      if (target.board.kind == BoardKind::none) {
        EXPECT_EQ(costs.quotient, common.quotient) << target.name;
        EXPECT_EQ(costs.angle, common.angle) << target.name;
        EXPECT_EQ(costs.waiting, common.waiting) << target.name;
        EXPECT_EQ(costs.lanes, common.lanes) << target.name;
        continue;
      }
      EXPECT_STRNE(costs.source, common.source) << target.name;
      EXPECT_GT(costs.product, 0.2) << target.name;
      EXPECT_LT(costs.product, 3) << target.name;
      EXPECT_GT(costs.quotient, 2) << target.name;
      EXPECT_GT(costs.angle, costs.product) << target.name;
      EXPECT_EQ(costs.lanes, choose_lanes(target, bytes)) << target.name;
    }
  }
}

// Would catch: a test machine on which `check --target` finds no compiler or simulator.
TEST(Targets, AreInTheListOfPackages) {
  std::ifstream stream(TREELINE_PACKAGES);
  const std::string packages{std::istreambuf_iterator<char>(stream), {}};
  for (const Target& target : all_targets()) {
    if (target.board.kind == BoardKind::none) continue;
    EXPECT_NE(packages.find(target.package), std::string::npos) << target.package;
    EXPECT_NE(packages.find(target.board.package), std::string::npos) << target.board.package;
  }
}

TEST(Targets, ChooseLanesByRegisters) {
  EXPECT_EQ(choose_lanes(named("generic"), 4), 8);
  EXPECT_EQ(choose_lanes(named("generic"), 8), 8);
  EXPECT_EQ(choose_lanes(named("aarch64"), 4), 4);
  EXPECT_EQ(choose_lanes(named("aarch64"), 8), 2);
  EXPECT_EQ(choose_lanes(named("x86-64-v3"), 4), 8);
  EXPECT_EQ(choose_lanes(named("x86-64-v3"), 8), 4);
  EXPECT_EQ(choose_lanes(named("x86-64-v4"), 8), 8);
  EXPECT_EQ(choose_lanes(named("x86-64-v4"), 4), 8);  // what scenes permit, though 16 would fit
  for (const char* name : {"cortex-m0", "cortex-m4f", "cortex-m7", "rv32imfc", "rv64gc"}) {
    EXPECT_EQ(choose_lanes(named(name), 4), 1) << name;
  }
}

TEST(Targets, KnowWhatIsEmulated) {
  EXPECT_TRUE(emulates(named("cortex-m0"), 4));
  EXPECT_FALSE(emulates(named("cortex-m4f"), 4));
  EXPECT_TRUE(emulates(named("cortex-m4f"), 8));
  EXPECT_TRUE(emulates(named("rv32imfc"), 8));
  EXPECT_FALSE(emulates(named("cortex-m7"), 8));
  EXPECT_FALSE(emulates(named("generic"), 8));
}

}  // namespace
}  // namespace treeline
