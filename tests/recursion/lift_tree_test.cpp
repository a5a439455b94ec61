#include "recursion/tree/lift_tree.hpp"

#include <gtest/gtest.h>

#include "mechanism/build_mechanism.hpp"
#include "mechanism/find_limbs.hpp"
#include "random_mechanism.hpp"
#include "recursion/routes/pruned_algorithms.hpp"

// Would catch: a constant of a tree that is lost or mixed up in the conversion from double, choices
// within links that have no effect, isomorphic limbs that are not marked, and coordinates of an
// algorithm that are left out although they may be the cheapest.

namespace treeline::tests {
namespace {

void expect_same(const Vector3<Expression>& a, const Vector3<Expression>& b) {
  EXPECT_TRUE(a.x == b.x && a.y == b.y && a.z == b.z);
}
void expect_same(const Symmetric3<Expression>& a, const Symmetric3<Expression>& b) {
  expect_same(Vector3<Expression>{a.xx, a.xy, a.xz}, {b.xx, b.xy, b.xz});
  expect_same(Vector3<Expression>{a.yy, a.yz, a.zz}, {b.yy, b.yz, b.zz});
}
void expect_same(const Rotation<Expression>& a, const Rotation<Expression>& b) {
  expect_same(Vector3<Expression>{a.a.c, a.alpha.c, a.b.c}, {b.a.c, b.alpha.c, b.b.c});
  expect_same(Vector3<Expression>{a.a.s, a.alpha.s, a.b.s}, {b.a.s, b.alpha.s, b.b.s});
}

void expect_same(const TreeLink<Expression>& a, const TreeLink<Expression>& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_TRUE(a.parent == b.parent && a.kind == b.kind && a.q_index == b.q_index);
  EXPECT_TRUE(a.v_index == b.v_index && a.defers_rotation == b.defers_rotation);
  EXPECT_EQ(a.carries_column, b.carries_column);
  EXPECT_TRUE(a.multiplier == b.multiplier && a.offset == b.offset);
  expect_same(a.R, b.R);
  expect_same(a.p, b.p);
  EXPECT_TRUE(a.inertia.mass == b.inertia.mass);
  expect_same(a.inertia.h, b.inertia.h);
  expect_same(a.inertia.Sigma, b.inertia.Sigma);
  expect_same(a.inertia.J, b.inertia.J);
}

void expect_same(const std::vector<TreePoint<Expression>>& a,
                 const std::vector<TreePoint<Expression>>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_TRUE(a[i].name == b[i].name && a[i].link == b[i].link && a[i].axes == b[i].axes);
    EXPECT_TRUE(a[i].rows == b[i].rows && a[i].priority == b[i].priority);
    expect_same(a[i].p, b[i].p);
    expect_same(a[i].R.row_x, b[i].R.row_x);
    expect_same(a[i].R.row_y, b[i].R.row_y);
    expect_same(a[i].R.row_z, b[i].R.row_z);
  }
}

/// Both trees number their nodes from 1.
template <class Make>
Tree<Expression> in_new_graph(const Make& make) {
  Graph graph = Graph::for_trace(8);
  const Graph::Scope scope(graph);
  return make();
}

TEST(LiftTree, IsTheTreeOfTheMechanism) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomOptions options;
    options.floating_base = seed % 2 == 0;
    options.external_forces = 1;
    options.mimic = seed % 3 == 0 ? 0.3 : 0;
    const RandomMechanism drawn = random_mechanism(seed, options);
    Mechanism mechanism = reduced_mechanism(drawn.robot, drawn.scene);
    mechanism.limbs = find_limbs(mechanism, 8);
    const auto constants = constant_tree<DoubleDouble>(mechanism);
    mechanism.links.back().defers_rotation = true;
    const auto expected = in_new_graph([&] { return constant_tree<Expression>(mechanism); });
    const auto lifted = in_new_graph([&] { return lift_tree(constants, mechanism); });
    ASSERT_EQ(lifted.links.size(), expected.links.size());
    for (std::size_t i = 0; i < lifted.links.size(); ++i) {
      expect_same(lifted.links[i], expected.links[i]);
    }
    expect_same(lifted.operational_points, expected.operational_points);
    expect_same(lifted.external_forces, expected.external_forces);
    expect_same(lifted.contacts, expected.contacts);
    expect_same(lifted.link_frames, expected.link_frames);
    expect_same(lifted.gravity, expected.gravity);
    expect_same(lifted.world_moment, expected.world_moment);
    EXPECT_TRUE(lifted.total_mass == expected.total_mass);
    EXPECT_TRUE(lifted.inverse_total_mass == expected.inverse_total_mass);
    EXPECT_TRUE(lifted.nq == expected.nq && lifted.nv == expected.nv);
    EXPECT_EQ(lifted.has_mimics, expected.has_mimics);
  }
}

/// A tree of so many nodes, and one for the constant 0.
Program program_of(const std::string& algorithm, int nodes) {
  Program program;
  program.route = {algorithm, "", "asked", ""};
  const Graph::Scope scope(program.graph);
  for (int i = 0; i < nodes; ++i) Expression(i + 1.0);
  return program;
}

TEST(PrunedAlgorithms, AreLongAndFarFromTheShortest) {
  PrunedAlgorithms pruned;
  pruned.look_at(program_of("forces", 20'000));
  pruned.look_at(program_of("factors", 60'000));
  pruned.look_at(program_of("branching", 39'000));
  EXPECT_TRUE(pruned.has({"factors", "", "link-2", ""}));
  EXPECT_FALSE(pruned.has({"forces", "", "link-2", ""}));
  EXPECT_FALSE(pruned.has({"branching", "", "own", ""}));
}

TEST(PrunedAlgorithms, AreNoneWhereAllIsShort) {
  PrunedAlgorithms pruned;
  pruned.look_at(program_of("forces", 1'000));
  pruned.look_at(program_of("factors", 29'000));
  EXPECT_FALSE(pruned.has({"factors", ""}));
}

}  // namespace
}  // namespace treeline::tests
