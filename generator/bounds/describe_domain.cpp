#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "bounds/domain.hpp"

namespace treeline {
namespace {

const Joint* find_joint(const Robot& robot, const std::string& name) {
  const auto found = std::find_if(robot.joints.begin(), robot.joints.end(),
                                  [&name](const Joint& joint) { return joint.name == name; });
  return found == robot.joints.end() ? nullptr : &*found;
}

double finite_or(double value, double otherwise) {
  return std::isfinite(value) && value > 0 ? value : otherwise;
}

/// Largest magnitude of a coordinate: its limits, or the default for its kind.
double coordinate_size(const Coordinate& coordinate, const DomainDefaults& defaults) {
  if (coordinate.is_of_quaternion()) return 1;
  const double size = std::max(std::abs(coordinate.lower), std::abs(coordinate.upper));
  return std::isfinite(size) ? size : coordinate.is_angle() ? defaults.angle : defaults.position;
}

void set_rates(const Robot& robot, const Mechanism& mechanism, const DomainDefaults& defaults,
               Domain& domain) {
  const auto nv = static_cast<std::size_t>(mechanism.nv());
  std::vector<double> velocity(nv, defaults.velocity), effort(nv, defaults.effort);
  for (const MovingLink& link : mechanism.links) {
    const Joint* joint = find_joint(robot, link.joint);
    if (link.mimics || link.kind == JointKind::floating || joint == nullptr || !joint->limits) {
      continue;
    }
    const auto at = static_cast<std::size_t>(link.v_index);
    velocity[at] = finite_or(joint->limits->velocity, defaults.velocity);
    effort[at] = finite_or(joint->limits->effort, defaults.effort);
  }
  domain.sizes["qd"] = std::move(velocity);
  domain.sizes["tau"] = std::move(effort);
  domain.sizes["qdd"] = domain.sizes["qdd_0"] = std::vector<double>(nv, defaults.acceleration);
}

/// Rounds down to four digits. A larger value would state a range in which the bound may not hold.
double rounded_down(double value) {
  if (value == 0) return 0;
  const double last = std::pow(10, std::floor(std::log10(value)) - 3);
  return std::floor(value / last * (1 + 1e-12)) * last;
}

}  // namespace

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

Domain make_domain(const Robot& robot, const Scene& scene, const Mechanism& mechanism,
                   const DomainDefaults& defaults) {
  Domain domain;
  const std::size_t nq = mechanism.coordinates.size();
  for (const Coordinate& coordinate : mechanism.coordinates) {
    domain.sizes["q"].push_back(coordinate_size(coordinate, defaults));
  }
  for (const MovingLink& link : mechanism.links) {
    const auto first = static_cast<std::size_t>(link.q_index);
    if (link.kind == JointKind::floating) domain.quaternions.push_back(first + 3);
  }
  domain.sizes["sin_q"] = domain.sizes["cos_q"] = std::vector<double>(nq, 1);
  set_rates(robot, mechanism, defaults, domain);
  domain.sizes["xdd_cmd"] =
      std::vector<double>(static_cast<std::size_t>(mechanism.task_rows()), defaults.acceleration);
  domain.sizes["f_ext"] = std::vector<double>(6 * scene.external_forces.size(), defaults.effort);
  domain.each = {{"impulse", defaults.impulse},
                 {"internal", defaults.effort},
                 {"normals", 1},
                 {"stabilisation", defaults.gain},
                 {"xdd_object", defaults.acceleration}};
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
      text += fmt::format(" {:.4g}", rounded_down(sizes[i]));
  }
  const bool given = std::count(arguments.begin(), arguments.end(), "sin_q") > 0;
  return text + (given ? ", sin_q^2 + cos_q^2 = 1 of each angle but for rounding" : "");
}

}  // namespace treeline
