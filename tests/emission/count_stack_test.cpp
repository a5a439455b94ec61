#include <gtest/gtest.h>

#include <memory>

#include "emission/costs.hpp"
#include "emission/sample.hpp"
#include "program/link_loops.hpp"

// Would catch: a stack told of a function that loops which is that of its trace as straight lines.
namespace treeline {
namespace {

// The types of the work space as emitted code has them.
using real = double;
using TlLinkPose = LinkTypes::TlLinkPose;
using TlLinkRotation = LinkTypes::TlLinkRotation;
using TlSpatial = LinkTypes::TlSpatial;
using TlLinkMotion = LinkTypes::TlLinkMotion;
using TlLinkInertia = LinkTypes::TlLinkInertia;
using TlLinkProjection = LinkTypes::TlLinkProjection;
using TlLinkFrame = LinkTypes::TlLinkFrame;
using TlLinkBody = LinkTypes::TlLinkBody;
using TlLinkAxes = LinkTypes::TlLinkAxes;
constexpr int TL_LINKS = 24;
constexpr int TL_SLOTS = 3;
constexpr int TL_TURNED = 1;
constexpr int TL_POINTS = 2;
constexpr int TL_ROWS = 12;
constexpr int TL_RANKED = 1;
constexpr int TL_BASE_ENTRIES = 1;
#define TL_ARTICULATED 1
#include "emitted/link_work.h"
#undef TL_ARTICULATED

Program looping(bool uses_rows) {
  LinkLoops plan;
  plan.table.links.resize(24);
  plan.table.slots = 3;
  plan.uses_factors = true;
  plan.uses_rows = uses_rows;
  if (uses_rows) {
    plan.table.points.resize(2);
    plan.table.rows.resize(12);
  }
  Program program = test::safe_programs().front();
  program.loops = std::make_shared<const LinkLoops>(plan);
  return program;
}

/// Not less than the work space has, and at most a tenth more.
void expect_about(std::size_t bytes, std::size_t values) {
  EXPECT_GE(8 * values, bytes);
  EXPECT_LE(8 * values, bytes + bytes / 10);
}

TEST(CountStackValues, AreThoseOfTheWorkSpaceOfLoops) {
  const std::size_t joints = sizeof(TlMotionWork) + sizeof(TlFactorWork);
  expect_about(joints, count_stack_values(looping(false), false));
  expect_about(joints + sizeof(TlRowWork), count_stack_values(looping(true), false));
}

TEST(CountStackValues, AreThoseOfTheWorkSpaceOfTheMassMatrix) {
  Program program = looping(false);
  LinkLoops plan = *program.loops;
  plan.uses_factors = false;
  plan.uses_matrix = true;
  program.loops = std::make_shared<const LinkLoops>(plan);
  expect_about(sizeof(TlMotionWork) + sizeof(TlMatrixWork), count_stack_values(program, false));
}

TEST(CountStackValues, AreThoseAliveAtOnceInStraightLines) {
  Program program = looping(false);
  program.loops = nullptr;
  const std::size_t values = count_stack_values(program, false);
  EXPECT_GT(values, 0U);
  EXPECT_LE(values, program.graph.nodes().size());
  EXPECT_GE(count_stack_values(program, true), values);  // parts share some
}

}  // namespace
}  // namespace treeline
