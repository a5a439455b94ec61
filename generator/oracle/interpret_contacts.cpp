#include <array>

#include "functions/function_table.hpp"
#include "interpreter/instances.hpp"
#include "oracle/entries.hpp"
#include "oracle/interpret.hpp"

namespace treeline {
namespace {

/// A subject at one state, with the law by which effective masses are capped.
template <class Scalar>
struct ContactInputs {
  const Subject<Scalar>& subject;
  const State& state;
  const interpreter::TaskLaw<Scalar>& law;
  interpreter::Vector<Scalar> q = vector_of<Scalar>(state.q);

  [[nodiscard]] interpreter::Vector<Scalar> other(Quantity quantity) const {
    return vector_of<Scalar>(values_of(state, quantity));
  }
};

template <class Scalar>
std::vector<Scalar> contact_motion(const ContactInputs<Scalar>& in) {
  const auto motion = interpreter::contact_motion<Scalar>(in.subject.model, in.subject.contacts,
                                                          in.q, vector_of<Scalar>(in.state.qd));
  std::vector<Scalar> entries = entries_of(motion.position);
  append(motion.velocity, entries);
  return entries;
}

template <class Scalar>
std::vector<Scalar> effective_masses(const ContactInputs<Scalar>& in) {
  const auto& [subject, state, law, q] = in;
  const auto normals = in.other(Quantity::normals);
  return entries_of(law.borders.empty() ? interpreter::effective_masses<Scalar>(
                                              subject.model, subject.contacts, q, normals)
                                        : interpreter::effective_masses<Scalar>(
                                              subject.model, subject.contacts, q, normals, law));
}

template <class Scalar>
std::vector<Scalar> link_inverse_inertias(const ContactInputs<Scalar>& in) {
  const auto& model = in.subject.model;
  const auto Omega = interpreter::link_inverse_inertias<Scalar>(model, in.q);
  std::vector<Scalar> entries;
  for (int i = 0; i < model.size(); ++i) {
    if (model.body(i).kind != interpreter::JointKind::fixed) append(Omega[i], entries);
  }
  return entries;
}

template <class Scalar>
struct ContactRow {
  Function function;
  std::vector<Scalar> (*results)(const ContactInputs<Scalar>& in);
};

template <class Scalar>
constexpr auto kOfContacts = std::to_array<ContactRow<Scalar>>({
    {Function::contact_motion, contact_motion<Scalar>},
    {Function::contact_inverse_inertia,
     [](const ContactInputs<Scalar>& in) {
       return entries_of(interpreter::contact_inverse_inertia<Scalar>(in.subject.model,
                                                                      in.subject.contacts, in.q));
     }},
    {Function::effective_mass, effective_masses<Scalar>},
    {Function::impulse_response,
     [](const ContactInputs<Scalar>& in) {
       return entries_of(interpreter::impulse_response<Scalar>(in.subject.model,
                                                               in.subject.contacts, in.q,
                                                               in.other(Quantity::impulse))
                             .dqd);
     }},
    {Function::link_inverse_inertias, link_inverse_inertias<Scalar>},
});
static_assert(covers<is_about<FunctionGroup::contacts, FunctionGroup::links>>(kOfContacts<double>));

}  // namespace

template <class Scalar>
std::vector<Scalar> interpret_contacts(Function function, const Subject<Scalar>& subject,
                                       const State& state,
                                       const interpreter::TaskLaw<Scalar>& law) {
  return find_row(kOfContacts<Scalar>, function)->results({subject, state, law});
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
