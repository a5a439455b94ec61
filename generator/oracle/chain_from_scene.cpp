#include "oracle/chain_from_scene.hpp"

#include <array>
#include <utility>

#include "description/rotation.hpp"
#include "interpreter/digits50.hpp"
#include "oracle/model_from_robot.hpp"

namespace treeline {

template <class Scalar>
interpreter::ClosedChain<Scalar> chain_from_scene(const Robot& robot, const Scene& scene) {
  interpreter::ClosedChain<Scalar> chain;
  chain.robots.push_back(model_from_robot<Scalar>(robot, scene));
  const auto points = points_from_scene(chain.robots.front(), scene.operational_points);
  const auto vector = [](const std::array<double, 3>& xyz) {
    return interpreter::Vector3<Scalar>(Scalar(xyz[0]), Scalar(xyz[1]), Scalar(xyz[2]));
  };
  for (const SceneObject& from : scene.objects) {
    const Inertial& body = from.inertial;
    interpreter::GraspedObject<Scalar> object;
    object.name = from.name;
    object.mass = Scalar(body.mass);
    object.com = vector(body.origin.xyz);
    object.inertia << Scalar(body.ixx), Scalar(body.ixy), Scalar(body.ixz),  //
        Scalar(body.ixy), Scalar(body.iyy), Scalar(body.iyz),                //
        Scalar(body.ixz), Scalar(body.iyz), Scalar(body.izz);
    for (const SceneGrasp& grasp : from.grasps) {
      for (const auto& point : points) {
        if (point.name == grasp.point) {
          object.grasps.push_back(
              {0, point, rotation_from_rpy<Scalar>(grasp.origin.rpy), vector(grasp.origin.xyz)});
        }
      }
    }
    chain.objects.push_back(std::move(object));
  }
  return chain;
}

template interpreter::ClosedChain<double> chain_from_scene(const Robot&, const Scene&);
template interpreter::ClosedChain<Digits50> chain_from_scene(const Robot&, const Scene&);

}  // namespace treeline
