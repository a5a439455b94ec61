#include "interpreter/loop_instances.hpp"
#include "oracle/entries.hpp"
#include "oracle/interpret.hpp"

namespace treeline {
namespace {

template <class Scalar>
interpreter::ConstrainedMotion<Scalar> constrained_motion(const Subject<Scalar>& subject,
                                                          const State& state,
                                                          const interpreter::TaskLaw<Scalar>& law) {
  const auto gains = vector_of<Scalar>(values_of(state, Quantity::stabilisation));
  const std::vector<double>& step = values_of(state, Quantity::step);
  const interpreter::ConstrainedState<Scalar> at{
      vector_of<Scalar>(state.q),
      vector_of<Scalar>(state.qd),
      vector_of<Scalar>(state.tau),
      vector_of<Scalar>(values_of(state, Quantity::drift)),
      gains(0),
      gains(1),
      subject.external,
      vector_of<Scalar>(state.f_ext),
      subject.loops,
      Scalar(step.empty() ? 0.0 : step.front()),
      held_shares(subject, state)};
  if (!law.pivots.empty()) {
    return interpreter::eliminated_forward_dynamics<Scalar>(subject.model, at, law);
  }
  return law.borders.empty() ? interpreter::constrained_forward_dynamics<Scalar>(
                                   subject.model, subject.constraints, at)
                             : interpreter::constrained_forward_dynamics<Scalar>(
                                   subject.model, subject.constraints, at, law);
}

template <class Scalar>
interpreter::SupportedTorque<Scalar> supported_torque(
    const interpreter::Model<Scalar>& model, const interpreter::SupportedTask<Scalar>& task,
    const interpreter::Vector<Scalar>& q, const interpreter::Vector<Scalar>& qd,
    const interpreter::TaskLaw<Scalar>& law) {
  if (!law.pivots.empty()) {
    return interpreter::eliminated_control_torque<Scalar>(model, task, q, qd, law);
  }
  return law.borders.empty() ? interpreter::supported_control_torque<Scalar>(model, task, q, qd)
                             : interpreter::supported_control_torque<Scalar>(
                                   model, task, q, qd, interpreter::split_law<Scalar>(law, task));
}

}  // namespace

template <class Scalar>
std::vector<Scalar> interpret_constraints(Function function, const Subject<Scalar>& subject,
                                          const State& state,
                                          const interpreter::TaskLaw<Scalar>& law) {
  std::vector<Scalar> entries;
  const auto q = vector_of<Scalar>(state.q);
  if (function == Function::constraint_jacobian) {
    append(interpreter::detail::held_jacobian<Scalar>(subject.model, subject.constraints,
                                                      subject.loops, q),
           entries);
    return entries;
  }
  if (function == Function::constraint_errors) {
    append(interpreter::loop_errors<Scalar>(subject.model, subject.loops, q), entries);
    return entries;
  }
  if (function == Function::constrained_forward_dynamics) {
    const auto motion = constrained_motion(subject, state, law);
    append(motion.qdd, entries);
    append(motion.f, entries);
    return entries;
  }
  const auto task = supported_task(subject, state);
  const auto torque =
      supported_torque<Scalar>(subject.model, task, q, vector_of<Scalar>(state.qd), law);
  append(torque.tau, entries);
  append(torque.f, entries);
  return entries;
}

template std::vector<float> interpret_constraints(Function, const Subject<float>&, const State&,
                                                  const interpreter::TaskLaw<float>&);
template std::vector<double> interpret_constraints(Function, const Subject<double>&, const State&,
                                                   const interpreter::TaskLaw<double>&);
template std::vector<interpreter::Digits50> interpret_constraints(
    Function, const Subject<interpreter::Digits50>&, const State&,
    const interpreter::TaskLaw<interpreter::Digits50>&);

}  // namespace treeline
