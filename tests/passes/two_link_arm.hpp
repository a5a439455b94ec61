#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "program/program.hpp"

namespace treeline::test {

/// Inverse dynamics of a planar arm with two point masses (2 kg at 0.5 m, 1.5 kg at 0.4 m from
/// their joints, links 0.5 m and 0.4 m long, gravity along -y), written in textbook form (Craig,
/// eq. 6.58) for any Scalar.
template <class Scalar>
std::vector<Scalar> two_link_torque(const std::vector<Scalar>& q, const std::vector<Scalar>& qd,
                                    const std::vector<Scalar>& qdd) {
  using std::cos;
  using std::sin;
  const Scalar m1(2.0);
  const Scalar m2(1.5);
  const Scalar l1(0.5);
  const Scalar l2(0.4);
  const Scalar g(9.81);
  const Scalar c1 = cos(q[0]);
  const Scalar c2 = cos(q[1]);
  const Scalar s2 = sin(q[1]);
  const Scalar c12 = cos(q[0] + q[1]);
  const Scalar elbow = m2 * l2 * l2 * (qdd[0] + qdd[1]) + m2 * l1 * l2 * c2 * qdd[0] +
                       m2 * l1 * l2 * s2 * qd[0] * qd[0] + m2 * l2 * g * c12;
  const Scalar shoulder =
      m2 * l2 * l2 * (qdd[0] + qdd[1]) + m2 * l1 * l2 * c2 * (Scalar(2.0) * qdd[0] + qdd[1]) +
      (m1 + m2) * l1 * l1 * qdd[0] - m2 * l1 * l2 * s2 * qd[1] * qd[1] -
      Scalar(2.0) * m2 * l1 * l2 * s2 * qd[0] * qd[1] + m2 * l2 * g * c12 + (m1 + m2) * l1 * g * c1;
  return {shoulder, elbow};
}

/// `count` inputs `name[0]`, `name[1]`, ... of the graph that is open.
inline std::vector<Expression> input_vector(const std::string& name, int count) {
  std::vector<Expression> elements;
  for (int i = 0; i < count; ++i) {
    elements.push_back(Graph::current().input(name + "[" + std::to_string(i) + "]"));
  }
  return elements;
}

/// Traces the arm. Some of its operations are useless, so that there is dead code.
inline Program trace_two_link_arm() {
  Program program;
  program.name = "inverse_dynamics";
  program.equation = "tau = M(q) qdd + b(q, qd) + g(q)";
  program.route = {"closed-form", "Craig, eq. 6.58"};
  program.arguments = {{"q", 2, 1, "joint angles, rad"},
                       {"qd", 2, 1, "joint velocities, rad/s"},
                       {"qdd", 2, 1, "joint accelerations, rad/s^2"}};
  const Graph::Scope scope(program.graph);
  const auto q = input_vector("q", 2);
  const auto qd = input_vector("qd", 2);
  const auto qdd = input_vector("qdd", 2);
  program.graph.begin_section(SectionTitle{0, "", "waste"});
  program.graph.name(sin(qd[0]) * qdd[1], "waste");
  program.graph.begin_section(SectionTitle{0, "", "both links"});
  program.graph.name(sin(q[1]), "s2");
  program.graph.name(cos(q[1]), "c2");
  const auto tau = two_link_torque(q, qd, qdd);
  program.results = {{{"tau", 2, 1, "joint torques, Nm"}, tau}};
  return program;
}

}  // namespace treeline::test
