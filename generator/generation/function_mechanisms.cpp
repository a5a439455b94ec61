#include "generation/function_mechanisms.hpp"

#include "description/check_scene.hpp"
#include "mechanism/build_mechanism.hpp"

namespace treeline {

const Mechanism& FunctionMechanisms::of(Function function) {
  const bool points = needs_points(function) || needs_objects(function);
  const bool forces = takes_external_forces(function);
  const bool contacts = needs_contacts(function);
  const unsigned needs = (points ? 1U : 0U) | (forces ? 2U : 0U) | (contacts ? 4U : 0U);
  const auto found = by_needs_.find(needs);
  if (found != by_needs_.end()) return found->second;
  Scene seen = scene_;
  if (!points) {
    seen.operational_points.clear();
    seen.objects.clear();
  }
  if (!forces) seen.external_forces.clear();
  if (!contacts) seen.contacts.clear();
  return by_needs_.emplace(needs, reduced_mechanism(robot_, seen, inertias_)).first->second;
}

}  // namespace treeline
