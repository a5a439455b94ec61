// Records what Pinocchio computes, in long double, of a robot's rotors, regressors, energies and
// momentum about its centre of mass: `record_quantities NAME.urdf NAME.json NAME_quantities.json`
// takes the states of an earlier record. Everything is in Pinocchio's order of joints.
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/centroidal-derivatives.hpp>
#include <pinocchio/algorithm/centroidal.hpp>
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/energy.hpp>
#include <pinocchio/algorithm/regressor.hpp>
#include <pinocchio/algorithm/rnea.hpp>
#include <pinocchio/config.hpp>
#include <pinocchio/parsers/urdf.hpp>
#include <string>

namespace {

using Real = long double;
using Json = nlohmann::ordered_json;
using Model = pinocchio::ModelTpl<Real>;
using Data = pinocchio::DataTpl<Real>;
using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

/// Which states of the earlier record.
constexpr std::size_t kStates[] = {3, 9, 15};

Vector read_vector(const Json& json) {
  Vector v(static_cast<Eigen::Index>(json.size()));
  for (std::size_t i = 0; i < json.size(); ++i) {
    v(static_cast<Eigen::Index>(i)) = json[i].get<double>();
  }
  return v;
}

/// Whole numbers without a point, so that a file of mostly zeros stays small.
Json number(Real x) {
  const auto rounded = static_cast<double>(x);
  if (rounded == 0) return 0;
  return rounded;
}

template <class Derived>
Json write_vector(const Eigen::MatrixBase<Derived>& v) {
  Json json = Json::array();
  for (Eigen::Index i = 0; i < v.size(); ++i) json.push_back(number(v(i)));
  return json;
}

template <class Derived>
Json write_matrix(const Eigen::MatrixBase<Derived>& m) {
  Json json = Json::array();
  for (Eigen::Index i = 0; i < m.rows(); ++i) json.push_back(write_vector(m.row(i).transpose()));
  return json;
}

Model read_model(const std::string& urdf, bool floating) {
  pinocchio::Model model;
  if (floating) {
    pinocchio::urdf::buildModel(urdf, pinocchio::JointModelFreeFlyer(), model);
  } else {
    pinocchio::urdf::buildModel(urdf, model);
  }
  return model.cast<Real>();
}

/// Made-up rotors, a different one at each joint of one degree of freedom.
Json add_rotors(Model& model) {
  Json armature = Json::object();
  for (pinocchio::JointIndex i = 1; i < static_cast<std::size_t>(model.njoints); ++i) {
    if (model.joints[i].nv() != 1) continue;
    const double rotor = 0.125 + 0.0625 * static_cast<double>(i);
    model.armature(model.joints[i].idx_v()) = rotor;
    armature[model.names[i]] = rotor;
  }
  return armature;
}

void record_rotors(const Model& model, const Json& state, Json& out) {
  Data data(model);
  const Vector q = read_vector(state["q"]);
  const Vector v = read_vector(state["v"]);
  out["rnea"] = write_vector(pinocchio::rnea(model, data, q, v, read_vector(state["a"])));
  out["aba"] = write_vector(
      pinocchio::aba(model, data, q, v, read_vector(state["tau"]), pinocchio::Convention::LOCAL));
  pinocchio::crba(model, data, q, pinocchio::Convention::LOCAL);
  out["M"] = write_matrix(Matrix(data.M.template selfadjointView<Eigen::Upper>()));
  out["kinetic"] = number(pinocchio::computeKineticEnergy(model, data, q, v));
  out["potential"] = number(pinocchio::computePotentialEnergy(model, data, q));
}

void record_regressors(const Model& model, const Json& state, Json& out) {
  Data data(model);
  const Vector q = read_vector(state["q"]);
  const Vector v = read_vector(state["v"]);
  out["Y"] = write_matrix(
      pinocchio::computeJointTorqueRegressor(model, data, q, v, read_vector(state["a"])));
  Matrix E(2, 10 * (model.njoints - 1));
  E.row(0) = pinocchio::computeKineticEnergyRegressor(model, data, q, v);
  E.row(1) = pinocchio::computePotentialEnergyRegressor(model, data, q);
  out["E"] = write_matrix(E);
}

void record_momentum(const Model& model, const Json& state, Json& out) {
  Data data(model);
  const Vector q = read_vector(state["q"]);
  const Vector v = read_vector(state["v"]);
  out["A_G"] = write_matrix(pinocchio::computeCentroidalMap(model, data, q));
  out["h_G"] = write_vector(pinocchio::computeCentroidalMomentum(model, data, q, v).toVector());
  const Vector at_rest = Vector::Zero(model.nv);
  pinocchio::computeCentroidalMomentumTimeVariation(model, data, q, v, at_rest);
  out["bias"] = write_vector(data.dhg.toVector());
  Data::Matrix6x h_by_q = Data::Matrix6x::Zero(6, model.nv);
  Data::Matrix6x rate_by_q = h_by_q;
  Data::Matrix6x rate_by_v = h_by_q;
  Data::Matrix6x rate_by_a = h_by_q;
  pinocchio::computeCentroidalDynamicsDerivatives(model, data, q, v, read_vector(state["a"]),
                                                  h_by_q, rate_by_q, rate_by_v, rate_by_a);
  out["h_by_q"] = write_matrix(h_by_q);
  out["rate_by_q"] = write_matrix(rate_by_q);
  out["rate_by_v"] = write_matrix(rate_by_v);
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 4) {
    std::cerr << "usage: record_quantities NAME.urdf NAME.json NAME_quantities.json\n";
    return 2;
  }
  std::ifstream file(arguments[2]);
  const Json earlier = Json::parse(file);
  Model model = read_model(arguments[1], earlier.at("floating_base").get<bool>());
  Json record;
  record["source"] = std::string("pinocchio ") + PINOCCHIO_VERSION +
                     ", long double; Y, E and momentum without, all else with these rotors";
  const Model without_rotors = model;
  record["armature"] = add_rotors(model);
  for (const std::size_t i : kStates) {
    const Json& state = earlier.at("states").at(i);
    Json out;
    out["state"] = i;
    record_rotors(model, state, out);
    record_regressors(without_rotors, state, out);
    record_momentum(without_rotors, state, out);
    record["states"].push_back(out);
  }
  std::ofstream(arguments[3]) << record.dump() << '\n';
}
