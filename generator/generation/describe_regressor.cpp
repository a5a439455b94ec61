#include "generation/describe_regressor.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "recursion/base_parameters.hpp"

namespace treeline {
namespace {

using Kind = ModelParameter::Kind;

void append_all(const Mechanism& mechanism, std::vector<std::string>& notes) {
  const auto parameters = list_model_parameters(mechanism, mechanism.regressor);
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    const ModelParameter& parameter = parameters[k];
    if (parameter.kind != Kind::inertial) {
      notes.push_back(fmt::format("p {}: {}", k, name_of(parameter)));
    } else if (parameter.entry == 0) {
      notes.push_back(
          fmt::format("p {}..{}: m, m c_x, m c_y, m c_z, Ixx, Ixy, Iyy, Ixz, Iyz, Izz "
                      "of link {} and what is fixed to it",
                      k, k + kInertialParameters - 1, parameter.owner));
    }
  }
}

void append_base(const Mechanism& mechanism, std::vector<std::string>& notes) {
  const BaseParameters found = find_base_parameters(mechanism, mechanism.regressor);
  for (std::size_t k = 0; k < found.base.size(); ++k) {
    notes.push_back(fmt::format("p {}: {}", k, describe(found.base[k], found)));
  }
  notes.emplace_back("E p has the potential energy of base parameters up to a constant");
}

}  // namespace

void append_regressor_notes(const Scene& scene, const Mechanism& mechanism,
                            std::vector<std::string>& notes) {
  if (std::none_of(scene.functions.begin(), scene.functions.end(), is_regressor)) return;
  notes.emplace_back(
      "parameters p of regressors, in the frames of the links in the URDF: kg, kg m, kg m^2; of "
      "rotors kg m^2 (kg for sliding joints), of viscous friction N m s (N s/m)");
  if (scene.regressor.base) {
    append_base(mechanism, notes);
  } else {
    append_all(mechanism, notes);
  }
}

}  // namespace treeline
