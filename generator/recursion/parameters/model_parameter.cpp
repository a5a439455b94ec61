#include "recursion/parameters/model_parameter.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "recursion/parameters/base_parameters.hpp"

namespace treeline {
namespace {

using ParameterKind = ModelParameter::Kind;

void append_body(ParameterKind kind, const std::string& link, std::size_t frame,
                 std::vector<ModelParameter>& parameters) {
  for (int entry = 0; entry < kInertialParameters; ++entry) {
    parameters.push_back({kind, link, frame, entry});
  }
}

void append_bodies(const Mechanism& mechanism, const SceneRegressor& asked,
                   std::vector<ModelParameter>& parameters) {
  const auto& links = asked.links;
  for (std::size_t frame = 0; !asked.none && frame < mechanism.link_frames.size(); ++frame) {
    const std::string& link = mechanism.link_frames[frame].name;
    if (links.empty() || std::find(links.begin(), links.end(), link) != links.end()) {
      append_body(ParameterKind::inertial, link, frame, parameters);
    }
  }
  for (std::size_t frame = 0; frame < asked.payloads.size(); ++frame) {
    append_body(ParameterKind::payload, asked.payloads[frame], frame, parameters);
  }
}

/// Whether it is a step of the joint, and of one coordinate.
bool is_step_of(const std::string& joint, const MovingLink& link) {
  return link.has_one_coordinate() && !link.spins && link.joint == joint;
}

/// Whether a joint of one freedom moves it, with a coordinate of its own or another joint's.
bool has_own_motor(const Mechanism& mechanism, const MovingLink& link) {
  if (link.multiplier == 0) return false;
  const auto& links = mechanism.links;
  return is_step_of(link.joint, link) &&
         std::count_if(links.begin(), links.end(),
                       [&](const MovingLink& other) { return is_step_of(link.joint, other); }) == 1;
}

void append_of_joints(const Mechanism& mechanism, const SceneRegressor& asked, ParameterKind kind,
                      std::vector<ModelParameter>& parameters) {
  for (const MovingLink& link : mechanism.links) {
    if (!has_own_motor(mechanism, link)) continue;
    const Digits50 multiple = abs(Digits50(link.multiplier));
    ModelParameter parameter{kind, link.joint, 0, 0, link.v_index, !link.is_angular(0), multiple};
    if (kind == ParameterKind::coulomb) {
      const Digits50 own = abs(link.drive.sharpness);
      parameter.sharpness = own > 0 ? own : Digits50(multiple / Digits50(asked.width));
    } else {
      parameter.factor *= multiple;
    }
    parameters.push_back(parameter);
  }
}

}  // namespace

std::string name_of(const ModelParameter& parameter) {
  switch (parameter.kind) {
    case ParameterKind::rotor:
      return parameter.owner + " rotor";
    case ParameterKind::viscous:
      return parameter.owner + " viscous";
    case ParameterKind::coulomb:
      return parameter.owner + " coulomb";
    case ParameterKind::inertial:
    case ParameterKind::payload:
      break;
  }
  return fmt::format("{}{} {}", parameter.kind == ParameterKind::payload ? "payload of " : "",
                     parameter.owner, kInertialNames[static_cast<std::size_t>(parameter.entry)]);
}

const char* unit_of(const ModelParameter& parameter) {
  switch (parameter.kind) {
    case ParameterKind::rotor:
      return parameter.slides ? "kg" : "kg m^2";
    case ParameterKind::viscous:
      return parameter.slides ? "N s/m" : "N m s/rad";
    case ParameterKind::coulomb:
      return parameter.slides ? "N" : "N m";
    case ParameterKind::inertial:
    case ParameterKind::payload:
      break;
  }
  return parameter.entry == 0 ? "kg" : parameter.entry < 4 ? "kg m" : "kg m^2";
}

std::string sign_of(const ModelParameter& parameter) {
  const auto factor = static_cast<double>(parameter.factor);
  const std::string times = factor == 1 ? "" : fmt::format("{:.6g} ", factor);
  return fmt::format("{0}s({0}qd / {1:.6g})", times, parameter.width());
}

std::vector<ModelParameter> list_model_parameters(const Mechanism& mechanism,
                                                  const SceneRegressor& asked) {
  std::vector<ModelParameter> parameters;
  append_bodies(mechanism, asked, parameters);
  if (asked.rotors) append_of_joints(mechanism, asked, ParameterKind::rotor, parameters);
  if (asked.friction) append_of_joints(mechanism, asked, ParameterKind::viscous, parameters);
  if (asked.coulomb) append_of_joints(mechanism, asked, ParameterKind::coulomb, parameters);
  return parameters;
}

std::size_t link_of(const ModelParameter& parameter, const Mechanism& mechanism) {
  const auto link =
      std::find_if(mechanism.links.begin(), mechanism.links.end(),
                   [&](const MovingLink& each) { return is_step_of(parameter.owner, each); });
  return static_cast<std::size_t>(link - mechanism.links.begin());
}

std::vector<ModelParameter> regressor_columns(const Mechanism& mechanism) {
  if (!mechanism.regressor.base) return list_model_parameters(mechanism, mechanism.regressor);
  const auto found = base_parameters_of(mechanism);
  std::vector<ModelParameter> columns;
  for (const BaseParameter& each : found->base) {
    columns.push_back(found->parameters[each.parameter]);
  }
  return columns;
}

}  // namespace treeline
