#include "bounds/draw_inputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "functions/quantity.hpp"

namespace treeline::bounds {
namespace {

bool is_taken(Quantity quantity, const Graph& graph) {
  return std::any_of(graph.inputs().begin(), graph.inputs().end(),
                     [&](const std::string& name) { return quantity_of_input(name) == quantity; });
}

bool is_never_negative(const std::string& name) {
  const auto quantity = quantity_of_input(name);
  return quantity == Quantity::step || quantity == Quantity::active ||
         quantity == Quantity::active_tasks;
}

/// Whether an input is drawn anywhere in its range. Others are at their limits, where errors are
/// largest.
bool is_drawn_within(const std::string& name) {
  const auto quantity = quantity_of_input(name);
  return quantity == Quantity::q || quantity == Quantity::tool_orientation;
}

}  // namespace

InputSpace::InputSpace(const Graph& graph, const Domain& domain) {
  for (const std::string& name : graph.inputs()) {
    if (!domain.find(name)) missing_ = name;
    if (missing_) return;
    const auto quantity = quantity_of_input(name);
    const Reading reading = quantity == Quantity::sin_q   ? Reading::sine
                            : quantity == Quantity::cos_q ? Reading::cosine
                                                          : Reading::plain;
    const std::string angle = std::string(symbol_of(Quantity::q)).append(name, name.find('['));
    inputs_.push_back({entry_of(reading == Reading::plain ? name : angle, domain), reading});
  }
  find_bodies(Quantity::payload, graph, domain);
  find_bodies(Quantity::parameters, graph, domain);
  find_base(graph, domain);
  for (const auto& [quantity, first] : domain.quaternions) {
    if (quantity != Quantity::q && !is_taken(quantity, graph)) continue;
    std::vector<std::size_t>& quaternion = quaternions_.emplace_back();
    for (std::size_t i = first; i < first + 4; ++i) {
      quaternion.push_back(entry_of(fmt::format("{}[{}]", symbol_of(quantity), i), domain));
    }
  }
}

void InputSpace::find_bodies(Quantity quantity, const Graph& graph, const Domain& domain) {
  const std::string symbol = symbol_of(quantity);
  const auto sizes = domain.sizes.find(symbol);
  if (!is_taken(quantity, graph) || sizes == domain.sizes.end()) return;
  for (std::size_t first = 0; first < sizes->second.size(); first += kInertialParameters) {
    Body body;
    const double mass = sizes->second[first];
    body.range = {mass, sizes->second[first + 1] / mass, quantity == Quantity::parameters};
    for (std::size_t i = 0; i < body.entries.size(); ++i) {
      body.entries[i] = entry_of(fmt::format("{}[{}]", symbol, first + i), domain);
    }
    bodies_.push_back(body);
  }
}

/// Numbers that are no input themselves are entries of the space too: the base parameters follow
/// from them.
void InputSpace::find_base(const Graph& graph, const Domain& domain) {
  if (!is_taken(Quantity::base_parameters, graph)) return;
  const std::size_t first = entries_.size();
  for (const double size : inertia_sizes(domain.base.bodies)) {
    entries_.push_back({"inertial", size, false, false});
  }
  for (std::size_t k = 0; k < domain.base.bodies.size(); ++k) {
    const SceneInertia& within = domain.base.bodies[k];
    Body body{{}, {within.mass, within.reach, true}};
    for (std::size_t i = 0; i < body.entries.size(); ++i) {
      body.entries[i] = first + kInertialParameters * k + i;
    }
    bodies_.push_back(body);
  }
  for (const double size : domain.base.drives) entries_.push_back({"drive", size, false, true});
  for (std::size_t k = 0; k < domain.base.rows.size(); ++k) {
    Base base{entry_of(fmt::format("{}[{}]", symbol_of(Quantity::base_parameters), k), domain), {}};
    for (const auto& [number, coefficient] : domain.base.rows[k]) {
      base.terms.emplace_back(first + number, coefficient);
    }
    bases_.push_back(std::move(base));
  }
}

std::size_t InputSpace::entry_of(const std::string& name, const Domain& domain) {
  const auto found = std::find_if(entries_.begin(), entries_.end(),
                                  [&name](const Entry& entry) { return entry.name == name; });
  const auto at = static_cast<std::size_t>(found - entries_.begin());
  if (found == entries_.end()) {
    entries_.push_back(
        {name, domain.find(name).value_or(0), is_drawn_within(name), is_never_negative(name)});
  }
  return at;
}

double InputSpace::draw_entry(const Entry& entry, Rng& rng) const {
  if (entry.coordinate) return rng.within(entry.size);
  return entry.positive || rng.chance(0.5) ? entry.size : -entry.size;
}

InputSpace::Point InputSpace::draw(Rng& rng) const {
  Point point;
  for (const Entry& entry : entries_) point.push_back(draw_entry(entry, rng));
  return point;
}

InputSpace::Point InputSpace::change(Point point, Rng& rng) const {
  if (point.empty()) return point;
  const std::size_t count = 1 + rng.below(3);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = rng.below(point.size());
    const double size = entries_[i].size;
    const double step = rng.within(size) * std::pow(10, -static_cast<double>(rng.below(6)));
    const double least = entries_[i].positive ? 0 : -size;
    point[i] =
        rng.chance(0.4) ? draw_entry(entries_[i], rng) : std::clamp(point[i] + step, least, size);
  }
  return point;
}

void InputSpace::put_bodies(Point& values) const {
  for (const Body& body : bodies_) {
    std::array<double, kInertialParameters> entries{};
    for (std::size_t i = 0; i < entries.size(); ++i) {
      entries[i] = values[body.entries[i]] / entries_[body.entries[i]].size;
    }
    entries = body_of(body.range, entries);
    for (std::size_t i = 0; i < entries.size(); ++i) values[body.entries[i]] = entries[i];
  }
}

void InputSpace::put(const Point& point, std::size_t s, std::vector<States>& inputs) const {
  Point values = point;
  put_bodies(values);
  for (const Base& base : bases_) {
    values[base.entry] = 0;
    for (const auto& [entry, coefficient] : base.terms) {
      values[base.entry] += coefficient * values[entry];
    }
  }
  for (const std::vector<std::size_t>& quaternion : quaternions_) {
    double norm = 0;
    for (const std::size_t i : quaternion) norm = std::hypot(norm, values[i]);
    for (const std::size_t i : quaternion) values[i] /= norm;
  }
  inputs.resize(inputs_.size());
  for (std::size_t i = 0; i < inputs_.size(); ++i) {
    const double value = values[inputs_[i].entry];
    switch (inputs_[i].reading) {
      case Reading::plain:
        inputs[i][s] = value;
        break;
      case Reading::sine:
        inputs[i][s] = std::sin(value);
        break;
      case Reading::cosine:
        inputs[i][s] = std::cos(value);
        break;
    }
  }
}

}  // namespace treeline::bounds
