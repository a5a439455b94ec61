#include "oracle/interpret_objects.hpp"

#include <stdexcept>
#include <string>

#include "interpreter/instances.hpp"
#include "oracle/entries.hpp"

namespace treeline {
namespace {

template <class Scalar>
std::vector<Scalar> object_state(const Subject<Scalar>& subject,
                                 const interpreter::PerRobot<Scalar>& q,
                                 const interpreter::PerRobot<Scalar>& qd) {
  std::vector<Scalar> position, rotation, velocity, drift, drift_rate;
  for (const auto& held : interpreter::held_poses<Scalar>(subject.chain, q, qd)) {
    append(held.front().p, position);
    append(held.front().R, rotation);
    append(held.front().v, velocity);
    for (std::size_t i = 1; i < held.size(); ++i) {
      const auto apart = interpreter::grasp_drift(held.front(), held[i]);
      append(apart.pose, drift);
      append(apart.velocity, drift_rate);
    }
  }
  for (const auto* part : {&rotation, &velocity, &drift, &drift_rate}) {
    position.insert(position.end(), part->begin(), part->end());
  }
  return position;
}

}  // namespace

template <class Scalar>
std::vector<Scalar> interpret_objects(Function function, const Subject<Scalar>& subject,
                                      const State& state, const interpreter::TaskLaw<Scalar>& law) {
  const auto other = [&](Quantity quantity) {
    return vector_of<Scalar>(values_of(state, quantity));
  };
  const interpreter::PerRobot<Scalar> q{vector_of<Scalar>(state.q)};
  const interpreter::PerRobot<Scalar> qd{vector_of<Scalar>(state.qd)};
  switch (function) {
    case Function::object_state:
      return object_state(subject, q, qd);
    case Function::object_control_torque:
      return entries_of(interpreter::object_control_torque<Scalar>(
                            subject.chain, q, qd, {vector_of<Scalar>(state.qdd)},
                            other(Quantity::xdd_object), other(Quantity::internal), law)
                            .front());
    case Function::object_forward_dynamics: {
      const auto gains = other(Quantity::stabilisation);
      const interpreter::PerRobot<Scalar> tau{vector_of<Scalar>(state.tau)};
      const interpreter::Stabilisation<Scalar> stabilisation{gains(0), gains(1)};
      const auto motion = law.borders.empty() ? interpreter::object_forward_dynamics<Scalar>(
                                                    subject.chain, q, qd, tau, stabilisation)
                                              : interpreter::object_forward_dynamics<Scalar>(
                                                    subject.chain, q, qd, tau, stabilisation, law);
      std::vector<Scalar> entries = entries_of(motion.qdd.front());
      append(motion.xdd_object, entries);
      append(motion.f_grasp, entries);
      append(motion.internal, entries);
      return entries;
    }
    default:
      throw std::logic_error(std::string(function_name(function)) + " is not about objects");
  }
}

template std::vector<float> interpret_objects(Function, const Subject<float>&, const State&,
                                              const interpreter::TaskLaw<float>&);
template std::vector<double> interpret_objects(Function, const Subject<double>&, const State&,
                                               const interpreter::TaskLaw<double>&);
template std::vector<interpreter::Digits50> interpret_objects(
    Function, const Subject<interpreter::Digits50>&, const State&,
    const interpreter::TaskLaw<interpreter::Digits50>&);

}  // namespace treeline
