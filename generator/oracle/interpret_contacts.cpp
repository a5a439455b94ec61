#include "oracle/interpret_contacts.hpp"

#include <stdexcept>
#include <string>

#include "interpreter/instances.hpp"
#include "oracle/entries.hpp"

namespace treeline {
template <class Scalar>
std::vector<Scalar> interpret_contacts(Function function, const Subject<Scalar>& subject,
                                       const State& state,
                                       const interpreter::TaskLaw<Scalar>& law) {
  const auto& model = subject.model;
  const auto& contacts = subject.contacts;
  const auto q = vector_of<Scalar>(state.q);
  const auto other = [&](Quantity quantity) {
    return vector_of<Scalar>(values_of(state, quantity));
  };
  std::vector<Scalar> entries;
  switch (function) {
    case Function::contact_motion: {
      const auto motion =
          interpreter::contact_motion<Scalar>(model, contacts, q, vector_of<Scalar>(state.qd));
      append(motion.position, entries);
      append(motion.velocity, entries);
      return entries;
    }
    case Function::contact_inverse_inertia:
      append(interpreter::contact_inverse_inertia<Scalar>(model, contacts, q), entries);
      return entries;
    case Function::effective_mass:
      append(law.borders.empty() ? interpreter::effective_masses<Scalar>(model, contacts, q,
                                                                         other(Quantity::normals))
                                 : interpreter::effective_masses<Scalar>(
                                       model, contacts, q, other(Quantity::normals), law),
             entries);
      return entries;
    case Function::impulse_response:
      append(
          interpreter::impulse_response<Scalar>(model, contacts, q, other(Quantity::impulse)).dqd,
          entries);
      return entries;
    case Function::link_inverse_inertias: {
      const auto Omega = interpreter::link_inverse_inertias<Scalar>(model, q);
      for (int i = 0; i < model.size(); ++i) {
        if (model.body(i).kind != interpreter::JointKind::fixed) append(Omega[i], entries);
      }
      return entries;
    }
    default:
      throw std::logic_error(std::string(function_name(function)) + " is not about contacts");
  }
}

template std::vector<float> interpret_contacts(Function, const Subject<float>&, const State&,
                                               const interpreter::TaskLaw<float>&);
template std::vector<double> interpret_contacts(Function, const Subject<double>&, const State&,
                                                const interpreter::TaskLaw<double>&);
template std::vector<interpreter::Digits50> interpret_contacts(
    Function, const Subject<interpreter::Digits50>&, const State&,
    const interpreter::TaskLaw<interpreter::Digits50>&);

interpreter::Points<double> link_frames(const interpreter::Model<double>& model) {
  interpreter::Points<double> frames;
  for (int i = 0; i < model.size(); ++i) {
    if (model.body(i).kind == interpreter::JointKind::fixed) continue;
    interpreter::OperationalPoint<double> frame;
    frame.body = i;
    frame.axes = interpreter::PointAxes::local;
    frames.push_back(frame);
  }
  return frames;
}

}  // namespace treeline
