#include <fmt/format.h>

#include "mechanism/build_mechanism.hpp"

namespace treeline {
namespace {

/// Takes the rod on the joint axis out of a revolute link's inertia. Matter on z does not move in
/// the parent's frame. The rod has the link's mass, its first moment along z, and Sigma_zz.
Inertia take_rod_on_axis(Inertia& inertia) {
  Inertia rod;
  rod.mass = inertia.mass;
  rod.h(2) = inertia.h(2);
  rod.Sigma(2, 2) = inertia.Sigma(2, 2);
  inertia.mass = inertia.h(2) = inertia.Sigma(2, 2) = 0;
  return rod;
}

/// Takes the second moment out of a prismatic link's inertia. The link has the angular velocity of
/// its parent, and the second moment depends on nothing else, wherever it is.
Inertia take_second_moment(Inertia& inertia) {
  Inertia moment;
  moment.Sigma = inertia.Sigma;
  inertia.Sigma.setZero();
  return moment;
}

/// Takes the mass at the centre of a ball joint, which does not move in the parent's frame.
Inertia take_mass_at_centre(Inertia& inertia) {
  Inertia point;
  point.mass = inertia.mass;
  inertia.mass = 0;
  return point;
}

/// Takes the part of an inertia that the joint does not move, or only turns with its parent.
Inertia take_unmoved(const JointStep& joint, Inertia& inertia) {
  if (joint.is_of_ball()) return take_mass_at_centre(inertia);
  return joint.kind == JointKind::revolute ? take_rod_on_axis(inertia)
                                           : take_second_moment(inertia);
}

std::string describe(const JointStep& joint, const Digits50& mass) {
  if (joint.kind == JointKind::prismatic) {
    return "rotational inertia moved to the parent; 4 numbers left";
  }
  return joint.is_of_ball()
             ? fmt::format("{:.6g} kg at the joint's centre moved to the parent; 9 numbers left",
                           static_cast<double>(mass))
             : fmt::format("{:.6g} kg on the joint axis moved to the parent; 7 numbers left",
                           static_cast<double>(mass));
}

}  // namespace

void regroup_inertias(Mechanism& mechanism) {
  for (auto link = mechanism.links.rbegin(); link != mechanism.links.rend(); ++link) {
    resolve_inertia(mechanism, *link);
    if (link->is_floating()) {
      continue;
    }
    const Digits50 mass = link->inertia.mass;
    Inertia moved = take_unmoved(*link, link->inertia);
    Digits50Pose placement = link->placement;
    if (link->kind == JointKind::prismatic) {
      placement.p.setZero();
    }
    Inertia& parent = link->parent < 0
                          ? mechanism.world
                          : mechanism.links[static_cast<std::size_t>(link->parent)].inertia;
    parent = parent + transformed(moved, placement);
    if (link->is_continued()) continue;  // a massless step on the way to the parent
    mechanism.notes.push_back({"regroup", link->name, describe(*link, mass)});
  }
}

}  // namespace treeline
