#include "oracle/subject_at.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace treeline {
namespace {

using UnitKind = interpreter::UnitParameter::Kind;

/// The ten inertial parameters of a body.
template <class Scalar>
std::array<Scalar, kInertialParameters> parameters_of(const interpreter::Body<Scalar>& body) {
  const auto h = (body.mass * body.com).eval();
  const auto& J = body.inertia;
  return {body.mass, h(0), h(1), h(2), J(0, 0), J(0, 1), J(1, 1), J(0, 2), J(1, 2), J(2, 2)};
}

template <class Scalar>
void set_parameters(const std::array<Scalar, kInertialParameters>& ten,
                    interpreter::Body<Scalar>& body) {
  body.mass = ten[0];
  body.com = {ten[1], ten[2], ten[3]};
  if (body.mass != Scalar(0)) body.com /= body.mass;
  body.inertia << ten[4], ten[5], ten[7],  //
      ten[5], ten[6], ten[8],              //
      ten[7], ten[8], ten[9];
}

/// Gives a body the ten inertial parameters that begin at `first`.
template <class Scalar>
void set_parameters(const std::vector<double>& entries, std::size_t first,
                    interpreter::Body<Scalar>& body) {
  std::array<Scalar, kInertialParameters> ten;
  for (std::size_t i = 0; i < ten.size(); ++i) ten[i] = Scalar(entries[first + i]);
  set_parameters<Scalar>(ten, body);
}

template <class Scalar>
Scalar value_of(const interpreter::Model<Scalar>& model, const interpreter::UnitParameter& unit) {
  const interpreter::Body<Scalar>& body = model.body(unit.body);
  if (unit.kind == UnitKind::rotor) return body.armature;
  if (unit.kind == UnitKind::viscous) return body.damping;
  if (unit.kind == UnitKind::coulomb) return body.friction;
  return parameters_of(body)[static_cast<std::size_t>(unit.entry)];
}

template <class Scalar>
void add_to(const interpreter::UnitParameter& unit, const Scalar& value,
            interpreter::Model<Scalar>& model) {
  interpreter::Body<Scalar>& body = model.bodies[static_cast<std::size_t>(unit.body)];
  if (unit.kind == UnitKind::rotor) {
    body.armature += value;
  } else if (unit.kind == UnitKind::viscous) {
    body.damping += value;
  } else if (unit.kind == UnitKind::coulomb) {
    body.friction += value;
    body.slip_speed = Scalar(unit.slip_speed);
  } else {
    auto ten = parameters_of(body);
    ten[static_cast<std::size_t>(unit.entry)] += value;
    set_parameters<Scalar>(ten, body);
  }
}

/// Gives the model base parameters: what is missing is added to those parameters that they are
/// named after, which no other base parameter combines.
template <class Scalar>
void set_base_parameters(const std::vector<SubjectBase>& base, const std::vector<double>& entries,
                         interpreter::Model<Scalar>& model) {
  for (std::size_t k = 0; k < entries.size(); ++k) {
    auto missing = static_cast<Scalar>(entries[k]);
    for (const auto& [unit, coefficient] : base[k].terms) {
      missing -= static_cast<Scalar>(coefficient) * value_of(model, unit);
    }
    add_to(base[k].named, missing, model);
  }
}

/// Gives bodies the parameters of a state, in their order; none if the state has none.
template <class Scalar>
void set_all_parameters(const std::vector<SubjectInertia>& bodies,
                        const std::vector<double>& entries, interpreter::Model<Scalar>& model) {
  for (std::size_t i = 0; kInertialParameters * i < entries.size(); ++i) {
    set_parameters(entries, kInertialParameters * i,
                   model.bodies[static_cast<std::size_t>(bodies[i].body)]);
  }
}

template <class Scalar>
void change_model(const SubjectInputs& inputs, const State& state,
                  interpreter::Model<Scalar>& model) {
  const std::vector<double>& gravity = values_of(state, Quantity::gravity);
  if (!gravity.empty()) {
    model.gravity = {Scalar(gravity[0]), Scalar(gravity[1]), Scalar(gravity[2])};
  }
  set_all_parameters(inputs.payloads, values_of(state, Quantity::payload), model);
  set_all_parameters(inputs.parameters, values_of(state, Quantity::parameters), model);
  set_base_parameters(inputs.base, values_of(state, Quantity::base_parameters), model);
}

/// Puts points where a state has their origins; leaves them if it has none.
template <class Scalar>
void place_origins(const std::vector<SubjectTool>& tools, const std::vector<double>& entries,
                   interpreter::Points<Scalar>& points) {
  for (std::size_t i = 0; 3 * i < entries.size(); ++i) {
    points[tools[i].point].p = {Scalar(entries[3 * i]), Scalar(entries[3 * i + 1]),
                                Scalar(entries[3 * i + 2])};
  }
}

/// Gives points the axes of a state's quaternions; leaves them if it has none.
template <class Scalar>
void place_axes(const std::vector<SubjectTool>& tools, const std::vector<double>& entries,
                interpreter::Points<Scalar>& points) {
  if (entries.empty()) return;
  std::size_t first = 0;
  for (const SubjectTool& tool : tools) {
    if (!tool.orientation) continue;
    const auto at = [&](std::size_t i) { return Scalar(entries[first + i]); };
    points[tool.point].R =
        interpreter::rotation_from_quaternion<Scalar>({at(0), at(1), at(2)}, at(3));
    first += 4;
  }
}

/// Whether a state says anything that the model, or a tool, is made of.
bool has_model_inputs(const State& state) {
  return std::ranges::any_of(kQuantities, [&](const QuantityInfo& row) {
    return is_of_model(row.quantity) && !values_of(state, row.quantity).empty();
  });
}

template <class Scalar>
void change(const State& state, Subject<Scalar>& subject) {
  change_model(subject.inputs, state, subject.model);
  for (auto& robot : subject.chain.robots) change_model(subject.inputs, state, robot);
  const SubjectInputs& inputs = subject.inputs;
  place_origins(inputs.tools, values_of(state, Quantity::tool), subject.points);
  place_axes(inputs.tools, values_of(state, Quantity::tool_orientation), subject.points);
  place_origins(inputs.contacts, values_of(state, Quantity::contact), subject.contacts);
  const std::vector<double>& shares = values_of(state, Quantity::active_tasks);
  for (std::size_t i = 0; i < shares.size(); ++i) {
    subject.points[inputs.active_tasks[i]].share = Scalar(shares[i]);
  }
}

}  // namespace

