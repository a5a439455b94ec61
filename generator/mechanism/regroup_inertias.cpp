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

}  // namespace

void regroup_inertias(Mechanism& mechanism) {
  for (auto link = mechanism.links.rbegin(); link != mechanism.links.rend(); ++link) {
    resolve_inertia(mechanism, *link);
    if (link->kind == JointKind::floating) {
      continue;
    }
    const bool revolute = link->kind == JointKind::revolute;
    const Exact mass = link->inertia.mass;
    Inertia moved = revolute ? take_rod_on_axis(link->inertia) : take_second_moment(link->inertia);
    ExactPose seat = link->seat;
    if (!revolute) {
      seat.p.setZero();
    }
    Inertia& parent = link->parent < 0
                          ? mechanism.world
                          : mechanism.links[static_cast<std::size_t>(link->parent)].inertia;
    parent = parent + transformed(moved, seat);
    mechanism.notes.push_back(
        {"regroup", link->name,
         revolute ? fmt::format("{:.6g} kg on the joint axis moved to the parent; 7 numbers left",
                                static_cast<double>(mass))
                  : std::string("rotational inertia moved to the parent; 4 numbers left")});
  }
}

}  // namespace treeline
