#include "choice/function_mechanisms.hpp"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "choice/choose_axes.hpp"
#include "description/check_scene.hpp"
#include "description/scene_inputs.hpp"
#include "mechanism/build_mechanism.hpp"
#include "recursion/parameters/base_parameters.hpp"

namespace treeline {
namespace {

/// Needs of a function in a scene, as bits. The bits above are quantities of `kQuantities` of which
/// the robot is made (`is_of_model`).
constexpr unsigned kPoints = 1;
constexpr unsigned kForces = 2;
constexpr unsigned kContacts = 4;
constexpr unsigned kConstraints = 8;

constexpr unsigned bit_of(Quantity quantity) {
  return kConstraints << (1 + static_cast<unsigned>(quantity));
}
static_assert(bit_of(kQuantities.back().quantity) != 0, "the bits of needs have run out");

/// Calls `visit(quantity)` for each that scenes may make an argument under `inputs`.
template <class Visit>
void for_each_of_model(const Visit& visit) {
  for (const QuantityInfo& row : kQuantities) {
    if (is_of_model(row.quantity)) visit(row.quantity);
  }
}

}  // namespace

FunctionMechanisms::FunctionMechanisms(const Robot& robot, const Scene& scene, Inertias inertias)
    : robot_(robot), scene_(scene), inertias_(inertias) {
  if (!scene.operational_points.empty()) in_scene_ |= kPoints;
  if (!scene.external_forces.empty()) in_scene_ |= kForces;
  if (!scene.contacts.empty()) in_scene_ |= kContacts;
  for_each_of_model([&](Quantity quantity) {
    if (has_input(scene, quantity)) in_scene_ |= bit_of(quantity);
  });
  if (scene.holds_rows()) in_scene_ |= kConstraints;
  const auto& functions = scene.functions;
  if (scene.inputs.base_parameters ||
      (scene.regressor.base && std::any_of(functions.begin(), functions.end(), is_regressor))) {
    const Mechanism whole = build_mechanism(robot, scene);
    base_parameters_of(whole);
    base_parameters_ = whole.base_parameters;
  }
}

/// Makes its base parameters those of the whole scene: a function that does not depend on gravity
/// has them in the order of those that do.
Mechanism FunctionMechanisms::with_base_parameters(Mechanism mechanism) const {
  if (base_parameters_) mechanism.base_parameters = base_parameters_;
  return mechanism;
}

const Mechanism& FunctionMechanisms::of(Function function) {
  unsigned needs = 0;
  if (needs_points(function) || needs_objects(function)) needs |= kPoints;
  if (takes_external_forces(function)) needs |= kForces;
  if (needs_contacts(function)) needs |= kContacts;
  for_each_of_model([&](Quantity quantity) {
    if (takes_input(scene_, function, quantity)) needs |= bit_of(quantity);
  });
  if (needs_constraints(function)) needs |= kConstraints;
  needs &= in_scene_;
  const FrameCost& frames = info_of(function).frames;
  if (frames.of_files) return in_frames_of_files(needs);
  if (frames.count == 0) return reduced(needs);
  if (frames.count == 1) return with_axes_of(needs, *frames.begin());
  // What forward dynamics derives is for the most part what inverse dynamics does.
  const Function counted =
      is_derivative(function) ? Function::inverse_dynamics_derivatives : function;
  const std::pair key{needs, counted};
  const auto cheapest = cheapest_.find(key);
  if (cheapest != cheapest_.end()) return *cheapest->second;
  const Mechanism* best = nullptr;
  int least = std::numeric_limits<int>::max();
  for (const Function frame_cost : frames) {
    const Mechanism& mechanism = with_axes_of(needs, frame_cost);
    const int flops = count_cheapest(mechanism, counted);
    if (flops < least) {
      least = flops;
      best = &mechanism;
    }
  }
  cheapest_.emplace(key, best);
  return *best;
}

const Mechanism& FunctionMechanisms::with_axes_of(unsigned needs, Function frame_cost) {
  const std::pair key{needs, frame_cost};
  const auto chosen = by_frame_cost_.find(key);
  if (chosen != by_frame_cost_.end()) return chosen->second;
  Mechanism& mechanism = by_frame_cost_.emplace(key, reduced(needs)).first->second;
  choose_axes(mechanism, frame_cost);
  return mechanism;
}

const Mechanism& FunctionMechanisms::whole() {
  return reduced(in_scene_);
}

const Mechanism& FunctionMechanisms::reduced(unsigned needs) {
  const auto found = by_needs_.find(needs);
  if (found != by_needs_.end()) return found->second;
  return by_needs_
      .emplace(needs, with_base_parameters(reduced_mechanism(robot_, seen_by(needs), inertias_)))
      .first->second;
}

const Mechanism& FunctionMechanisms::in_frames_of_files(unsigned needs) {
  const auto found = in_frames_of_files_.find(needs);
  if (found != in_frames_of_files_.end()) return found->second;
  return in_frames_of_files_
      .emplace(needs, with_base_parameters(mechanism_in_frames_of_files(robot_, seen_by(needs))))
      .first->second;
}

/// The scene without what a function of these needs does not depend on.
Scene FunctionMechanisms::seen_by(unsigned needs) const {
  Scene seen = scene_;
  if ((needs & kPoints) == 0) {
    seen.operational_points.clear();
    seen.objects.clear();
  }
  if ((needs & kForces) == 0) seen.external_forces.clear();
  if ((needs & kContacts) == 0) seen.contacts.clear();
  for_each_of_model([&](Quantity quantity) {
    if ((needs & bit_of(quantity)) == 0) remove_input(quantity, seen);
  });
  if ((needs & kConstraints) == 0) {
    seen.constraints.clear();
    seen.loops.clear();
    seen.couplings.clear();
  }
  return seen;
}

}  // namespace treeline
