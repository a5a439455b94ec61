#pragma once

#include <pinocchio/algorithm/delassus.hpp>

#include "bench/peers/pinocchio/solver.hpp"

/// Pinocchio's own algorithms for J M^-1 J^T in the points' axes, with the rotation to world axes.
namespace treeline::peer::pin {

struct Contacts {
  std::vector<pinocchio::RigidConstraintModel> models;
  std::vector<pinocchio::RigidConstraintData> data;

  explicit Contacts(const Solver<double>& s) {
    for (const auto point : s.points) {
      const auto& frame = s.model.frames[point];
      models.emplace_back(pinocchio::CONTACT_6D, s.model, frame.parentJoint, frame.placement,
                          pinocchio::LOCAL);
      data.emplace_back(models.back());
    }
  }
};

struct ContactSolver : Solver<double> {
  Contacts contacts;
  explicit ContactSolver(const Solver<double>& s) : Solver(s), contacts(s) {
    pinocchio::initPvDelassus(model, data, contacts.models);
  }
};

/// Rotates the upper triangle of D to world axes.
inline void turn_to_world_axes(const ContactSolver& s, Eigen::Map<Eigen::MatrixXd>& D) {
  for (std::size_t i = 0; i < s.points.size(); ++i) {
    for (std::size_t k = i; k < s.points.size(); ++k) {
      for (const int row : {0, 3}) {
        for (const int column : {0, 3}) {
          auto block = D.block<3, 3>(static_cast<Eigen::Index>(6 * i) + row,
                                     static_cast<Eigen::Index>(6 * k) + column);
          const Eigen::Matrix3d turned = s.contacts.data[i].oMc1.rotation() * block;
          block.noalias() = turned * s.contacts.data[k].oMc1.rotation().transpose();
        }
      }
    }
  }
}

/// Lambda^-1 by EFPA, the extended-force-propagator algorithm.
inline void lambda_inverse_by_efpa(ContactSolver& s, const double* const* in, double* out) {
  s.load_position(in[0]);
  Eigen::Map<Eigen::MatrixXd> D(out, s.rows(), s.rows());
  pinocchio::computeDelassusMatrix(s.model, s.data, s.q, s.contacts.models, s.contacts.data, D);
  turn_to_world_axes(s, D);
}

/// Lambda^-1 by PV-OSIM.
inline void lambda_inverse_by_pv(ContactSolver& s, const double* const* in, double* out) {
  s.load_position(in[0]);
  Eigen::Map<Eigen::MatrixXd> D(out, s.rows(), s.rows());
  pinocchio::computePvDelassusMatrix(s.model, s.data, s.q, s.contacts.models, s.contacts.data, D,
                                     0.0);
  turn_to_world_axes(s, D);
}

}  // namespace treeline::peer::pin
