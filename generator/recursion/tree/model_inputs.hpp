#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "functions/quantity.hpp"
#include "recursion/algebra/parallel_axes.hpp"
#include "recursion/algebra/rotation_from_quaternion.hpp"
#include "recursion/parameters/base_parameters.hpp"
#include "recursion/tree/tree.hpp"

namespace treeline {

/// The ten inertial parameters of a body in a frame. They are linear: those of two bodies that are
/// joined add up.
template <class Scalar>
struct InertialParameters {
  Scalar mass{};
  Vector3<Scalar> h;     ///< first moment m c
  Symmetric3<Scalar> J;  ///< rotational inertia about the frame's origin
};

/// A rotor's inertia, or a coefficient of friction, in place of that of its joint.
template <class Scalar>
struct DriveParameter {
  ModelParameter parameter;
  Scalar value{};
};

/// Values of the arguments about the robot, see `MechanismInputs`. Empty: as in the files.
template <class Scalar>
struct ModelInputs {
  std::optional<Vector3<Scalar>> gravity;
  std::vector<InertialParameters<Scalar>> payloads, parameters;
  std::vector<InertialParameters<Scalar>> base;  ///< of each link, see `realize_base_parameters`
  std::vector<DriveParameter<Scalar>> drives;
  std::vector<Vector3<Scalar>> tools;
  std::vector<Matrix3<Scalar>> orientations;  ///< of those tools whose axes are an argument
  std::vector<Vector3<Scalar>> contacts;
  std::vector<Scalar> shares;  ///< to which tasks are done that come and go
};

template <class Scalar>
Vector3<Scalar> triple_at(const std::vector<Scalar>& entries, std::size_t first) {
  return {entries[first], entries[first + 1], entries[first + 2]};
}

template <class Scalar>
std::vector<Vector3<Scalar>> triples(const std::vector<Scalar>& entries) {
  std::vector<Vector3<Scalar>> vectors;
  for (std::size_t i = 0; i < entries.size(); i += 3) vectors.push_back(triple_at(entries, i));
  return vectors;
}

/// Rotations from an argument that has four entries for each quaternion: x, y, z, w.
template <class Scalar>
std::vector<Matrix3<Scalar>> rotations(const std::vector<Scalar>& entries) {
  std::vector<Matrix3<Scalar>> turns;
  for (std::size_t i = 0; i < entries.size(); i += 4) {
    turns.push_back(
        rotation_from_quaternion(entries[i], entries[i + 1], entries[i + 2], entries[i + 3]));
  }
  return turns;
}

/// Inertial parameters from ten entries for each body: m, m c, Ixx, Ixy, Iyy, Ixz, Iyz, Izz.
template <class Scalar>
std::vector<InertialParameters<Scalar>> inertial_parameters(const std::vector<Scalar>& entries) {
  std::vector<InertialParameters<Scalar>> bodies;
  for (std::size_t at = 0; at < entries.size(); at += kInertialParameters) {
    bodies.push_back({entries[at],
                      triple_at(entries, at + 1),
                      {entries[at + 4], entries[at + 5], entries[at + 7], entries[at + 6],
                       entries[at + 8], entries[at + 9]}});
  }
  return bodies;
}

template <class Scalar>
InertialParameters<Scalar> inertial_parameters(const Inertia& inertia) {
  return {rounded<Scalar>(inertia.mass), rounded<Scalar>(inertia.h),
          rounded_symmetric<Scalar>(rotational_inertia(inertia))};
}

/// Gives links and joints parameters that have these base parameters: each is that of the parameter
/// which it is named after, and all others are 0. No body need have them, but M, b and g depend on
/// the base parameters alone.
template <class Scalar>
void realize_base_parameters(const BaseParameters& found, const std::vector<Scalar>& values,
                             ModelInputs<Scalar>& model) {
  std::vector<Scalar> all(found.parameters.size(), Scalar(0.0));
  for (std::size_t k = 0; k < values.size(); ++k) all[found.base[k].parameter] = values[k];
  std::vector<Scalar> bodies;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (found.parameters[k].is_of_body()) {
      bodies.push_back(all[k]);
    } else {
      model.drives.push_back({found.parameters[k], all[k]});
    }
  }
  model.base = inertial_parameters(bodies);
}

/// Moves a body to another frame, in which its own frame has `pose` (parallel axes).
template <class Scalar>
InertialParameters<Scalar> transformed(const InertialParameters<Scalar>& body,
                                       const Digits50Pose& pose) {
  const Rotation<Scalar> R = planar_factors<Scalar>(pose.R);
  const Vector3<Scalar> p = rounded<Scalar>(pose.p);
  const Vector3<Scalar> h = rotate(R, body.h);
  const Symmetric3<Scalar> shift = parallel_axes_shift(body.mass, h, p);
  return {body.mass, h + p * body.mass, rotate(R, body.J) + shift};
}

