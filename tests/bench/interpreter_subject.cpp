#include <algorithm>

#include "interpreter/instances.hpp"
#include "peers.hpp"

namespace treeline::bench {
namespace {

using interpreter::Vector;

struct Solver {
  interpreter::Model<double> model;
  interpreter::Points<double> points;
  Vector<double> inputs[4];

  void load(const double* const* in, int count) {
    for (int i = 0; i < count; ++i) std::copy_n(in[i], inputs[i].size(), inputs[i].data());
  }
};

Solver& solver(void* self) {
  return *static_cast<Solver*>(self);
}

template <class Result>
void store(const Result& result, double* out) {
  std::copy_n(result.data(), result.size(), out);
}

void inverse_dynamics(void* self, const double* const* in, double* out) {
  auto& s = solver(self);
  s.load(in, 3);
  const auto& [q, qd, qdd, unused] = s.inputs;
  store(interpreter::inverse_dynamics<double>(s.model, q, qd, qdd), out);
}

void forward_dynamics(void* self, const double* const* in, double* out) {
  auto& s = solver(self);
  s.load(in, 3);
  const auto& [q, qd, tau, unused] = s.inputs;
  store(interpreter::forward_dynamics<double>(s.model, q, qd, tau), out);
}

void mass_matrix(void* self, const double* const* in, double* out) {
  auto& s = solver(self);
  s.load(in, 1);
  store(interpreter::mass_matrix<double>(s.model, s.inputs[0]), out);
}

void mass_matrix_inverse(void* self, const double* const* in, double* out) {
  auto& s = solver(self);
  s.load(in, 1);
  const auto M = interpreter::mass_matrix<double>(s.model, s.inputs[0]);
  store(interpreter::Matrix<double>(
            M.ldlt().solve(interpreter::Matrix<double>::Identity(s.model.nv, s.model.nv))),
        out);
}

/// Writes the three matrices row-major, one after the other.
void store(const interpreter::DynamicsDerivatives<double>& derivatives, double* out) {
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  for (const auto* each :
       {&derivatives.by_displacement, &derivatives.by_velocity, &derivatives.by_drive}) {
    Eigen::Map<Rows>(out, each->rows(), each->cols()) = *each;
    out += each->size();
  }
}

void inverse_dynamics_derivatives(void* self, const double* const* in, double* out) {
  auto& s = solver(self);
  s.load(in, 3);
  const auto& [q, qd, qdd, unused] = s.inputs;
  store(interpreter::inverse_dynamics_derivatives<double>(s.model, q, qd, qdd, {}, {}), out);
}

void forward_dynamics_derivatives(void* self, const double* const* in, double* out) {
  auto& s = solver(self);
  s.load(in, 3);
  const auto& [q, qd, tau, unused] = s.inputs;
  store(interpreter::forward_dynamics_derivatives<double>(s.model, q, qd, tau, {}, {}), out);
}

void lambda_inverse(void* self, const double* const* in, double* out) {
  auto& s = solver(self);
  s.load(in, 1);
  store(interpreter::lambda_inverse<double>(s.model, s.points, s.inputs[0]), out);
}

void lambda(void* self, const double* const* in, double* out) {
  auto& s = solver(self);
  s.load(in, 1);
  store(interpreter::lambda<double>(s.model, s.points, s.inputs[0]), out);
}

void control_torque(void* self, const double* const* in, double* out) {
  auto& s = solver(self);
  s.load(in, 4);
  const auto& [q, qd, qdd_0, xdd] = s.inputs;
  store(interpreter::control_torque<double>(s.model, s.points, q, qd, qdd_0, xdd), out);
}

}  // namespace

Subject interpreter_subject(const Case& robot) {
  const int nv = robot.model.nv;
  auto s = std::make_shared<Solver>();
  s->model = robot.model;
  s->points = robot.points;
  const int sizes[] = {robot.model.nq, nv, nv, robot.rows()};
  for (int i = 0; i < 4; ++i) s->inputs[i] = Vector<double>::Zero(sizes[i]);
  return {"interpreter",
          {{Function::inverse_dynamics, {inverse_dynamics, s}},
           {Function::forward_dynamics, {forward_dynamics, s}},
           {Function::mass_matrix, {mass_matrix, s}},
           {Function::lambda_inverse, {lambda_inverse, s}},
           {Function::lambda, {lambda, s}},
           {Function::mass_matrix_inverse, {mass_matrix_inverse, s}},
           {Function::inverse_dynamics_derivatives, {inverse_dynamics_derivatives, s}},
           {Function::forward_dynamics_derivatives, {forward_dynamics_derivatives, s}},
           {Function::control_torque, {control_torque, s}}}};
}

}  // namespace treeline::bench
