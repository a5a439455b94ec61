#include "mechanism/add_rotors.hpp"

namespace treeline {
namespace {

/// A wheel on the world's z axis that turns by the coordinate of `driven`.
MovingLink rotor_of(const MovingLink& driven, double inertia) {
  MovingLink rotor;
  rotor.name = driven.joint + " rotor";
  rotor.joint = driven.joint;
  rotor.kind = JointKind::revolute;
  rotor.q_index = driven.q_index;
  rotor.v_index = driven.v_index;
  rotor.multiplier = driven.multiplier;
  rotor.mimics = true;
  rotor.is_rotor = true;
  rotor.inertia.Sigma(0, 0) = rotor.inertia.Sigma(1, 1) = Exact(inertia) / 2;
  return rotor;
}

}  // namespace

void add_rotors(const std::map<std::string, double>& armature, Mechanism& mechanism) {
  const std::size_t links = mechanism.links.size();
  for (std::size_t i = 0; i < links; ++i) {
    const auto found = armature.find(mechanism.links[i].joint);
    if (found == armature.end()) continue;
    mechanism.links.push_back(rotor_of(mechanism.links[i], found->second));
  }
}

}  // namespace treeline
