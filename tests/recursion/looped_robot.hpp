#pragma once

#include <Eigen/QR>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "data/list_data.hpp"
#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"
#include "interpreter/loop_instances.hpp"
#include "mechanism/build_mechanism.hpp"
#include "oracle/model_from_robot.hpp"
#include "recursion/methods/constrained_forward_dynamics.hpp"
#include "recursion/methods/task_law.hpp"
#include "recursion/tree/supported_mechanism.hpp"

namespace treeline::tests {

/// A robot with loops that moves by the emitted recursion, in double.
class LoopedRobot {
 public:
  /// A robot from a file of tests/data/written.
  LoopedRobot(const std::string& urdf, const std::string& scene_text)
      : LoopedRobot(read_written(urdf), scene_text) {}

  LoopedRobot(const Robot& robot, const std::string& scene_text) {
    Diagnostics diagnostics;
    const auto scene = parse_scene(scene_text, "scene.yaml", robot, diagnostics);
    if (!scene) throw std::runtime_error("the scene cannot be read");
    model_ = model_from_robot<double>(robot, *scene);
    loops_ = loops_from_scene(model_, robot, *scene);
    const Mechanism seen = with_constraints_only(reduced_mechanism(robot, *scene));
    tree_ = tree_of<double>(seen);
    rule_ = TaskLaws(seen).find(TaskLaw::Kind::inverse_inertia, LawPoints::operational, {})->rule;
  }

  [[nodiscard]] const interpreter::Model<double>& model() const { return model_; }

  /// The closed pose near a guess, as closely as angles of some hundred turns can be rounded.
  [[nodiscard]] interpreter::Vector<double> closed(const interpreter::Vector<double>& q) const {
    std::vector<int> all(static_cast<std::size_t>(model_.nv));
    std::iota(all.begin(), all.end(), 0);
    return interpreter::close_loops<double>(model_, loops_, q, all, 2e-13).value();
  }
  [[nodiscard]] interpreter::Vector<double> errors(const interpreter::Vector<double>& q) const {
    return interpreter::loop_errors<double>(model(), loops_, q);
  }
  [[nodiscard]] interpreter::Matrix<double> jacobian(const interpreter::Vector<double>& q) const {
    return interpreter::loop_jacobian<double>(model(), loops_, q);
  }
  /// The part of qd that the loops permit.
  [[nodiscard]] interpreter::Vector<double> permitted(const interpreter::Vector<double>& q,
                                                      const interpreter::Vector<double>& qd) const {
    const interpreter::Matrix<double> J = jacobian(q);
    return qd - J.completeOrthogonalDecomposition().solve(interpreter::Vector<double>(J * qd));
  }
  [[nodiscard]] interpreter::Vector<double> moved(const interpreter::Vector<double>& q,
                                                  const interpreter::Vector<double>& qd,
                                                  double t) const {
    return interpreter::move_coordinates<double>(model(), q, qd, t);
  }

  [[nodiscard]] ConstrainedMotion<double> motion(const interpreter::Vector<double>& q,
                                                 const interpreter::Vector<double>& qd,
                                                 const std::vector<double>& gains) const {
    return motion(q, qd, gains, interpreter::Vector<double>::Zero(qd.size()));
  }
  [[nodiscard]] ConstrainedMotion<double> motion(const interpreter::Vector<double>& q,
                                                 const interpreter::Vector<double>& qd,
                                                 const std::vector<double>& gains,
                                                 const interpreter::Vector<double>& forces) const {
    const std::vector<double> at(q.begin(), q.end()), rates(qd.begin(), qd.end());
    const std::vector<double> tau(forces.begin(), forces.end());
    const auto X = joint_transforms<double>(tree_, at);
    return looped_forward_dynamics<double>(tree_, X, {at, rates, tau, gains, {}, {}}, rule_);
  }

  [[nodiscard]] double energy(const interpreter::Vector<double>& q,
                              const interpreter::Vector<double>& qd) const {
    return interpreter::kinetic_energy<double>(model(), q, qd) +
           interpreter::potential_energy<double>(model(), q);
  }

  /// One step of fourth order. `gains` lead the loops back: 1/s and 1/s^2.
  void step(double h, const std::vector<double>& gains, interpreter::Vector<double>& q,
            interpreter::Vector<double>& qd) const {
    using V = interpreter::Vector<double>;
    const auto rate = [&](const V& x, const V& v) -> std::pair<V, V> {
      const auto qdd = motion(x, v, gains).qdd;
      return {interpreter::position_derivative<double>(model(), x, v),
              V::Map(qdd.data(), v.size())};
    };
    const auto [v1, a1] = rate(q, qd);
    const auto [v2, a2] = rate(q + h / 2 * v1, qd + h / 2 * a1);
    const auto [v3, a3] = rate(q + h / 2 * v2, qd + h / 2 * a2);
    const auto [v4, a4] = rate(q + h * v3, qd + h * a3);
    q += h / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
    qd += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    q = moved(q, qd, 0);  // quaternions of length one
  }

 private:
  static Robot read_written(const std::string& urdf) {
    Diagnostics diagnostics;
    auto robot = read_urdf(data_file("written/" + urdf), diagnostics);
    if (!robot) throw std::runtime_error("the robot cannot be read");
    return *robot;
  }

  interpreter::Model<double> model_;
  interpreter::Loops<double> loops_;
  Tree<double> tree_;
  PivotRule rule_;
};

/// The four-bar of tests/data, whose loop a scene closes in these rows, and a pose near a closed
/// one.
inline LoopedRobot four_bar(const std::string& rows = "[x, z]") {
  return {"four_bar.urdf",
          "constraints: [{name: closing, between: [rocker, coupler], origin: {xyz: [0, 0, 0.25]}, "
          "other_origin: {xyz: [0.3, 0, 0]}, rows: " +
              rows + "}]\n"};
}
inline const interpreter::Vector<double> kAssembled =
    (interpreter::Vector<double>(3) << 0.3, -0.6, 0.2).finished();

/// The one in space, which a ball joint closes, and a pose near a closed one.
inline LoopedRobot spatial_four_bar() {
  return {"spatial_four_bar.urdf",
          "constraints: [{name: closing, between: [rocker, coupler], origin: {xyz: [0, 0, 0.4]}, "
          "other_origin: {xyz: [0.6, 0, 0]}, rows: [x, y, z]}]\n"};
}
inline const interpreter::Vector<double> kAssembledInSpace =
    (interpreter::Vector<double>(4) << 0.2, 0.1, -0.5, 0.3).finished();

}  // namespace treeline::tests
