#pragma once

#include "description/heaviest_rows.hpp"
#include "interpreter/damped_torque.hpp"
#include "interpreter/points.hpp"
#include "oracle/chain_from_scene.hpp"
#include "oracle/entries.hpp"
#include "oracle/model_from_robot.hpp"

namespace treeline {

/// Robot and scene in the interpreter's types.
template <class Scalar>
struct Subject {
  interpreter::Model<Scalar> model;
  interpreter::Points<Scalar> points;    ///< operational points
  interpreter::Points<Scalar> external;  ///< where external forces act
  interpreter::Points<Scalar> contacts;
  interpreter::Points<Scalar> constraints;  ///< whose rows are held
  std::vector<int> passive;                 ///< velocities without a motor
  interpreter::ClosedChain<Scalar> chain;   ///< with the objects that the robot holds
  interpreter::Damping<Scalar> damping;     ///< empty if the scene asks for no damping
};

template <class Scalar>
Subject<Scalar> make_subject(const Robot& robot, const Scene& scene) {
  Subject<Scalar> subject;
  subject.model = model_from_robot<Scalar>(robot, scene);
  subject.points = points_from_scene(subject.model, scene.operational_points);
  subject.external = points_from_scene(subject.model, scene.external_forces);
  subject.contacts = points_from_scene(subject.model, scene.contacts);
  subject.constraints = points_from_scene(subject.model, scene.constraints);
  subject.passive = passive_velocities(subject.model, robot, scene);
  if (!scene.objects.empty()) subject.chain = chain_from_scene<Scalar>(robot, scene);
  subject.damping.heaviest = vector_of<Scalar>(heaviest_rows(scene));
  // The values of `core::add_damping_by_directions`.
  subject.damping.resolution = Scalar(scene.real == Real::float32 ? 0x1p-17 : 0x1p-46);
  return subject;
}

/// Converts every number to another type, rounding it once.
template <class To, class From>
Subject<To> cast(const Subject<From>& subject) {
  return {interpreter::cast<To>(subject.model),       interpreter::cast<To>(subject.points),
          interpreter::cast<To>(subject.external),    interpreter::cast<To>(subject.contacts),
          interpreter::cast<To>(subject.constraints), subject.passive,
          interpreter::cast<To>(subject.chain),       interpreter::cast<To>(subject.damping)};
}

}  // namespace treeline
