#include "recursion/tree/lift_tree.hpp"

namespace treeline {
namespace {

Vector3<Expression> lift(const Vector3<DoubleDouble>& v) {
  return {v.x, v.y, v.z};
}

Matrix3<Expression> lift(const Matrix3<DoubleDouble>& A) {
  return {lift(A.row_x), lift(A.row_y), lift(A.row_z)};
}

Symmetric3<Expression> lift(const Symmetric3<DoubleDouble>& A) {
  return {A.xx, A.xy, A.xz, A.yy, A.yz, A.zz};
}

PlanarRotation<Expression> lift(const PlanarRotation<DoubleDouble>& r) {
  return {r.c, r.s};
}

Rotation<Expression> lift(const Rotation<DoubleDouble>& R) {
  return {lift(R.a), lift(R.alpha), lift(R.b)};
}

TreeInertia<Expression> lift(const TreeInertia<DoubleDouble>& inertia) {
  return {inertia.mass, lift(inertia.h), lift(inertia.Sigma), lift(inertia.J)};
}

TreeDrive<Expression> lift(const TreeDrive<DoubleDouble>& drive) {
  return {drive.inertia,   drive.damping,   drive.friction,
          drive.sharpness, drive.stiffness, drive.rest};
}

TreeLink<Expression> lift(const TreeLink<DoubleDouble>& link, const MovingLink& choices) {
  return {link,
          link.name,
          link.parent,
          link.q_index,
          link.v_index,
          link.multiplier,
          link.offset,
          lift(link.R),
          lift(link.p),
          lift(link.inertia),
          choices.defers_rotation,
          choices.carries_column,
          choices.spins,
          lift(link.drive)};
}

TreePoint<Expression> lift(const TreePoint<DoubleDouble>& point) {
  return {point.name, point.link, lift(point.R),  lift(point.p),
          point.axes, point.rows, point.priority, point.center_of_mass};
}

std::vector<TreePoint<Expression>> lift(const std::vector<TreePoint<DoubleDouble>>& points) {
  std::vector<TreePoint<Expression>> lifted;
  for (const TreePoint<DoubleDouble>& point : points) lifted.push_back(lift(point));
  return lifted;
}

std::optional<TreeRolling<Expression>> lift(
    const std::optional<TreeRolling<DoubleDouble>>& rolling) {
  if (!rolling) return std::nullopt;
  TreeRolling<Expression> lifted{rolling->radius, std::nullopt, std::nullopt};
  if (rolling->axis) lifted.axis = lift(*rolling->axis);
  if (rolling->on_radius) lifted.on_radius = Expression(*rolling->on_radius);
  return lifted;
}

TreeLoop<Expression> lift(const TreeLoop<DoubleDouble>& loop) {
  return {lift(loop.first), lift(loop.second), lift(loop.rolling)};
}

}  // namespace

Tree<Expression> lift_tree(const Tree<DoubleDouble>& constants, const Mechanism& mechanism) {
  Tree<Expression> tree;
  for (std::size_t i = 0; i < constants.links.size(); ++i) {
    tree.links.push_back(lift(constants.links[i], mechanism.links[i]));
  }
  tree.operational_points = lift(constants.operational_points);
  tree.external_forces = lift(constants.external_forces);
  tree.contacts = lift(constants.contacts);
  for (const TreeLoop<DoubleDouble>& loop : constants.loops) tree.loops.push_back(lift(loop));
  tree.couplings = constants.couplings;
  tree.link_frames = lift(constants.link_frames);
  tree.payload_frames = lift(constants.payload_frames);
  for (const TreeMatter<DoubleDouble>& matter : constants.link_matter) {
    tree.link_matter.push_back({matter.link, matter.mass, lift(matter.h)});
  }
  tree.world_moment = lift(constants.world_moment);
  tree.total_mass = constants.total_mass;
  tree.inverse_total_mass = constants.inverse_total_mass;
  tree.gravity = lift(constants.gravity);
  tree.nq = constants.nq;
  tree.nv = constants.nv;
  tree.has_mimics = constants.has_mimics;
  tree.has_world_matter = constants.has_world_matter;
  mark_limbs(mechanism, tree);
  return tree;
}

}  // namespace treeline
