#include "oracle/hold_state.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <stdexcept>

#include "data/list_data.hpp"
#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"
#include "interpreter/loop_instances.hpp"
#include "mechanism/build_mechanism.hpp"
#include "oracle/entries.hpp"
#include "oracle/reference.hpp"

// States that keep constraints, by plane trigonometry and by differences of positions. Would catch:
// a loop that is closed to a tolerance only, velocities that open it, feet that slide, sines of the
// pose before, and a pose beyond the limits that counts.

namespace treeline::tests {
namespace {

constexpr int kStates = 20;

StateSpace space_of(const std::string& file, const std::string& scene_text) {
  Diagnostics diagnostics;
  const auto robot = read_urdf(data_file(file), diagnostics);
  if (!robot) throw std::runtime_error("the robot cannot be read");
  const auto scene = parse_scene(scene_text, "scene.yaml", *robot, diagnostics);
  if (!scene) throw std::runtime_error("the scene cannot be read");
  StateSpace space = make_state_space(*robot, *scene, reduced_mechanism(*robot, *scene), {}, 1);
  space.others = {{Quantity::stabilisation, 2}, {Quantity::drift, 3}};
  return space;
}

std::string four_bar(const std::string& end_of_rocker) {
  return "constraints: [{name: closing, between: [rocker, coupler], origin: {xyz: [0, 0, " +
         end_of_rocker + "]}, other_origin: {xyz: [0.3, 0, 0]}, rows: [x, z]}]\n";
}

/// From the end of the coupler to that of the rocker, in the plane x z. Joints turn about y: crank
/// of 0.12 m, coupler of 0.3 m along its x, rocker of 0.25 m that stands 0.3 m from the crank.
std::array<double, 2> gap(const std::vector<double>& q) {
  const double on_coupler = q[0] + q[1];
  return {0.3 + 0.25 * std::sin(q[2]) - 0.12 * std::sin(q[0]) - 0.3 * std::cos(on_coupler),
          0.25 * std::cos(q[2]) - 0.12 * std::cos(q[0]) + 0.3 * std::sin(on_coupler)};
}

/// d gap / dt.
std::array<double, 2> rate(const std::vector<double>& q, const std::vector<double>& qd) {
  const double on_coupler = q[0] + q[1];
  const double turn = qd[0] + qd[1];
  return {0.25 * std::cos(q[2]) * qd[2] - 0.12 * std::cos(q[0]) * qd[0] +
              0.3 * std::sin(on_coupler) * turn,
          -0.25 * std::sin(q[2]) * qd[2] + 0.12 * std::sin(q[0]) * qd[0] +
              0.3 * std::cos(on_coupler) * turn};
}

TEST(HoldState, ClosesAFourBar) {
  const StateSpace space = space_of("written/four_bar.urdf", four_bar("0.25"));
  int closed = 0;
  for (int i = 0; i < kStates; ++i) {
    State state = draw_state(space, i);
    if (class_of_state(i) != StateClass::random || !hold_state(space, state)) continue;
    ++closed;
    for (const double length : gap(state.q)) EXPECT_NEAR(length, 0, 2e-16) << i;
    for (const double speed : rate(state.q, state.qd)) EXPECT_NEAR(speed, 0, 1e-15) << i;
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(state.sin_q[k], std::sin(state.q[k]));
      EXPECT_EQ(state.cos_q[k], std::cos(state.q[k]));
    }
    EXPECT_EQ(state.others[Quantity::stabilisation], (std::vector<double>{0, 0}));
    EXPECT_EQ(state.others[Quantity::drift], (std::vector<double>{0, 0, 0}));
  }
  EXPECT_GT(closed, 0);
}

TEST(HoldState, RefusesWhatCannotClose) {
  const StateSpace space = space_of("written/four_bar.urdf", four_bar("25"));
  State state = draw_state(space, 1);
  EXPECT_FALSE(hold_state(space, state));
}

TEST(HoldState, RefusesPosesBeyondLimits) {
  StateSpace space = space_of("written/four_bar.urdf", four_bar("0.25"));
  State state = draw_state(space, 1);
  ASSERT_TRUE(hold_state(space, state));
  space.coordinates[2].upper = state.q[2] - 0.01;
  State again = draw_state(space, 1);
  EXPECT_FALSE(hold_state(space, again));
}

// Positions a moment before and after, whose difference has an error of the square of that moment.
TEST(HoldState, LetsNoFootSlide) {
  const StateSpace space = space_of(
      "golden/anymal.urdf",
      "base: floating\nconstraints: [{name: left, between: [LF_FOOT, world], rows: [x, y, z]}, "
      "{name: right, between: [RF_FOOT, world], rows: [x, z]}]\n");
  const auto& model = space.subject.model;
  State state = draw_state(space, 1);
  ASSERT_TRUE(hold_state(space, state));
  EXPECT_GT(vector_of<double>(state.qd).norm(), 0.1);
  const auto places = [&](double t) {
    const auto q = interpreter::move_coordinates<double>(model, vector_of<double>(state.q),
                                                         vector_of<double>(state.qd), t);
    return interpreter::forward_kinematics<double>(model, space.subject.constraints, q);
  };
  const double moment = 1e-5;
  const auto before = places(-moment), after = places(moment);
  for (const int row : {0, 1, 2}) {
    EXPECT_NEAR(after[0].position[row] - before[0].position[row], 0, 1e-12) << row;
  }
  for (const int row : {0, 2})
    EXPECT_NEAR(after[1].position[row] - before[1].position[row], 0, 1e-12) << row;
}

}  // namespace
}  // namespace treeline::tests
