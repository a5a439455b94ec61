#include "oracle/equation_sweeps.hpp"

#include <algorithm>
#include <string>

#include "description/scene_queries.hpp"
#include "joined_mechanisms.hpp"

namespace treeline::tests {
namespace {

std::string random_moving_link(Rng& rng, const RandomMechanism& made) {
  std::vector<std::string> links;
  for (const Link& link : made.robot.links) {
    if (!find_freedoms_of_link(made.robot, made.scene, link.name).empty()) {
      links.push_back(link.name);
    }
  }
  return links[static_cast<std::size_t>(rng.below(static_cast<int>(links.size())))];
}

/// Gravity, a payload, a point with its axes, another link's parameters and a contact as arguments.
void pass_model(Rng& rng, RandomMechanism& made) {
  SceneInputs& inputs = made.scene.inputs;
  const ScenePoint& tool = made.scene.operational_points.front();
  inputs.gravity = true;
  inputs.payloads.push_back({tool.link});
  inputs.tools.push_back({tool.name, 1, true});
  inputs.parameters.push_back({random_moving_link(rng, made)});
  inputs.contacts.push_back({made.scene.contacts.front().name});
}

/// All that motion depends on as one argument, with rotors and friction.
void pass_base_parameters(Rng& rng, RandomMechanism& made) {
  made.scene.inputs.base_parameters = true;
  SceneRegressor& asked = made.scene.regressor;
  asked.rotors = asked.friction = asked.coulomb = rng.chance(0.5);
}

/// A strict order of the points, others than that of the list.
void order_points(Rng& rng, RandomMechanism& made) {
  auto& points = made.scene.operational_points;
  const int first = rng.below(static_cast<int>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i].priority = 1 + (static_cast<int>(i) + first) % static_cast<int>(points.size());
  }
}

/// The centre of mass beside the other point, with some of its rows. In half the scenes the base
/// floats, in half the points differ in priority, and in half matter is an argument.
void add_center(Rng& rng, RandomMechanism& made) {
  if (rng.chance(0.5)) made.scene.base = Base::floating;
  made.scene.operational_points.push_back(random_center(rng));
  if (rng.chance(0.5)) {
    made.scene.inputs.payloads.push_back({random_moving_link(rng, made)});
    made.scene.inputs.parameters.push_back({random_moving_link(rng, made)});
  }
  if (rng.chance(0.5)) order_points(rng, made);
}

/// Rotors that are bodies, on the link before the joint or on the base, about axes of their own.
void add_rotors(Rng& rng, RandomMechanism& made) {
  for (const Joint& joint : made.robot.joints) {
    if (!info_of(joint.type).has_one_freedom()) continue;
    SceneRotor rotor{rng.rounded(0.001, 0.01), rng.rounded(-20, 20), "", std::nullopt};
    if (rng.chance(0.5)) {
      rotor.link = made.robot.links[static_cast<std::size_t>(made.robot.root)].name;
      rotor.axis = detail::random_axis(rng, 0);
    }
    made.scene.rotors[joint.name] = rotor;
  }
}

/// Another robot beside it, which floats.
void add_robot(Rng& rng, RandomMechanism& made) {
  const RandomOptions options{.joints = 3,
                              .floating_base = true,
                              .mimic = 0.3,
                              .operational_points = 1,
                              .all_rows = false,
                              .external_forces = 1};
  PlacedMechanism one{made, detail::random_pose(rng, 1, 0)};
  PlacedMechanism other{random_mechanism(static_cast<std::uint64_t>(rng.below(1000)), options), {}};
  other.made.scene.gravity = made.scene.gravity;
  made = joined({one, other});
}

}  // namespace

const std::vector<Sweep>& sweeps() {
  static const std::vector<Sweep> kSweeps{
      {"chain", {.joints = 4, .operational_points = 2, .all_rows = false}},
      {"floating_tree",
       {.joints = 4,
        .branching = 0.6,
        .floating_base = true,
        .operational_points = 2,
        .all_rows = false,
        .external_forces = 2},
       2},
      {"balls_and_planes",
       {.joints = 3,
        .mix = {1, 0, 1, 0.3, 1, 1, 2},
        .operational_points = 2,
        .all_rows = false,
        .external_forces = 1},
       1},
      {"mimics_and_drives",
       {.joints = 5,
        .mimic = 0.5,
        .rotors = 0.5,
        .drives = 0.5,
        .operational_points = 2,
        .all_rows = false}},
      {"inputs",
       {.joints = 4, .floating_base = true, .operational_points = 2, .all_rows = false},
       1,
       pass_model},
      {"base_parameters",
       {.joints = 5, .mimic = 0.6, .rotors = 0.5, .all_rows = false, .varied_mimics = true},
       0,
       pass_base_parameters},
      {"priorities",
       {.joints = 8, .mix = {5, 1, 2, 0.3, 0, 1, 1}, .operational_points = 3, .all_rows = false},
       0,
       order_points},
      {"center_of_mass",
       {.joints = 5, .mix = {5, 1, 2, 1, 1, 1, 1}, .mimic = 0.2, .all_rows = false},
       0,
       add_center},
      {"rotors_as_bodies",
       {.joints = 4,
        .branching = 0.4,
        .mix = {4, 1, 2, 0.5, 0, 0, 1},
        .floating_base = true,
        .operational_points = 1,
        .all_rows = false},
       1,
       add_rotors},
      {"two_robots",
       {.joints = 4,
        .mimic = 0.3,
        .operational_points = 1,
        .all_rows = false,
        .external_forces = 1},
       0,
       add_robot},
  };
  return kSweeps;
}

Subjects draw_subjects(const Sweep& sweep, std::uint64_t seed) {
  RandomMechanism made = random_mechanism(seed, sweep.options);
  Rng rng(seed + 1000);
  for (int i = 0; i < sweep.contacts; ++i) {
    made.scene.contacts.push_back(
        detail::random_point(rng, sweep.options, made.robot, "contact_" + std::to_string(i)));
  }
  if (sweep.change != nullptr) sweep.change(rng, made);
  return {made.robot, made.scene, {}};
}

}  // namespace treeline::tests
