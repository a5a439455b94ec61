// Would catch: a function that depends on gravity, payloads, inertial parameters or a tool and does
// not take them, or takes what its result does not depend on; a state whose payload is none that a
// body can have.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <map>

#include "check/fixture.hpp"
#include "description/scene_inputs.hpp"
#include "mechanism/build_mechanism.hpp"
#include "oracle/interpret.hpp"
#include "oracle/reference.hpp"
#include "oracle/subject_at.hpp"

namespace treeline::tests {
namespace {

SceneInputs everything(const Scene& scene) {
  SceneInputs inputs;
  inputs.gravity = true;
  inputs.payloads = {{scene.operational_points.front().link, 2, 0.3}};
  inputs.parameters = {{scene.operational_points.front().link, 5, 0.3}};
  inputs.tools = {{scene.operational_points.front().name, 0.5, true}};
  if (!scene.contacts.empty()) inputs.contacts = {{scene.contacts.front().name, 0.5}};
  if (!scene.constraints.empty()) inputs.active = {scene.constraints.front().name};
  inputs.active_tasks = {scene.operational_points.front().name};
  return inputs;
}

/// A state with random entries for what functions of one contact and one held row take, too.
State draw(const StateSpace& space) {
  State state = draw_state(space, 3);
  Rng rng(7);
  const std::map<Quantity, int> sizes = {{Quantity::impulse, 3},
                                         {Quantity::normals, 3},
                                         {Quantity::stabilisation, 2},
                                         {Quantity::drift, 1},
                                         {Quantity::f_wanted, 1}};
  for (const auto& [quantity, size] : sizes) {
    for (int i = 0; i < size; ++i) state.others[quantity].push_back(rng.uniform(0.1, 1));
  }
  return state;
}

bool changes(Function function, Quantity quantity, const StateSpace& space, const State& state) {
  State other = state;
  if (quantity == Quantity::tool_orientation) {  // its length does not count
    other.others[quantity].front() *= 1.25;
  } else if (quantity == Quantity::active_tasks) {  // what is done in part takes a law
    other.others[quantity].assign(1, 0);
  } else {
    for (double& entry : other.others[quantity]) entry *= 1.25;
  }
  return interpret<double>(function, *SubjectAt(space.subject, state), state) !=
         interpret<double>(function, *SubjectAt(space.subject, other), other);
}

/// A PUMA whose task is in the axes of its tool, with a contact and a constraint, and what changes
/// it as arguments.
StateSpace puma_with_everything() {
  Subjects subjects = load("puma560");
  subjects.scene.operational_points.front().axes = Axes::local;
  ScenePoint contact = subjects.scene.operational_points.front();
  contact.name = "contact";
  contact.rows = {true, true, true, false, false, false};
  subjects.scene.contacts = {contact};
  ScenePoint held = contact;
  held.name = "held";
  held.link = "link3";
  held.rows = {true, false, false, false, false, false};
  subjects.scene.constraints = {held};
  subjects.scene.functions = {Function::inverse_dynamics_regressor, Function::energy_regressor};
  subjects.scene.inputs = everything(subjects.scene);
  const Mechanism mechanism = reduced_mechanism(subjects.robot, subjects.scene);
  StateSpace space = make_state_space(subjects.robot, subjects.scene, mechanism, {}, 1);
  space.subject = make_subject<double>(subjects.robot, subjects.scene);
  space.others = {{Quantity::gravity, 3},          {Quantity::payload, 10},
                  {Quantity::parameters, 10},      {Quantity::tool, 3},
                  {Quantity::tool_orientation, 4}, {Quantity::contact, 3},
                  {Quantity::active, 1},           {Quantity::active_tasks, 1}};
  return space;
}

TEST(ModelInputs, AreTakenByWhatDependsOnThem) {
  const StateSpace space = puma_with_everything();
  const State state = draw(space);
  for (const FunctionInfo& row : kFunctions) {
    if (needs_objects(row.function) || row.function == Function::damped_control_torque) continue;
    for (const auto& [quantity, size] : space.others) {
      // No point is the centre of mass.
      const bool is_matter = quantity == Quantity::payload || quantity == Quantity::parameters;
      const bool expected =
          is_matter ? depends_on_inertia(Scene{}, row.function) : takes(row.function, quantity);
      EXPECT_EQ(changes(row.function, quantity, space, state), expected)
          << row.name << " " << symbol_of(quantity);
    }
  }
}

// What arguments say of a contact is what the scene would say.
TEST(ModelInputs, PlaceContactsAsTheSceneWould) {
  const StateSpace space = puma_with_everything();
  const State state = draw(space);
  const std::vector<double>& place = state.others.at(Quantity::contact);
  const Subject<double> at = *SubjectAt(space.subject, state);
  Subject<double> placed = *SubjectAt(space.subject, state);
  placed.contacts.front().p = {place[0], place[1], place[2]};
  EXPECT_NE(space.subject.contacts.front().p, placed.contacts.front().p);
  for (const Function function : kContactFunctions) {
    EXPECT_EQ(interpret<double>(function, at, state), interpret<double>(function, placed, state))
        << function_name(function);
  }
}

// A second moment without a negative principal value belongs to some distribution of matter.
TEST(ModelInputs, AreDrawnAsBodiesHaveThem) {
  Subjects subjects = load("puma560");
  subjects.scene.inputs = everything(subjects.scene);
  const Mechanism mechanism = reduced_mechanism(subjects.robot, subjects.scene);
  StateSpace space = make_state_space(subjects.robot, subjects.scene, mechanism, {}, 1);
  space.subject = make_subject<double>(subjects.robot, subjects.scene);
  space.others = {{Quantity::payload, 10}};
  for (int index = 0; index < 50; ++index) {
    const auto p = draw_state(space, index).others.at(Quantity::payload);
    ASSERT_EQ(p.size(), 10U);
    EXPECT_EQ(p[0] > 0, index > 0);
    EXPECT_LE(p[0], 2);
    const double half = (p[4] + p[6] + p[9]) / 2;
    Eigen::Matrix4d pseudo;  // second moments, first moments and mass (Wensing et al. 2018)
    pseudo << half - p[4], -p[5], -p[7], p[1],  //
        -p[5], half - p[6], -p[8], p[2],        //
        -p[7], -p[8], half - p[9], p[3],        //
        p[1], p[2], p[3], p[0];
    const double least = Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d>(pseudo).eigenvalues()(0);
    EXPECT_GE(least, -1e-15) << index;
    EXPECT_EQ(least > 0, index > 0);
  }
}

}  // namespace
}  // namespace treeline::tests
