#pragma once

#include <pinocchio/algorithm/constrained-dynamics.hpp>

#include "bench/peers/pinocchio/description.hpp"
#include "bench/peers/pinocchio/solver.hpp"

/// Pinocchio's forward dynamics with rows held.
namespace treeline::peer::pin {

struct ConstraintSolver : Solver<double> {
  std::vector<pinocchio::RigidConstraintModel> models;
  std::vector<pinocchio::RigidConstraintData> held;
  pinocchio::ProximalSettings settings;

  ConstraintSolver(const Solver<double>& s, const std::vector<Held>& constraints,
                   const pinocchio::ProximalSettings& how)
      : Solver(s), settings(how) {
    for (const Held& each : constraints) {
      const auto first = place_of(each.first);
      const auto second = each.second ? place_of(*each.second) : Place{};
      models.emplace_back(each.turns ? pinocchio::CONTACT_6D : pinocchio::CONTACT_3D, model,
                          first.joint, first.on_joint, second.joint, second.on_joint,
                          pinocchio::LOCAL);
      held.emplace_back(models.back());
    }
    pinocchio::initConstraintDynamics(model, data, models, held);
  }

 private:
  struct Place {
    pinocchio::JointIndex joint = 0;  ///< the world
    pinocchio::SE3 on_joint = pinocchio::SE3::Identity();
  };

  [[nodiscard]] Place place_of(const Point& point) const {
    const auto& link = model.frames[model.getBodyId(point.link)];
    return {link.parentJoint, link.placement * pose_of(point)};
  }
};

/// Gauss' principle with M and J as one system (Carpentier, Budhiraja & Mansard 2021). `settings`
/// have mu and the number of proximal iterations. `out` receives the motion.
inline void constrained_dynamics(ConstraintSolver& s, const double* const* in, double* out) {
  s.load_motion(in);
  s.store(pinocchio::constraintDynamics(s.model, s.data, s.q, s.qd, s.drive, s.models, s.held,
                                        s.settings),
          out);
}

}  // namespace treeline::peer::pin
