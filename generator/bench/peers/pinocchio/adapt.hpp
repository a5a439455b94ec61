#pragma once

#include "bench/peers/make_peer.hpp"
#include "bench/peers/pinocchio/description.hpp"
#include "bench/peers/pinocchio/solver.hpp"

/// What the peers of Pinocchio's algorithms share: this project's robot for them, and their
/// matrices for this project.
namespace treeline::peer::pin {

using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

Description describe(const Robot& robot, const Tell& tell);

/// See `Finish`; `solver` is a Solver<double>. Of symmetric matrices the upper triangle was
/// computed.
void finish_symmetric(void* solver, double* out);
void finish_lambda(void* solver, double* out);
void finish_derivatives(void* solver, double* out);

}  // namespace treeline::peer::pin
