#pragma once

#include <string>
#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "mechanism/mechanism.hpp"

namespace treeline {

/// Number of components that are not zero.
int nonzeros(const Digits50Vector3& v);

/// Operations that a constant pose costs in the recursions.
int pose_cost(const Digits50Pose& pose);

/// Operations that a link's placement and the offset of its angle cost in the recursions.
int link_cost(const MovingLink& link);

/// Whether the z axes of both frames are parallel.
bool is_parallel(const Digits50Matrix3& R);

/// Decomposes R = Rz(a) Rx(alpha) Rz(b) and returns b, or a + b if alpha is a multiple of pi.
Digits50 right_turn(const Digits50Matrix3& R);

/// Moves the rotation about z at the end of a revolute link's placement to the joint angle, if that
/// is cheaper.
void absorb_turn(MovingLink& link, const Resolution& resolution, Change* change);

/// Cost of the link after `absorb_turn`, if its placement were this one. It takes functions of
/// angles only where the joint has an offset already: in 50 digits they are most of the work.
int absorbed_cost(const MovingLink& link, const Digits50Pose& placement,
                  const Resolution& resolution);

/// Puts rotors, friction and springs of the scene into their joints. A rotor adds its inertia to
/// its coordinate's entry on the diagonal of M and nothing else, no weight and no gyroscopic
/// moment: the usual model of a motor behind a large gear ratio (RBDA section 9.6). Of a joint that
/// mimics, position = m q + o, a coordinate feels m^2 times the inertia, damping and stiffness.
void add_drives(const Scene& scene, Mechanism& mechanism);

/// Whether the link's inertial parameters are an argument, so that no link contains those of the
/// file.
bool has_parameters_as_input(const Scene& scene, const std::string& link);

/// Finds what the scene's `inputs` name in the robot. `frames`: where the frames of all links of
/// the URDF are, in its order.
MechanismInputs place_inputs(const Robot& robot, const Scene& scene,
                             const std::vector<MechanismPoint>& frames);

/// Takes all that moves out of the mechanism's links: base parameters stand in its place.
void take_base_parameters(Mechanism& mechanism);

/// Inertia of a moving link together with those parameters of the file that are arguments.
Inertia nominal_inertia(const Mechanism& mechanism, int link);

/// Place of a link of the URDF: its moving link, -1 for the world, and its pose there.
struct LinkPlace {
  int link = -1;
  Digits50Pose pose;
};

/// Index of a joint's first coordinate and velocity; -1 for a joint that does not move.
struct FirstCoordinate {
  int q, v;
};

/// The robot and the scene with the places of links and joints in the mechanism.
struct PlacedRobot {
  const Robot& robot;
  const Scene& scene;
  const std::vector<LinkPlace>& links;         ///< in the order of the robot's links
  const std::vector<FirstCoordinate>& joints;  ///< in the order of the robot's joints
};

/// Returns the pose with its structure made exact, and records in the mechanism what was changed,
/// under the name `element`.
Digits50Pose resolved_as(const Digits50Pose& pose, const std::string& element,
                         Mechanism& mechanism);

/// Adds all that the scene attaches to links or names of joints: points, forces, contacts, objects,
/// constraints, loops, couplings, passive joints, payloads and inputs.
void place_scene(const PlacedRobot& placed, Mechanism& mechanism);

}  // namespace treeline
