#pragma once

#include <string>
#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "interpreter/closed_chain.hpp"
#include "interpreter/loops.hpp"
#include "interpreter/model.hpp"

namespace treeline {

/// `Scalar` is float, double or Digits50: for these the functions are compiled, once.

/// Makes the interpreter's model of a robot in a scene, directly from the files' numbers: every
/// link is a body, nothing is lumped or regrouped. Rotations and axes are computed in the precision
/// of `Scalar`. Joint order and coordinates are those of the contract: depth-first from the root,
/// children in the file's order, a floating base first. Fixed, locked and mimic joints have no
/// coordinates. Joints in `scene.locked` have one degree of freedom; a joint that mimics a locked
/// one is locked too.
template <class Scalar>
interpreter::Model<Scalar> model_from_robot(const Robot& robot, const Scene& scene);

/// Velocities without a motor of the model that `model_from_robot` makes: those of floating joints
/// and of joints that the scene calls passive.
template <class Scalar>
std::vector<int> passive_velocities(const interpreter::Model<Scalar>& model, const Robot& robot,
                                    const Scene& scene);

/// Converts a scene's operational points or external forces to points on the model that
/// `model_from_robot` makes. Their links must belong to the robot.
template <class Scalar>
interpreter::Points<Scalar> points_from_scene(const interpreter::Model<Scalar>& model,
                                              const std::vector<ScenePoint>& scene_points);

/// Index of the body of a link.
template <class Scalar>
int find_body(const interpreter::Model<Scalar>& model, const std::string& link);

/// Constraints between links, and between joints.
template <class Scalar>
interpreter::Loops<Scalar> loops_from_scene(const interpreter::Model<Scalar>& model,
                                            const Robot& robot, const Scene& scene);

/// Makes the interpreter's closed chain of a robot that holds the scene's objects, directly from
/// the files' numbers. The points that the grasps name are those of the scene.
/// `Scalar` is double or Digits50.
template <class Scalar>
interpreter::ClosedChain<Scalar> chain_from_scene(const Robot& robot, const Scene& scene);

}  // namespace treeline
