#include "finite/extreme_states.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "interpreter/joint_parts.hpp"

namespace treeline::tests {
namespace {

constexpr double kQuarterTurn = 1.5707963267948966;
constexpr double kLeast = std::numeric_limits<double>::denorm_min();

enum Kind { zero, limit, low, high, quarter, many_turns, tiny, denormal, ordinary, kinds };

/// Draws a number of either sign. The logarithm of its magnitude is uniform.
double draw_logarithmic(Rng& rng, double least, double greatest) {
  const double magnitude =
      std::exp(std::log(least) + rng.unit() * (std::log(greatest) - std::log(least)));
  return rng.chance(0.5) ? magnitude : -magnitude;
}

double draw_within(Rng& rng, const Coordinate& coordinate) {
  const auto [lower, upper] = coordinate.ordinary_range();
  return rng.within(lower, upper);
}

/// The limit, or a turn or 1 m if there is none.
double bounded(double limit, const Coordinate& coordinate) {
  const double reach = coordinate.is_angle() ? 4 * kQuarterTurn : 1;
  return std::isfinite(limit) ? limit : std::copysign(reach, limit);
}

}  // namespace

ExtremeStates::ExtremeStates(const StateSpace& space, double length,
                             std::vector<std::vector<double>> singular)
    : space_(space),
      singular_(std::move(singular)),
      sizes_(input_sizes(space.single_precision ? Real::float32 : Real::float64)),
      length_(length) {
  for (const auto& body : space.subject.model.bodies) {
    const int quaternion = interpreter::quaternion_of(body);
    if (quaternion >= 0) quaternions_.push_back(quaternion);
  }
}

double ExtremeStates::draw_coordinate(Rng& rng, int kind, std::size_t i) const {
  const Coordinate& coordinate = space_.coordinates[i];
  switch (kind) {
    case zero:
      return rng.chance(0.1) ? -0.0 : 0.0;
    case limit:
      return bounded(rng.chance(0.5) ? coordinate.lower : coordinate.upper, coordinate);
    case low:
      return bounded(coordinate.lower, coordinate);
    case high:
      return bounded(coordinate.upper, coordinate);
    case quarter:
      return (coordinate.is_angle() ? kQuarterTurn : 0.5) * std::floor(rng.within(-4, 5));
    case many_turns:
      if (!coordinate.is_angle()) return draw_logarithmic(rng, 1, length_);
      return draw_logarithmic(rng, 1e3, rng.chance(0.8) ? 1e8 : sizes_.angle);
    case tiny:
      return draw_logarithmic(rng, 1e-300, 1e-2);
    case denormal:
      return rng.chance(0.5) ? kLeast : -kLeast;
    default:
      return draw_within(rng, coordinate);
  }
}

std::vector<double> ExtremeStates::draw_pose(Rng& rng) const {
  std::vector<double> q;
  if (!singular_.empty() && rng.chance(0.15)) {
    q = singular_[rng.below(singular_.size())];
    const int steps = static_cast<int>(rng.below(4));
    for (double& x : q) {
      for (int i = 0; i < steps; ++i) x = std::nextafter(x, rng.chance(0.5) ? 10.0 : -10.0);
    }
  } else {
    // One kind for all coordinates, or a different kind for each.
    const int whole = static_cast<int>(rng.below(kinds + 1));
    for (std::size_t i = 0; i < space_.coordinates.size(); ++i) {
      const int kind = whole < kinds ? whole : static_cast<int>(rng.below(kinds));
      q.push_back(draw_coordinate(rng, kind, i));
    }
  }
  for (const int first : quaternions_) draw_quaternion(rng, &q[static_cast<std::size_t>(first)]);
  return q;
}

void ExtremeStates::draw_quaternion(Rng& rng, double* xyzw) const {
  double norm = 0;
  const bool along_axis = rng.chance(0.3);
  const std::size_t axis = rng.below(4);
  for (std::size_t i = 0; i < 4; ++i) {
    xyzw[i] = along_axis ? (i == axis ? 1 : 0) : rng.within(1);
    norm = std::hypot(norm, xyzw[i]);
  }
  double length = 1;
  if (rng.chance(0.1)) {
    length = 0;
  } else if (rng.chance(0.3)) {
    length = std::abs(draw_logarithmic(rng, 1 / sizes_.quaternion, sizes_.quaternion));
  }
  const bool rounded = rng.chance(0.5);
  for (std::size_t i = 0; i < 4; ++i) {
    const double unit = norm > 0 ? xyzw[i] / norm : 0;
    xyzw[i] = length * (rounded ? static_cast<double>(static_cast<float>(unit)) : unit);
  }
}

std::vector<double> ExtremeStates::draw_rates(Rng& rng, std::size_t count, double most) const {
  const std::size_t whole = rng.below(5);
  const double size = std::abs(draw_logarithmic(rng, 1, most));
  std::vector<double> rates(count);
  for (double& rate : rates) {
    const std::size_t kind = whole < 4 ? whole : rng.below(5);
    rate = kind == 0   ? 0
           : kind == 1 ? rng.within(3)
           : kind == 2 ? rng.within(size)
           : kind == 3 ? draw_logarithmic(rng, 1e-300, most)
                       : (rng.chance(0.5) ? kLeast : most);
  }
  return rates;
}

/// Draws directions of length one or zero, three entries each.
std::vector<double> ExtremeStates::draw_directions(Rng& rng, std::size_t count) {
  std::vector<double> entries(count);
  for (std::size_t at = 0; at + 3 <= count; at += 3) {
    const bool along_axis = rng.chance(0.5);
    const std::size_t axis = rng.below(4);
    double norm = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      entries[at + i] = along_axis ? (i == axis ? 1 : 0) : rng.within(1);
      norm = std::hypot(norm, entries[at + i]);
    }
    for (std::size_t i = 0; i < 3 && norm > 0; ++i) entries[at + i] /= norm;
  }
  return entries;
}

