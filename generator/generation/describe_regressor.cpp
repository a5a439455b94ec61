#include <fmt/format.h>

#include <algorithm>

#include "generation/append_notes.hpp"
#include "recursion/parameters/base_parameters.hpp"

namespace treeline {
namespace {

/// The text about a parameter or a combination; of Coulomb friction with its column.
std::string with_column(const std::string& text, const ModelParameter& parameter) {
  if (parameter.kind != ModelParameter::Kind::coulomb) return text;
  return fmt::format("{}, whose column is {}", text, sign_of(parameter));
}

void append_all(const Mechanism& mechanism, std::vector<std::string>& notes) {
  const auto parameters = list_model_parameters(mechanism, mechanism.regressor);
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    const ModelParameter& parameter = parameters[k];
    if (!parameter.is_of_body()) {
      notes.push_back(fmt::format("p {}: {}", k, with_column(name_of(parameter), parameter)));
    } else if (parameter.entry == 0) {
      const bool added = parameter.kind == ModelParameter::Kind::payload;
      notes.push_back(
          fmt::format("p {}..{}: m, m c_x, m c_y, m c_z, Ixx, Ixy, Iyy, Ixz, Iyz, Izz "
                      "of {} {}{}",
                      k, k + kInertialParameters - 1, added ? "a body added to link" : "link",
                      parameter.owner, added ? "" : " and what is fixed to it"));
    }
  }
}

void append_base(const Mechanism& mechanism, std::vector<std::string>& notes) {
  const auto found = base_parameters_of(mechanism);
  for (std::size_t k = 0; k < found->base.size(); ++k) {
    const ModelParameter& named = found->parameters[found->base[k].parameter];
    notes.push_back(
        fmt::format("p {}: {}", k, with_column(describe(found->base[k], *found), named)));
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
  if (scene.regressor.coulomb) {
    notes.emplace_back(
        "of Coulomb friction N m (N); s(x) = tanh(128 artanh(x / 128)), within 1.3e-5 of tanh x up "
        "to x = 2600 and above 0.995 up to 5461");
  }
  if (scene.regressor.base) {
    append_base(mechanism, notes);
  } else {
    append_all(mechanism, notes);
  }
}

}  // namespace treeline