template <class Scalar>
SubjectAt<Scalar>::SubjectAt(const Subject<Scalar>& subject, const State& state)
    : given_(&subject) {
  if (has_model_inputs(state)) change(state, changed_.emplace(subject));
}

template class SubjectAt<float>;
template class SubjectAt<double>;
template class SubjectAt<Digits50>;

namespace {

using interpreter::Digits50;

interpreter::Matrix3<Digits50> matrix_of(const LawAxes& rows) {
  interpreter::Matrix3<Digits50> R;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      R(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = rows[i][j];
    }
  }
  return R;
}

}  // namespace

interpreter::TaskLaw<Digits50> law_at(const TaskLaw* law, const std::vector<double>& q,
                                      const GivenTools& tools) {
  interpreter::TaskLaw<Digits50> result;
  if (law == nullptr) return result;
  result.power = law->rule.power;
  result.borders.assign(law->rule.borders.begin(), law->rule.borders.end());
  for (const LawFrame& frame : law_frames(*law, q, tools)) {
    result.frames.push_back({matrix_of(frame.linear),
                             matrix_of(frame.angular),
                             {frame.shift[0], frame.shift[1], frame.shift[2]}});
  }
  for (std::size_t k = 0; k < law->pivots.size(); ++k) {
    const int first = law->kind == TaskLaw::Kind::jacobian && k >= 3 ? 3 : 0;
    result.pivots.emplace_back(first + static_cast<int>(law->pivots[k].row),
                               first + static_cast<int>(law->pivots[k].column));
  }
  return result;
}

std::shared_ptr<const TaskLaw> law_of_sizes(const std::shared_ptr<const TaskLaw>& law) {
  if (!law || law->kind != TaskLaw::Kind::jacobian) return law;
  return TaskLaws(*law->mechanism).find(TaskLaw::Kind::inverse_inertia, law->points, {});
}

}  // namespace treeline