void ExtremeStates::round(State& state) const {
  if (!space_.single_precision) return;
  const auto each = [](std::vector<double>& entries) {
    for (double& x : entries) x = static_cast<double>(static_cast<float>(x));
  };
  for (auto* entries :
       {&state.q, &state.qd, &state.qdd, &state.tau, &state.xdd_cmd, &state.f_ext}) {
    each(*entries);
  }
  for (auto& [quantity, entries] : state.others) each(entries);
}

State ExtremeStates::draw(std::int64_t index) const {
  Rng rng(space_.seed * 0x9E3779B97F4A7C15U + static_cast<std::uint64_t>(index));
  const auto nv = static_cast<std::size_t>(space_.subject.model.nv);
  State state;
  state.index = static_cast<int>(index);
  state.q = draw_pose(rng);
  state.qd = draw_rates(rng, nv, sizes_.velocity);
  state.qdd = draw_rates(rng, nv, sizes_.acceleration);
  state.tau = draw_rates(rng, nv, sizes_.acceleration);
  const auto rows = static_cast<std::size_t>(interpreter::row_count(space_.subject.points));
  state.xdd_cmd = draw_rates(rng, rows, sizes_.acceleration);
  state.f_ext = draw_rates(rng, 6 * space_.subject.external.size(), sizes_.acceleration);
  for (const auto& [quantity, count] : space_.others) {
    const auto size = static_cast<std::size_t>(count);
    state.others[quantity] = quantity == Quantity::normals ? draw_directions(rng, size)
                                                           : draw_rates(rng, size, sizes_.velocity);
  }
  round(state);
  for (const double angle : state.q) {
    state.sin_q.push_back(std::sin(angle));
    state.cos_q.push_back(std::cos(angle));
  }
  return state;
}

}  // namespace treeline::tests
