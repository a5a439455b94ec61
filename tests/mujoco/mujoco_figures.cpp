#include "mujoco/mujoco_figures.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace treeline::tests {
namespace {

using Json = nlohmann::json;
using Body = interpreter::Body<double>;

constexpr const char* kBaseJoint = "floating_base";  // as in prepare_urdf.mjs
constexpr const char* kRenamedWorld = "link_named_world";

DoubleVector read_vector(const Json& json) {
  const auto values = json.get<std::vector<double>>();
  return Eigen::Map<const DoubleVector>(values.data(), static_cast<Eigen::Index>(values.size()));
}

/// One of our moving bodies and the place of its joint in MuJoCo.
struct Place {
  const Body* body;
  int at_q, at_v;
};

std::string joint_name(const Robot& robot, const Body& body) {
  for (const Joint& joint : robot.joints) {
    if (robot.links[static_cast<std::size_t>(joint.child)].name != body.name) continue;
    if (joint.type == JointType::floating && joint.origin.xyz != std::array<double, 3>{}) {
      throw std::runtime_error(joint.name + ": a floating joint with an origin is not converted");
    }
    return joint.name;
  }
  return kBaseJoint;
}

std::vector<Place> match_joints(const Json& joints, const Robot& robot,
                                const interpreter::Model<double>& model) {
  std::vector<Place> places;
  for (const Body& body : model.bodies) {
    if (interpreter::velocity_count(body.kind) == 0) continue;
    const std::string name = joint_name(robot, body);
    const auto found = std::find_if(joints.begin(), joints.end(),
                                    [&](const Json& joint) { return joint.at("name") == name; });
    if (found == joints.end()) throw std::runtime_error("MuJoCo has no joint " + name);
    places.push_back({&body, found->at("at_q").get<int>(), found->at("at_v").get<int>()});
  }
  return places;
}

/// Converts MuJoCo's coordinates to our conventions.
class Conversion {
 public:
  Conversion(const std::vector<Place>& places, int nq, int nv, const DoubleVector& their_q,
             const DoubleVector& their_v)
      : q(nq), to_ours(DoubleMatrix::Zero(nv, nv)), drift(DoubleVector::Zero(nv)) {
    for (const Place& place : places) {
      if (place.body->kind == interpreter::JointKind::floating) {
        add_free_joint(place, their_q, their_v);
      } else {
        q(place.body->q) = their_q(place.at_q);
        to_ours(place.body->v, place.at_v) = 1;
      }
    }
  }

  DoubleVector q;
  DoubleMatrix to_ours;  ///< our velocities from theirs, our forces from theirs: orthogonal
  DoubleVector drift;    ///< our accelerations where theirs are zero