/// Adds a body to the link that carries it.
template <class Scalar>
void add_body(const MechanismPoint& frame, const InertialParameters<Scalar>& body,
              Tree<Scalar>& tree) {
  const InertialParameters<Scalar> moved = transformed(body, frame.pose);
  tree.total_mass = tree.total_mass + moved.mass;
  if (frame.link < 0) {
    tree.world_moment = tree.world_moment + moved.h;
    return;
  }
  for (TreeMatter<Scalar>& matter : tree.link_matter) {
    if (matter.link != frame.link) continue;
    matter.mass = matter.mass + moved.mass;
    matter.h = matter.h + moved.h;
  }
  TreeInertia<Scalar>& own = tree.links[static_cast<std::size_t>(frame.link)].inertia;
  own.mass = own.mass + moved.mass;
  own.h = own.h + moved.h;
  own.J = own.J + moved.J;
  const Scalar half = Scalar(0.5) * (own.J.xx + own.J.yy + own.J.zz);
  own.Sigma = {half - own.J.xx, -own.J.xy, -own.J.xz, half - own.J.yy, -own.J.yz, half - own.J.zz};
}

template <class Scalar>
void add_bodies(const Mechanism& mechanism, const ModelInputs<Scalar>& inputs, Tree<Scalar>& tree) {
  const MechanismInputs& places = mechanism.inputs;
  for (std::size_t i = 0; i < inputs.payloads.size(); ++i) {
    add_body(places.payloads[i].frame, inputs.payloads[i], tree);
  }
  for (std::size_t i = 0; i < places.parameters.size(); ++i) {
    const MechanismInertia& place = places.parameters[i];
    add_body(place.frame,
             inputs.parameters.empty() ? inertial_parameters<Scalar>(place.nominal)
                                       : inputs.parameters[i],
             tree);
  }
  for (std::size_t i = 0; i < places.base.size(); ++i) {
    const MechanismInertia& place = places.base[i];
    add_body(place.frame,
             inputs.base.empty() ? inertial_parameters<Scalar>(place.nominal) : inputs.base[i],
             tree);
  }
  const bool changed =
      !inputs.payloads.empty() || !places.parameters.empty() || !places.base.empty();
  if (!changed || tree.total_mass == Scalar(0.0)) return;
  tree.inverse_total_mass = Scalar(1.0) / tree.total_mass;
}

/// Puts the origin of a point where an argument has it in the frame of its link.
template <class Scalar>
void place_origin(const MechanismTool& tool, const Vector3<Scalar>& origin,
                  std::vector<TreePoint<Scalar>>& points) {
  points[tool.point].p = rotate(planar_factors<Scalar>(tool.frame.pose.R), origin) +
                         rounded<Scalar>(tool.frame.pose.p);
}

/// Gives a point the axes that an argument says in those of its link.
template <class Scalar>
void place_axes(const MechanismTool& tool, const Matrix3<Scalar>& turn,
                std::vector<TreePoint<Scalar>>& points) {
  const Rotation<Scalar> R = planar_factors<Scalar>(tool.frame.pose.R);
  const Matrix3<Scalar> columns = transposed(turn);
  points[tool.point].R = transposed(Matrix3<Scalar>{
      rotate(R, columns.row_x), rotate(R, columns.row_y), rotate(R, columns.row_z)});
}

template <class Scalar>
void place_points(const MechanismInputs& places, const ModelInputs<Scalar>& inputs,
                  Tree<Scalar>& tree) {
  for (std::size_t i = 0; i < inputs.tools.size(); ++i) {
    place_origin(places.tools[i], inputs.tools[i], tree.operational_points);
  }
  for (std::size_t i = 0; i < inputs.contacts.size(); ++i) {
    place_origin(places.contacts[i], inputs.contacts[i], tree.contacts);
  }
  for (std::size_t i = 0; i < inputs.shares.size(); ++i) {
    tree.operational_points[places.active_tasks[i]].share = inputs.shares[i];
  }
  if (inputs.orientations.empty()) return;
  std::size_t next = 0;
  for (const MechanismTool& tool : places.tools) {
    if (tool.orientation) place_axes(tool, inputs.orientations[next++], tree.operational_points);
  }
}

/// Puts rotors and friction in place of those of their joints.
template <class Scalar>
void replace_drives(const Mechanism& mechanism, const ModelInputs<Scalar>& inputs,
                    Tree<Scalar>& tree) {
  using DriveKind = ModelParameter::Kind;
  for (const auto& [parameter, value] : inputs.drives) {
    TreeDrive<Scalar>& drive = tree.links[link_of(parameter, mechanism)].drive;
    const Scalar felt = rounded<Scalar>(parameter.factor) * value;
    if (parameter.kind == DriveKind::rotor) drive.inertia = felt;
    if (parameter.kind == DriveKind::viscous) drive.damping = felt;
    if (parameter.kind != DriveKind::coulomb) continue;
    drive.friction = felt;
    drive.sharpness = rounded<Scalar>(parameter.sharpness);
  }
}

/// Makes the constant tree that of a robot with these inputs.
template <class Scalar>
void apply_inputs(const Mechanism& mechanism, const ModelInputs<Scalar>& inputs,
                  Tree<Scalar>& tree) {
  if (inputs.gravity) tree.gravity = *inputs.gravity;
  place_points(mechanism.inputs, inputs, tree);
  add_bodies(mechanism, inputs, tree);
  replace_drives(mechanism, inputs, tree);
}

/// The tree with these inputs; by default that of the files.
template <class Scalar>
Tree<Scalar> tree_of(const Mechanism& mechanism, const ModelInputs<Scalar>& inputs = {}) {
  Tree<Scalar> tree = constant_tree<Scalar>(mechanism);
  apply_inputs(mechanism, inputs, tree);
  return tree;
}

}  // namespace treeline
