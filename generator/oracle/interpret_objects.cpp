#include <array>

#include "functions/function_table.hpp"
#include "interpreter/instances.hpp"
#include "oracle/entries.hpp"
#include "oracle/interpret.hpp"

namespace treeline {
namespace {

/// A subject at one state, with the law by which rows of the grasps yield.
template <class Scalar>
struct ObjectInputs {
  const Subject<Scalar>& subject;
  const State& state;
  const interpreter::TaskLaw<Scalar>& law;
  interpreter::PerRobot<Scalar> q{vector_of<Scalar>(state.q)};
  interpreter::PerRobot<Scalar> qd{vector_of<Scalar>(state.qd)};

  [[nodiscard]] interpreter::Vector<Scalar> other(Quantity quantity) const {
    return vector_of<Scalar>(values_of(state, quantity));
  }
};

template <class Scalar>
std::vector<Scalar> object_state(const ObjectInputs<Scalar>& in) {
  std::vector<Scalar> position, rotation, velocity, drift, drift_rate;
  for (const auto& held : interpreter::held_poses<Scalar>(in.subject.chain, in.q, in.qd)) {
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

template <class Scalar>
std::vector<Scalar> object_control_torque(const ObjectInputs<Scalar>& in) {
  return entries_of(interpreter::object_control_torque<Scalar>(
                        in.subject.chain, in.q, in.qd, {vector_of<Scalar>(in.state.qdd)},
                        in.other(Quantity::xdd_object), in.other(Quantity::internal), in.law)
                        .front());
}

template <class Scalar>
std::vector<Scalar> object_forward_dynamics(const ObjectInputs<Scalar>& in) {
  const auto gains = in.other(Quantity::stabilisation);
  const interpreter::PerRobot<Scalar> tau{vector_of<Scalar>(in.state.tau)};
  const interpreter::Stabilisation<Scalar> stabilisation{gains(0), gains(1)};
  const auto motion = in.law.borders.empty()
                          ? interpreter::object_forward_dynamics<Scalar>(in.subject.chain, in.q,
                                                                         in.qd, tau, stabilisation)
                          : interpreter::object_forward_dynamics<Scalar>(
                                in.subject.chain, in.q, in.qd, tau, stabilisation, in.law);
  std::vector<Scalar> entries = entries_of(motion.qdd.front());
  append(motion.xdd_object, entries);
  append(motion.f_grasp, entries);
  append(motion.internal, entries);
  return entries;
}

template <class Scalar>
struct ObjectRow {
  Function function;
  std::vector<Scalar> (*results)(const ObjectInputs<Scalar>& in);
};

template <class Scalar>
constexpr auto kOfObjects = std::to_array<ObjectRow<Scalar>>(
    {{Function::object_state, object_state<Scalar>},
     {Function::object_control_torque, object_control_torque<Scalar>},
     {Function::object_forward_dynamics, object_forward_dynamics<Scalar>}});
static_assert(covers<is_about<FunctionGroup::objects>>(kOfObjects<double>));

}  // namespace

template <class Scalar>
std::vector<Scalar> interpret_objects(Function function, const Subject<Scalar>& subject,
                                      const State& state, const interpreter::TaskLaw<Scalar>& law) {
  return find_row(kOfObjects<Scalar>, function)->results({subject, state, law});
}

template std::vector<float> interpret_objects(Function, const Subject<float>&, const State&,
                                              const interpreter::TaskLaw<float>&);
template std::vector<double> interpret_objects(Function, const Subject<double>&, const State&,
                                               const interpreter::TaskLaw<double>&);
template std::vector<interpreter::Digits50> interpret_objects(
    Function, const Subject<interpreter::Digits50>&, const State&,
    const interpreter::TaskLaw<interpreter::Digits50>&);

}  // namespace treeline
