#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "bounds/domain.hpp"
#include "description/robot_queries.hpp"
#include "description/scene_inputs.hpp"
#include "text/round_outward.hpp"

namespace treeline {
namespace {

/// Largest magnitude of a coordinate: its limits, or the default for its kind.
double coordinate_size(const Coordinate& coordinate) {
  if (coordinate.is_of_quaternion()) return 1;
  const double size = std::max(std::abs(coordinate.lower), std::abs(coordinate.upper));
  return std::isfinite(size) ? size : coordinate.is_angle() ? kAngleRange : kPositionRange;
}

std::vector<double> coordinate_sizes(const Mechanism& mechanism) {
  std::vector<double> sizes;
  for (const Coordinate& coordinate : mechanism.coordinates) {
    sizes.push_back(coordinate_size(coordinate));
  }
  return sizes;
}

/// Ranges of velocities, accelerations or joint forces; joints state no limit of acceleration.
std::vector<double> joint_sizes(const QuantityInfo& row, const Robot& robot,
                                const Mechanism& mechanism) {
  std::vector<double> sizes(static_cast<std::size_t>(mechanism.nv()), row.range);
  const bool speeds = row.quantity == Quantity::qd;
  if (!speeds && row.quantity != Quantity::tau) return sizes;
  for (const MovingLink& link : mechanism.links) {
    const Joint* joint = find_joint(robot, link.joint);
    if (link.mimics || !link.has_one_coordinate() || joint == nullptr || !joint->limits) {
      continue;
    }
    const Limit& limit = speeds ? joint->limits->velocity : joint->limits->effort;
    if (!limit.is_stated()) continue;
    sizes[static_cast<std::size_t>(link.v_index)] =
        speeds ? std::min(limit.value(), kFastestInBounds) : limit.value();
  }
  return sizes;
}

std::vector<double> tool_sizes(const std::vector<SceneTool>& tools) {
  std::vector<double> sizes;
  for (const SceneTool& tool : tools) sizes.insert(sizes.end(), 3, tool.reach);
  return sizes;
}

std::size_t count_orientations(const Scene& scene) {
  const auto& tools = scene.inputs.tools;
  return static_cast<std::size_t>(std::count_if(tools.begin(), tools.end(), has_orientation));
}

/// Whether all entries have the same size, however many there are.
bool has_one_size(IndexSpace space) {
  switch (space) {
    case IndexSpace::contacts:
    case IndexSpace::objects:
    case IndexSpace::linkages:
    case IndexSpace::grasp_gains:
    case IndexSpace::held_rows:
    case IndexSpace::anchored_rows:
      return true;
    default:
      return false;
  }
}

/// The largest magnitude of each entry of a quantity whose entries the scene counts.
std::vector<double> sizes_of(const QuantityInfo& row, const Robot& robot, const Scene& scene,
                             const Mechanism& mechanism) {
  const auto same = [&row](std::size_t count) { return std::vector<double>(count, row.range); };
  switch (row.space) {
    case IndexSpace::positions:
      return row.quantity == Quantity::q ? coordinate_sizes(mechanism)
                                         : same(mechanism.coordinates.size());
    case IndexSpace::velocities:
      return joint_sizes(row, robot, mechanism);
    case IndexSpace::task_rows:
      return same(static_cast<std::size_t>(mechanism.task_rows()));
    case IndexSpace::external_forces:
      return same(6 * scene.external_forces.size());
    case IndexSpace::step:
      return same(scene.implicit_friction ? 1 : 0);
    case IndexSpace::gravity:
      return same(scene.inputs.gravity ? 3 : 0);
    case IndexSpace::payloads:
      return inertia_sizes(scene.inputs.payloads);
    case IndexSpace::parameters:
      return inertia_sizes(scene.inputs.parameters);
    case IndexSpace::tools:
      return tool_sizes(scene.inputs.tools);
    case IndexSpace::orientations:
      return same(4 * count_orientations(scene));
    case IndexSpace::contact_places:
      return tool_sizes(scene.inputs.contacts);
    case IndexSpace::active_groups:
      return same(scene.inputs.active.size());
    case IndexSpace::active_tasks:
      return same(scene.inputs.active_tasks.size());
    default:
      throw std::logic_error(std::string("no sizes of ") + row.symbol);
  }
}

}  // namespace

std::vector<double> inertia_sizes(const std::vector<SceneInertia>& bodies) {
  std::vector<double> sizes;
  for (const SceneInertia& body : bodies) {
    sizes.push_back(body.mass);
    sizes.insert(sizes.end(), 3, body.mass * body.reach);
    sizes.insert(sizes.end(), 6, body.mass * body.reach * body.reach);
  }
  return sizes;
}

std::optional<double> Domain::find(std::string_view input) const {
  const std::size_t bracket = input.find('[');
  if (bracket == std::string_view::npos) return std::nullopt;
  if (const auto size = each.find(input.substr(0, bracket)); size != each.end()) {
    return size->second;
  }
  const auto entries = sizes.find(input.substr(0, bracket));
  if (entries == sizes.end()) return std::nullopt;
  std::size_t index = 0;
  std::from_chars(input.data() + bracket + 1, input.data() + input.size(), index);
  if (index >= entries->second.size()) return std::nullopt;
  return entries->second[index];
}

bool Domain::contains(std::string_view argument, const std::vector<double>& values) const {
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto size = find(fmt::format("{}[{}]", argument, i));
    if (!size || !(std::abs(values[i]) <= *size)) return false;
  }
  return true;
}