 private:
  void add_free_joint(const Place& place, const DoubleVector& their_q,
                      const DoubleVector& their_v) {
    const Eigen::Vector4d w_first = their_q.segment<4>(place.at_q + 3);
    const Eigen::Quaterniond turn(w_first(0), w_first(1), w_first(2), w_first(3));
    q.segment<3>(place.body->q) = their_q.segment<3>(place.at_q);
    q.segment<4>(place.body->q + 3) = turn.coeffs();
    const Eigen::Matrix3d to_link = turn.toRotationMatrix().transpose();
    to_ours.block<3, 3>(place.body->v, place.at_v) = to_link;
    to_ours.block<3, 3>(place.body->v + 3, place.at_v + 3).setIdentity();
    const Eigen::Vector3d linear = to_link * their_v.segment<3>(place.at_v);
    const Eigen::Vector3d angular = their_v.segment<3>(place.at_v + 3);
    drift.segment<3>(place.body->v) = -angular.cross(linear);
  }
};

std::vector<interpreter::PointPose<double>> read_poses(const Json& state) {
  const DoubleVector positions = read_vector(state.at("positions"));
  const DoubleVector rotations = read_vector(state.at("rotations"));
  std::vector<interpreter::PointPose<double>> poses(static_cast<std::size_t>(positions.size() / 3));
  for (std::size_t i = 0; i < poses.size(); ++i) {
    poses[i].position = positions.segment<3>(3 * static_cast<Eigen::Index>(i));
    const Eigen::Index at = 9 * static_cast<Eigen::Index>(i);
    poses[i].rotation =
        Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(rotations.data() + at);
  }
  return poses;
}

/// Angular over linear of each link, as MuJoCo has them, to linear over angular.
DoubleVector read_twists(const Json& json) {
  DoubleVector twists = read_vector(json);
  for (Eigen::Index at = 0; at < twists.size(); at += 6) {
    const Eigen::Vector3d angular = twists.segment<3>(at);
    twists.segment<3>(at) = twists.segment<3>(at + 3).eval();
    twists.segment<3>(at + 3) = angular;
  }
  return twists;
}

DoubleMatrix read_matrix(const Json& json, int nv) {
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const DoubleVector entries = read_vector(json);
  return Eigen::Map<const RowMajor>(entries.data(), nv == 0 ? 0 : entries.size() / nv, nv);
}

MujocoWhole read_whole(const Json& json, const Conversion& to) {
  const auto nv = static_cast<int>(to.drift.size());
  const auto mass = json.at("mass").get<double>();
  MujocoWhole whole;
  whole.center_of_mass = read_vector(json.at("com"));
  whole.center_of_mass_jacobian = read_matrix(json.at("com_jacobian"), nv) * to.to_ours.transpose();
  whole.momentum_matrix.resize(6, nv);
  whole.momentum_matrix << mass * whole.center_of_mass_jacobian,
      read_matrix(json.at("angular_momentum_matrix"), nv) * to.to_ours.transpose();
  whole.momentum.resize(6);
  whole.momentum << mass * read_vector(json.at("com_velocity")),
      read_vector(json.at("angular_momentum"));
  whole.potential_energy = json.at("potential_energy").get<double>();
  return whole;
}

MujocoState read_state(const Json& json, const std::vector<Place>& places,
                       const interpreter::Model<double>& model) {
  const DoubleVector v = read_vector(json.at("v"));
  const Conversion to(places, model.nq, model.nv, read_vector(json.at("q")), v);
  const auto read_M = [&](const char* key) {
    return DoubleMatrix(to.to_ours * read_matrix(json.at(key), model.nv) * to.to_ours.transpose());
  };
  MujocoState state;
  state.q = to.q;
  state.qd = to.to_ours * v;
  state.qdd = to.to_ours * read_vector(json.at("a")) + to.drift;
  state.mass_matrix = read_M("M");
  state.mass_matrix_with_rotors = read_M("M_with_rotors");
  state.kinetic_energy_with_rotors = json.at("kinetic_energy").get<double>();
  state.inverse_dynamics = to.to_ours * read_vector(json.at("tau"));
  state.nonlinear_effects =
      to.to_ours * read_vector(json.at("bias")) - state.mass_matrix * to.drift;
  state.inverse_dynamics_with_drives = to.to_ours * read_vector(json.at("tau_with_drives"));
  state.applied = to.to_ours * read_vector(json.at("applied"));
  state.forward_dynamics_with_drives =
      to.to_ours * read_vector(json.at("forward_acceleration")) + to.drift;
  state.poses = read_poses(json);
  state.velocities = read_twists(json.at("velocities"));
  state.accelerations = read_twists(json.at("accelerations"));
  state.whole = read_whole(json, to);
  return state;
}

}  // namespace

MujocoFigures read_mujoco_figures(const std::string& path, const Robot& robot,
                                  const interpreter::Model<double>& model) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error("there is no " + path);
  const Json json = Json::parse(file);
  MujocoFigures figures;
  if (json.contains("refused")) {
    figures.refused = json.at("refused");
    return figures;
  }
  figures.nv = json.at("nv").get<int>();
  figures.seed = json.at("seed").get<unsigned>();
  if (figures.nv != model.nv) return figures;
  for (const Json& name : json.at("links")) {
    figures.links.push_back(name == kRenamedWorld ? "world" : name.get<std::string>());
  }
  const std::vector<Place> places = match_joints(json.at("joints"), robot, model);
  for (const Json& joint : json.at("joints")) {
    const auto at_v = joint.at("at_v").get<std::size_t>();
    const auto note = [&](const Json& value, std::map<std::string, double>& values) {
      if (value != 0) values[joint.at("name")] = value.get<double>();
    };
    note(json.at("armature").at(at_v), figures.armature);
    note(json.at("damping").at(at_v), figures.damping);
    const auto index = static_cast<std::size_t>(&joint - &json.at("joints").front());
    note(json.at("stiffness").at(index), figures.stiffness);
  }
  for (const Json& state : json.at("states")) {
    figures.states.push_back(read_state(state, places, model));
  }
  return figures;
}

}  // namespace treeline::tests
