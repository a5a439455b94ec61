#include "pinocchio/calls.hpp"
#include "pinocchio/description.hpp"
#include "pinocchio/read_solver.hpp"

namespace treeline::bench::pin {
namespace {

using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Column-major in Pinocchio's order of joints to row-major in ours.
void reorder(const Solver<double>& s, const Eigen::MatrixXd& from, double* to) {
  const Eigen::Index n = s.model.nv;
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index k = 0; k < n; ++k) {
      to[i * n + k] =
          from(s.place[static_cast<std::size_t>(i)], s.place[static_cast<std::size_t>(k)]);
    }
  }
}

Eigen::MatrixXd whole(const double* upper, Eigen::Index n) {
  return Eigen::Map<const Eigen::MatrixXd>(upper, n, n).selfadjointView<Eigen::Upper>();
}

void finish_symmetric(void* solver, double* out) {
  const auto& s = *static_cast<const Solver<double>*>(solver);
  reorder(s, whole(out, s.model.nv), out);
}

void finish_lambda(void* solver, double* out) {
  const auto& s = *static_cast<const Solver<double>*>(solver);
  const Eigen::MatrixXd all = whole(out, s.rows());
  Eigen::Map<Rows>(out, s.rows(), s.rows()) = all;
}

void finish_derivatives(void* solver, double* out) {
  const auto& s = *static_cast<const Solver<double>*>(solver);
  const Eigen::Index n = s.model.nv;
  for (const Eigen::Index matrix : {0, 1}) {
    double* at = out + matrix * n * n;
    reorder(s, Eigen::MatrixXd(Eigen::Map<const Eigen::MatrixXd>(at, n, n)), at);
  }
  finish_symmetric(solver, out + 2 * n * n);
}

}  // namespace

std::vector<Subject> pinocchio_subjects(const Description& description) {
  auto read = read_solver(description);
  if (!read) return {};
  auto s = std::make_shared<Solver<double>>(*std::move(read));
  const auto symmetric = [&](Call call) { return Routine{call, s, 1, finish_symmetric}; };
  const auto derivatives = [&](Call call) { return Routine{call, s, 1, finish_derivatives}; };
  std::vector<Subject> subjects{
      {"Pinocchio",
       {{Function::inverse_dynamics, {call_rnea, s}},
        {Function::forward_dynamics, {call_aba, s}},
        {Function::mass_matrix, symmetric(call_crba)},
        {Function::mass_matrix_inverse, symmetric(call_minverse)},
        {Function::inverse_dynamics_derivatives, derivatives(call_rnea_derivatives)},
        {Function::forward_dynamics_derivatives, derivatives(call_aba_derivatives)}}},
      {"Pinocchio, in world axes",
       {{Function::forward_dynamics, {call_aba_in_world_axes, s}},
        {Function::mass_matrix, symmetric(call_crba_in_world_axes)}}}};
  if (description.points.empty()) return subjects;
  const auto lambda = [](Call call, std::shared_ptr<void> with) {
    return Routine{call, std::move(with), 1, finish_lambda};
  };
  const auto contacts = make_contact_solver(*s);
  subjects.push_back({"Pinocchio, Cholesky of M",
                      {{Function::lambda_inverse, lambda(call_lambda_inverse_by_cholesky, s)},
                       {Function::lambda, lambda(call_lambda_by_cholesky, s)},
                       {Function::control_torque, {call_control_torque, s}}}});
  subjects.push_back({"Pinocchio, computeMinverse",
                      {{Function::lambda_inverse, lambda(call_lambda_inverse_by_minverse, s)}}});
  subjects.push_back({"Pinocchio, EFPA",
                      {{Function::lambda_inverse, lambda(call_lambda_inverse_by_efpa, contacts)}}});
  subjects.push_back({"Pinocchio, PV-OSIM",
                      {{Function::lambda_inverse, lambda(call_lambda_inverse_by_pv, contacts)}}});
  return subjects;
}

}  // namespace treeline::bench::pin
