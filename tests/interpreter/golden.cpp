#include "interpreter/golden.hpp"

#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "data/list_data.hpp"
#include "description/read_urdf.hpp"

namespace treeline::tests {
namespace {

using Json = nlohmann::json;

DoubleVector read_vector(const Json& json) {
  const auto values = json.get<std::vector<double>>();
  return Eigen::Map<const DoubleVector>(values.data(), static_cast<Eigen::Index>(values.size()));
}

DoubleMatrix read_matrix(const Json& json) {
  if (json.is_null()) return {};
  DoubleMatrix m(static_cast<Eigen::Index>(json.size()), static_cast<Eigen::Index>(json[0].size()));
  for (Eigen::Index i = 0; i < m.rows(); ++i) {
    m.row(i) = read_vector(json[static_cast<std::size_t>(i)]).transpose();
  }
  return m;
}

void append_joint(const Json& joint, GoldenOrder& order) {
  const int nq = joint.at("nq").get<int>();
  const int nv = joint.at("nv").get<int>();
  const bool cosine_and_sine = nq == 2 && nv == 1;
  for (int i = 0; i < (cosine_and_sine ? 1 : nq); ++i) {
    order.q.push_back(joint.at("idx_q").get<int>() + i);
    order.angle_from_cosine_and_sine.push_back(cosine_and_sine);
  }
  for (int i = 0; i < nv; ++i) order.v.push_back(joint.at("idx_v").get<int>() + i);
}

/// Appends joints depth-first in the URDF's order.
void append_joints_of(const Robot& robot, int link, const Json& joints, GoldenOrder& order) {
  for (const Joint& joint : robot.joints) {
    if (joint.parent != link) continue;
    for (const Json& listed : joints) {
      if (listed.at("name") == joint.name) append_joint(listed, order);
    }
    append_joints_of(robot, joint.child, joints, order);
  }
}

DoubleVector position(const Json& json, const GoldenOrder& order) {
  const DoubleVector theirs = read_vector(json);
  DoubleVector q = theirs(order.q);
  for (Eigen::Index i = 0; i < q.size(); ++i) {
    if (order.angle_from_cosine_and_sine[static_cast<std::size_t>(i)]) {
      const int at = order.q[static_cast<std::size_t>(i)];
      q(i) = std::atan2(theirs(at + 1), theirs(at));
    }
  }
  return q;
}

GoldenPoint read_point(const Json& json, const GoldenOrder& order) {
  return {read_vector(json.at("p")),
          read_matrix(json.at("R")),
          read_matrix(json.at("J_local"))(Eigen::all, order.v),
          read_matrix(json.at("J_lwa"))(Eigen::all, order.v),
          read_vector(json.at("bias_local")),
          read_vector(json.at("bias_lwa"))};
}

GoldenState read_state(const Json& json, const GoldenOrder& order) {
  const auto velocity_like = [&](const char* key) {
    return DoubleVector(read_vector(json.at(key))(order.v));
  };
  GoldenState s;
  s.note = json.at("note");
  s.q = position(json.at("q"), order);
  s.qd = velocity_like("v");
  s.qdd = velocity_like("a");
  s.tau = velocity_like("tau");
  s.xdd = read_vector(json.at("xdd_des"));
  s.rnea = velocity_like("rnea");
  s.aba = velocity_like("aba");
  s.gravity = velocity_like("g");
  s.nonlinear_effects = velocity_like("nle");
  s.M = read_matrix(json.at("M"))(order.v, order.v);
  for (const Json& point : json.at("ops")) s.points.push_back(read_point(point, order));
  s.Lambda_inverse_local = read_matrix(json.at("Linv_local"));
  s.Lambda_inverse_world = read_matrix(json.at("Linv_lwa"));
  s.Lambda_local = read_matrix(json.at("Lambda_local"));
  s.Lambda_world = read_matrix(json.at("Lambda_lwa"));
  if (!json.at("tau_osc").is_null()) s.control_torque = velocity_like("tau_osc");
  return s;
}

Robot read_robot(const std::string& path) {
  Diagnostics diagnostics;
  std::optional<Robot> robot = read_urdf(path, diagnostics);
  if (!robot) {
    std::string text;
    for (const Diagnostic& d : diagnostics.list()) text += to_string(d) + "\n";
    throw std::runtime_error(text);
  }
  for (Joint& joint : robot->joints) joint.mimic.reset();
  return *robot;
}

}  // namespace

GoldenRobot read_golden(const std::string& name) {
  std::ifstream file(data_file("golden/" + name + ".json"));
  const Json json = Json::parse(file);
  GoldenRobot golden;
  golden.robot = read_robot(data_file(json.at("urdf")));
  golden.scene.name = name;
  const bool floats = json.at("floating_base").get<bool>();
  golden.scene.base = floats ? Base::floating : Base::fixed;
  golden.scene.gravity = json.at("gravity").get<std::array<double, 3>>();
  for (const Json& frame : json.at("op_frames")) {
    ScenePoint point;
    point.name = point.link = frame;
    golden.scene.operational_points.push_back(point);
  }
  GoldenOrder& order = golden.order;
  if (floats) append_joint(json.at("joints").at(0), order);
  append_joints_of(golden.robot, golden.robot.root, json.at("joints"), order);
  for (const Json& state : json.at("states")) {
    golden.states.push_back(read_state(state, order));
  }
  return golden;
}

}  // namespace treeline::tests
