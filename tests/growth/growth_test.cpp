#include <gtest/gtest.h>

#include "count_growth.hpp"

// Growth of operation counts, exact to the last operation. For robots of equal links the counts are
// polynomials of the number of links and of hands, whose differences of the right order vanish.
// Would catch: work that is repeated for every link, for every pair of links or for branches
// without a hand, and a recursion whose order of growth increased.

namespace treeline::growth {
namespace {

using Counts = std::vector<int>;

/// Differences of consecutive counts, taken `order` times.
Counts differences(Counts counts, int order) {
  for (; order > 0; --order) {
    for (std::size_t i = 0; i + 1 < counts.size(); ++i) counts[i] = counts[i + 1] - counts[i];
    counts.pop_back();
  }
  return counts;
}

/// Expects that the counts are those of a polynomial of exactly this degree.
void expect_degree(int degree, const Counts& counts, const std::string& what) {
  for (const int top : differences(counts, degree)) EXPECT_GT(top, 0) << what;
  for (const int beyond : differences(counts, degree + 1)) EXPECT_EQ(beyond, 0) << what;
}

constexpr Way kRecursions[] = {Way::unit_forces, Way::branching};

std::vector<Mechanism> make_robots(const std::vector<Shape>& shapes) {
  std::vector<Mechanism> robots;
  for (const Shape& shape : shapes) robots.push_back(make_robot(shape));
  return robots;
}

Counts count_over(const std::vector<Mechanism>& robots, Way way,
                  int (*flops)(const Mechanism&, Way)) {
  Counts counts;
  for (const Mechanism& robot : robots) counts.push_back(flops(robot, way));
  return counts;
}

const std::vector<Shape> kChains{{6, 0, 0, 1}, {12, 0, 0, 1}, {18, 0, 0, 1}, {24, 0, 0, 1}};

TEST(Growth, OfChainsIsLinearInLinks) {
  const auto chains = make_robots(kChains);
  for (const Way way : kRecursions) {
    expect_degree(1, count_over(chains, way, lambda_inverse_flops), name_of(way));
    expect_degree(1, count_over(chains, way, control_torque_flops), name_of(way));
  }
}

TEST(Growth, OfTheDenseWayIsCubicInLinks) {
  const auto chains =
      make_robots({{6, 0, 0, 1}, {9, 0, 0, 1}, {12, 0, 0, 1}, {15, 0, 0, 1}, {18, 0, 0, 1}});
  expect_degree(3, count_over(chains, Way::dense, lambda_inverse_flops), "dense");
  const Mechanism chain = make_robot(kChains.back());
  EXPECT_GT(control_torque_flops(chain, Way::dense),
            2 * control_torque_flops(chain, Way::branching));
}

// A branch without a hand costs the operations of its own links, wherever the hands are.
TEST(Growth, OfTreesIsLinearInBranches) {
  const auto trees = make_robots({{4, 2, 3, 2}, {4, 3, 3, 2}, {4, 4, 3, 2}});
  for (const Way way : kRecursions) {
    expect_degree(1, count_over(trees, way, lambda_inverse_flops), name_of(way));
    expect_degree(1, count_over(trees, way, control_torque_flops), name_of(way));
  }
}

// O(n m + m^3): hands meet in pairs in Lambda^-1, and in threes where it is factored.
TEST(Growth, OfHandsIsQuadraticForLambdaAndCubicForTheTorque) {
  const auto hands =
      make_robots({{2, 6, 2, 2}, {2, 6, 2, 3}, {2, 6, 2, 4}, {2, 6, 2, 5}, {2, 6, 2, 6}});
  expect_degree(2, count_over(hands, Way::unit_forces, lambda_inverse_flops), "PV-OSIM");
  expect_degree(3, count_over(hands, Way::unit_forces, control_torque_flops), "table 6.1");
}

TEST(Growth, OfAllLinksInertiasIsLinear) {
  const auto count_links = [](const std::vector<Shape>& shapes) {
    Counts counts;
    for (const Shape& shape : shapes) {
      counts.push_back(link_inertias_flops(make_robot(shape), true));
    }
    return counts;
  };
  expect_degree(1, count_links({{4, 0, 0, 0}, {34, 0, 0, 0}, {64, 0, 0, 0}}), "chains");
  expect_degree(1, count_links({{4, 5, 4, 0}, {4, 10, 4, 0}, {4, 15, 4, 0}}), "trees");
  // From M, link by link: doubling the links costs more than six times as much.
  EXPECT_GT(link_inertias_flops(make_robot({16, 0, 0, 0}), false),
            5 * link_inertias_flops(make_robot({8, 0, 0, 0}), false));
}

TEST(Growth, TablesHaveALineForEachSize) {
  const Series series{"name", "links", {4, 8}, {"a", "b"}, {{10, 20}, {30, 0}}};
  EXPECT_EQ(csv_text(series), "size,a,b\n4,10,30\n8,20,\n");
}

}  // namespace
}  // namespace treeline::growth