Domain make_domain(const Robot& robot, const Scene& scene, const Mechanism& mechanism) {
  Domain domain;
  for (const QuantityInfo& row : kQuantities) {
    if (row.space == IndexSpace::base_parameters) continue;  // see `add_base_parameters`
    if (has_one_size(row.space)) {
      domain.each[row.symbol] = row.range;
    } else {
      domain.sizes[row.symbol] = sizes_of(row, robot, scene, mechanism);
    }
  }
  for (const MovingLink& link : mechanism.links) {
    if (link.quaternion() < 0) continue;
    domain.quaternions.emplace_back(Quantity::q,
                                    static_cast<std::size_t>(link.q_index + link.quaternion()));
  }
  for (std::size_t k = 0; k < count_orientations(scene); ++k) {
    domain.quaternions.emplace_back(Quantity::tool_orientation, 4 * k);
  }
  return domain;
}

std::string describe(const Domain& domain, const std::vector<std::string>& arguments) {
  std::string text;
  for (const std::string& argument : arguments) {
    std::vector<double> sizes;
    if (const auto found = domain.sizes.find(argument); found != domain.sizes.end()) {
      sizes = found->second;
    } else if (const auto each = domain.each.find(argument); each != domain.each.end()) {
      sizes = {each->second};
    }
    if (sizes.empty()) continue;
    text += fmt::format("{}|{}| <=", text.empty() ? "" : ", ", argument);
    const bool same = std::all_of(sizes.begin(), sizes.end(),
                                  [&sizes](double size) { return size == sizes.front(); });
    for (std::size_t i = 0; i < (same ? 1 : sizes.size()); ++i)
      text += fmt::format(" {:.4g}", round_down(sizes[i], 4));
  }
  const auto has = [&](Quantity quantity) {
    return std::count(arguments.begin(), arguments.end(), symbol_of(quantity)) > 0;
  };
  if (has(Quantity::payload)) text += ", payload that of a body";
  for (const Quantity share : {Quantity::active, Quantity::active_tasks}) {
    if (has(share)) text += fmt::format(", {} not negative", symbol_of(share));
  }
  if (has(Quantity::tool_orientation)) text += ", tool_orientation of length 1";
  if (has(Quantity::parameters)) {
    text +=
        ", parameters those of a body of at least a tenth of this mass, with radii of gyration "
        "of at least a tenth of |m c| / m";
  }
  if (has(Quantity::base_parameters)) {
    text += ", base_parameters those of bodies of up to twice the URDF's mass and extent";
  }
  return text +
         (has(Quantity::sin_q) ? ", sin_q^2 + cos_q^2 = 1 of each angle but for rounding" : "");
}

}  // namespace treeline
