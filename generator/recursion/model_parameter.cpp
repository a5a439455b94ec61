#include "recursion/model_parameter.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "recursion/base_parameters.hpp"

namespace treeline {
namespace {

using Kind = ModelParameter::Kind;

void append_inertial(const Mechanism& mechanism, const std::vector<std::string>& links,
                     std::vector<ModelParameter>& parameters) {
  for (std::size_t frame = 0; frame < mechanism.link_frames.size(); ++frame) {
    const std::string& link = mechanism.link_frames[frame].name;
    const bool asked = links.empty() || std::find(links.begin(), links.end(), link) != links.end();
    for (int entry = 0; asked && entry < kInertialParameters; ++entry) {
      parameters.push_back({Kind::inertial, link, frame, entry});
    }
  }
}

/// Whether a motor turns or slides it by a coordinate of its own, and nothing else does.
bool has_own_motor(const Mechanism& mechanism, const MovingLink& link) {
  if (!link.has_one_coordinate() || link.mimics) return false;
  const auto& links = mechanism.links;
  return std::count_if(links.begin(), links.end(),
                       [&](const MovingLink& other) { return other.joint == link.joint; }) == 1;
}

void append_of_joints(const Mechanism& mechanism, Kind kind,
                      std::vector<ModelParameter>& parameters) {
  for (const MovingLink& link : mechanism.links) {
    if (!has_own_motor(mechanism, link)) continue;
    parameters.push_back({kind, link.joint, 0, 0, link.v_index, link.kind == JointKind::prismatic});
  }
}

}  // namespace

std::string name_of(const ModelParameter& parameter) {
  switch (parameter.kind) {
    case Kind::rotor:
      return parameter.owner + " rotor";
    case Kind::viscous:
      return parameter.owner + " viscous";
    case Kind::inertial:
      break;
  }
  return fmt::format("{} {}", parameter.owner,
                     kInertialNames[static_cast<std::size_t>(parameter.entry)]);
}

std::vector<ModelParameter> list_model_parameters(const Mechanism& mechanism,
                                                  const SceneRegressor& asked) {
  std::vector<ModelParameter> parameters;
  append_inertial(mechanism, asked.links, parameters);
  if (asked.rotors) append_of_joints(mechanism, Kind::rotor, parameters);
  if (asked.friction) append_of_joints(mechanism, Kind::viscous, parameters);
  return parameters;
}

std::vector<ModelParameter> regressor_columns(const Mechanism& mechanism) {
  if (!mechanism.regressor.base) return list_model_parameters(mechanism, mechanism.regressor);
  const BaseParameters found = find_base_parameters(mechanism, mechanism.regressor);
  std::vector<ModelParameter> columns;
  for (const BaseParameter& each : found.base) columns.push_back(found.parameters[each.parameter]);
  return columns;
}

}  // namespace treeline
