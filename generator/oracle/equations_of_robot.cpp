#include "oracle/equations.hpp"

namespace treeline {
namespace {

namespace ip = interpreter;
using At = EquationAt;

constexpr const char* kLagrange = "d/dt dT/dqd - dT/dq + dV/dq = tau - friction + J_ext^T f_ext";

/// Joint forces that overcome friction, in which there is no derivative.
Vector50 friction_forces(const At& at, const Vector50& qd) {
  auto smooth = at.model;
  for (auto& body : smooth.bodies) body.damping = body.friction = Digits50(0);
  return ip::nonlinear_effects<Digits50>(at.model, at.q, qd) -
         ip::nonlinear_effects<Digits50>(smooth, at.q, qd);
}

/// Lagrange's equations for joint forces and the accelerations that they cause.
EquationSides lagrange(const At& at, const Vector50& tau, const Vector50& qd, const Vector50& qdd,
                       bool pushed) {
  const auto [force, terms] = lagrangian_force(at, qd, qdd);
  const auto& direction = at.direction;
  const Digits50 friction = direction.dot(friction_forces(at, qd));
  Digits50 external = 0;
  if (pushed && at.f_ext.size() > 0) {
    auto points = at.subject.external;
    for (auto& point : points) point.rows.fill(true);
    external = at.f_ext.dot(ip::jacobian<Digits50>(at.model, points, at.q) * direction);
  }
  return {only(direction.dot(tau)), only(force + friction - external),
          terms + abs(friction) + abs(external)};
}

Vector50 rest(const At& at) {
  return Vector50::Zero(at.model.nv);
}

/// Matrices of nv columns by q, by qd, and by qdd or tau.
Vector50 inverse_dynamics(const At& at, const Vector50& q, const Vector50& qd,
                          const Vector50& qdd) {
  return ip::inverse_dynamics<Digits50>(at.model, q, qd, qdd, at.subject.external, at.f_ext);
}

/// C + C^T = dM/dt, and C qd is what Lagrange's equations have at qdd = 0 without weight.
EquationSides coriolis(const At& at) {
  const auto nv = static_cast<Eigen::Index>(at.model.nv);
  const Matrix50 C = at.block(0, nv, nv);
  const Vector50 across = at.direction.reverse();
  const Digits50 dM = rate_along(at, at.qd, [&](const Vector50& q) {
    return only(at.direction.dot(ip::mass_matrix<Digits50>(at.model, q) * across));
  })(0);
  const auto model = ip::without_gravity<Digits50>(at.model);
  const auto [with, terms] = lagrangian_force(at, at.qd, rest(at));
  const auto [held, weight] = lagrangian_force(at, rest(at), rest(at));
  const Digits50 b = with - held;
  const Digits50 size = largest_of(ip::mass_matrix<Digits50>(model, at.q) * at.qd) * at.rate;
  return {joined(only(at.direction.dot(C * across) + across.dot(C * at.direction)),
                 only(at.direction.dot(C * at.qd))),
          joined(only(dM), only(b)), size + terms + weight};
}

constexpr auto kEquationsOfRobot = std::to_array<Equation>({
    {Function::inverse_dynamics, kLagrange,
     [](const At& at) { return lagrange(at, at.value, at.qd, at.qdd, true); }},
    {Function::forward_dynamics, kLagrange,
     [](const At& at) {
       if (at.other(Quantity::step).size() > 0) return EquationSides{};
       return lagrange(at, at.tau, at.qd, at.value, true);
     }},
    {Function::nonlinear_effects, kLagrange,
     [](const At& at) { return lagrange(at, at.value, at.qd, rest(at), false); }},
    {Function::gravity, "g = dV/dq",
     [](const At& at) { return lagrange(at, at.value, rest(at), rest(at), false); }},
    {Function::mass_matrix, "M qd = dT/dqd",
     [](const At& at) {
       const auto nv = static_cast<Eigen::Index>(at.model.nv);
       const auto energy = [&](const Vector50& qd) {
         return ip::kinetic_energy<Digits50>(at.model, at.q, qd);
       };
       const Digits50 h = small_step(at.rate);
       const Vector50 way = h * at.direction;
       const Digits50 slope = (energy(at.qd + way) - energy(at.qd - way)) / Digits50(2 * h);
       const Vector50 p = at.block(0, nv, nv) * at.qd;
       return EquationSides{only(at.direction.dot(p)), only(slope), largest_of(p)};
     }},
    {Function::coriolis_matrix, "dM/dt = C + C^T, C qd = b", coriolis},
    {Function::kinetic_energy_derivatives, "dT/dq, dT/dqd",
     [](const At& at) {
       return along_one_direction(at, Vector50(),
                                  [&](const Vector50& q, const Vector50& qd, const Vector50&) {
                                    return only(ip::kinetic_energy<Digits50>(at.model, q, qd));
                                  });
     }},
    {Function::inverse_dynamics_derivatives, "dtau/dq, dtau/dqd, dtau/dqdd",
     [](const At& at) {
       return along_one_direction(at, at.qdd,
                                  [&](const Vector50& q, const Vector50& qd, const Vector50& qdd) {
                                    return inverse_dynamics(at, q, qd, qdd);
                                  });
     }},
    {Function::forward_dynamics_derivatives, "dqdd/dq, dqdd/dqd, dqdd/dtau",
     [](const At& at) {
       return along_one_direction(at, at.tau,
                                  [&](const Vector50& q, const Vector50& qd, const Vector50& tau) {
                                    return ip::forward_dynamics<Digits50>(
                                        at.model, q, qd, tau, at.subject.external, at.f_ext);
                                  });
     }},
    {Function::center_of_mass_jacobian, "J qd = d/dt c",
     [](const At& at) {
       const Vector50 v = at.block(0, 3, at.model.nv) * at.qd;
       return EquationSides{v,
                            rate_along(at, at.qd,
                                       [&](const Vector50& q) {
                                         return Vector50(ip::center_of_mass<Digits50>(at.model, q));
                                       }),
                            at.rate};
     }},
    {Function::center_of_mass_bias_acceleration, "Jd qd = d/dt (J qd)",
     [](const At& at) {
       return EquationSides{at.value,
                            differentiate_rows(at,
                                               [&](const Vector50& q) {
                                                 return ip::center_of_mass_jacobian<Digits50>(
                                                     at.model, q);
                                               }),
                            at.rate * at.rate};
     }},
    {Function::centroidal_momentum, "momentum = m d/dt c",
     [](const At& at) {
       const Digits50 mass = ip::total_mass<Digits50>(at.model);
       return EquationSides{
           at.value.head(3),
           rate_along(at, at.qd,
                      [&](const Vector50& q) {
                        return Vector50(mass * ip::center_of_mass<Digits50>(at.model, q));
                      }),
           mass * at.rate};
     }},
    {Function::centroidal_bias, "dA_G/dt qd = d/dt (A_G qd)",
     [](const At& at) {
       const auto A_G = [&](const Vector50& q) {
         return ip::centroidal_momentum_matrix<Digits50>(at.model, q);
       };
       return EquationSides{at.value, differentiate_rows(at, A_G),
                            largest_of(A_G(at.q) * at.qd) * at.rate};
     }},
    {Function::centroidal_momentum_derivatives, "dh_G/dq, dh_G/dqd",
     [](const At& at) {
       return along_one_direction(
           at, Vector50(), [&](const Vector50& q, const Vector50& qd, const Vector50&) {
             return Vector50(ip::centroidal_momentum<Digits50>(at.model, q, qd));
           });
     }},
    {Function::centroidal_momentum_rate_derivatives, "d/dq, d/dqd, d/dqdd of dh_G/dt",
     [](const At& at) {
       return along_one_direction(
           at, at.qdd, [&](const Vector50& q, const Vector50& qd, const Vector50& qdd) {
             return Vector50(ip::centroidal_momentum_rate<Digits50>(at.model, q, qd, qdd));
           });
     }},
});

}  // namespace

std::span<const Equation> equations_of_robot() {
  return kEquationsOfRobot;
}

}  // namespace treeline
