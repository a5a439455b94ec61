#pragma once

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "interpreter/closed_chain.hpp"

namespace treeline {

/// Makes the interpreter's closed chain of a robot that holds the scene's objects, directly from
/// the files' numbers. The points that the grasps name are those of the scene.
/// `Scalar` is double or Digits50.
template <class Scalar>
interpreter::ClosedChain<Scalar> chain_from_scene(const Robot& robot, const Scene& scene);

}  // namespace treeline
