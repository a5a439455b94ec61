#include "oracle/draw_state.hpp"

#include <cmath>
#include <string_view>

#include "bounds/draw_body.hpp"
#include "bounds/rng.hpp"
#include "interpreter/joint_parts.hpp"
#include "oracle/term_sizes.hpp"

namespace treeline {
namespace {

constexpr double kQuarterTurn = 1.5707963267948966;

/// Draws a number of either sign. The logarithm of its magnitude is uniform.
double draw_logarithmic(Rng& rng, double least, double greatest) {
  const double magnitude = least * std::pow(greatest / least, rng.unit());
  return rng.chance(0.5) ? magnitude : -magnitude;
}

double draw_within_limits(Rng& rng, const Coordinate& coordinate) {
  const auto [lower, upper] = coordinate.ordinary_range();
  return rng.within(lower, upper);
}

double draw_aligned(Rng& rng, const Coordinate& coordinate) {
  if (rng.chance(0.3)) return draw_within_limits(rng, coordinate);
  const double step = coordinate.is_angle() ? kQuarterTurn : 0.5;
  const double at = step * std::floor(rng.within(-2, 3));
  return rng.chance(0.4) ? at : at + draw_logarithmic(rng, 1e-12, 1e-2);
}

/// Draws one of the coordinate's limits in most cases, and otherwise (or if that limit is infinite,
/// or an angle beyond `farthest`) a value from its ordinary range.
double draw_limit(Rng& rng, const Coordinate& coordinate, double farthest) {
  const double limit = rng.chance(0.5) ? coordinate.lower : coordinate.upper;
  const bool is_one =
      std::isfinite(limit) && !(coordinate.is_angle() && std::abs(limit) > farthest);
  if (!is_one || rng.chance(0.1)) return draw_within_limits(rng, coordinate);
  return limit;
}

double draw_coordinate(Rng& rng, StateClass kind, const Coordinate& coordinate, double farthest) {
  switch (kind) {
    case StateClass::neutral:
      return 0;
    case StateClass::large:
      return rng.within(coordinate.is_angle() ? 1000 : 10);
    case StateClass::tiny:
      return draw_logarithmic(rng, 1e-12, 1e-2);
    case StateClass::aligned:
      return draw_aligned(rng, coordinate);
    case StateClass::limits:
      return draw_limit(rng, coordinate, farthest);
    case StateClass::random:
    case StateClass::fast:
      break;
  }
  return draw_within_limits(rng, coordinate);
}

/// Draws a rotation, uniformly or, for some classes, close to none or to a quarter turn about an
/// axis. The quaternion has unit length up to rounding in double or, if `rounded`, in float.
std::array<double, 4> draw_quaternion(Rng& rng, StateClass kind, bool rounded) {
  std::array<double, 4> x{0, 0, 0, 1};
  if (kind == StateClass::neutral) return x;
  if (kind == StateClass::aligned) {
    x[static_cast<std::size_t>(rng.within(0, 3))] = rng.chance(0.5) ? 1 : 0;
    for (double& entry : x) entry += draw_logarithmic(rng, 1e-12, 1e-3);
  } else if (kind == StateClass::tiny) {
    for (std::size_t i = 0; i < 3; ++i) x[i] = draw_logarithmic(rng, 1e-12, 1e-2);
  } else {
    for (double& entry : x) entry = rng.within(1);
  }
  double norm = 0;
  for (const double entry : x) norm = std::hypot(norm, entry);
  for (double& entry : x) {
    entry /= norm;
    if (rounded) entry = static_cast<double>(static_cast<float>(entry));
  }
  return x;
}

/// Velocities and accelerations of a class, in radians or metres per second and per second squared.
struct Speed {
  double velocity, acceleration;
};
Speed speed(StateClass kind) {
  return kind == StateClass::fast ? Speed{50, 2000} : Speed{2, 10};
}

std::vector<double> draw_rates(Rng& rng, StateClass kind, std::size_t count, double size) {
  std::vector<double> rates(count);
  for (double& rate : rates) {
    rate = kind == StateClass::tiny ? draw_logarithmic(rng, 1e-12, 1e-2) : rng.within(size);
  }
  return rates;
}

std::vector<double> draw_q(Rng& rng, const StateSpace& space, const State& state) {
  const StateClass kind = state.kind;
  const double farthest = farthest_angle(space.single_precision);
  std::vector<double> q;
  for (const Coordinate& coordinate : space.coordinates) {
    q.push_back(draw_coordinate(rng, kind, coordinate, farthest));
  }
  for (const auto& body : space.subject.model.bodies) {
    const int first = interpreter::quaternion_of(body);
    if (first < 0) continue;
    const auto quaternion = draw_quaternion(rng, kind, state.index % 2 == 1);
    std::copy(quaternion.begin(), quaternion.end(), q.begin() + first);
  }
  return q;
}

/// Draws the inertial parameters of a body.
void draw_body(Rng& rng, const SubjectInertia& within, bool whole, std::vector<double>& entries) {
  std::array<double, kInertialParameters> choice{};
  for (double& each : choice) each = rng.within(1);
  const auto body = bounds::body_of({within.mass, within.reach, whole}, choice);
  entries.insert(entries.end(), body.begin(), body.end());
}

/// Base parameters that bodies, rotors and friction have.
std::vector<double> draw_base(Rng& rng, const SubjectInputs& inputs) {
  std::vector<double> numbers, entries;
  for (const SubjectInertia& box : inputs.base_bodies) draw_body(rng, box, true, numbers);
  for (const double size : inputs.base_drives) numbers.push_back(size * rng.unit());
  for (const SubjectBase& base : inputs.base) {
    double value = 0;
    for (const auto& [number, coefficient] : base.numbers) value += coefficient * numbers[number];
    entries.push_back(value);
  }
  return entries;
}

std::vector<double> draw_origins(Rng& rng, const std::vector<SubjectTool>& tools) {
  std::vector<double> entries;
  for (const SubjectTool& tool : tools) {
    for (int i = 0; i < 3; ++i) entries.push_back(rng.within(tool.reach));
  }
  return entries;
}

/// Draws shares: most often all or nothing.
std::vector<double> draw_shares(Rng& rng, std::size_t count) {
  std::vector<double> shares;
  for (std::size_t i = 0; i < count; ++i) {
    const double between = rng.unit();
    shares.push_back(rng.chance(0.5) ? 1 : rng.chance(0.5) ? 0 : between);
  }
  return shares;
}

/// Draws what the robot is at a state, within the ranges of the scene. The first state carries
/// nothing.
std::vector<double> draw_model(Rng& rng, const SubjectInputs& inputs, Quantity quantity,
                               const State& state) {
  std::vector<double> entries;
  switch (info_of(quantity).space) {
    case IndexSpace::payloads:
      for (const SubjectInertia& box : inputs.payloads) {
        draw_body(rng, state.index == 0 ? SubjectInertia{} : box, false, entries);
      }
      return entries;
    case IndexSpace::parameters:
      for (const SubjectInertia& box : inputs.parameters) draw_body(rng, box, true, entries);
      return entries;
    case IndexSpace::base_parameters:
      return draw_base(rng, inputs);
    case IndexSpace::tools:
      return draw_origins(rng, inputs.tools);
    case IndexSpace::contact_places:
      return draw_origins(rng, inputs.contacts);
    case IndexSpace::active_groups:
      return draw_shares(rng, inputs.active.size());
    case IndexSpace::active_tasks:
      return draw_shares(rng, inputs.active_tasks.size());
    case IndexSpace::orientations:
      for (const SubjectTool& tool : inputs.tools) {
        if (!tool.orientation) continue;
        const auto quaternion = draw_quaternion(rng, state.kind, state.index % 2 == 1);
        entries.insert(entries.end(), quaternion.begin(), quaternion.end());
      }
      return entries;
    default:
      for (int i = 0; i < 3; ++i) entries.push_back(rng.within(info_of(quantity).range));
      return entries;
  }
}

void round_to_float(State& state) {
  for (auto* entries :
       {&state.q, &state.qd, &state.qdd, &state.tau, &state.xdd_cmd, &state.f_ext}) {
    for (double& entry : *entries) entry = static_cast<double>(static_cast<float>(entry));
  }
  for (auto& [quantity, entries] : state.others) {
    for (double& entry : entries) entry = static_cast<double>(static_cast<float>(entry));
  }
}

}  // namespace

const char* state_class_name(StateClass kind) {
  constexpr std::array kNames = {"neutral", "random", "large", "fast", "tiny", "aligned", "limits"};
  return kNames[static_cast<std::size_t>(kind)];
}

namespace {

/// The member of a state that has a quantity; null for those among `State::others`.
template <class AnyState>
auto find_member(AnyState& state, Quantity quantity) -> decltype(&state.q) {
  switch (quantity) {
    case Quantity::q:
      return &state.q;
    case Quantity::sin_q:
      return &state.sin_q;
    case Quantity::cos_q:
      return &state.cos_q;
    case Quantity::qd:
      return &state.qd;
    case Quantity::qdd:
    case Quantity::qdd_0:
      return &state.qdd;
    case Quantity::tau:
      return &state.tau;
    case Quantity::xdd_cmd:
      return &state.xdd_cmd;
    case Quantity::f_ext:
      return &state.f_ext;
    case Quantity::impulse:
    case Quantity::internal:
    case Quantity::normals:
    case Quantity::stabilisation:
    case Quantity::xdd_object:
    case Quantity::gravity:
    case Quantity::payload:
    case Quantity::parameters:
    case Quantity::base_parameters:
    case Quantity::tool:
    case Quantity::tool_orientation:
    case Quantity::contact:
    case Quantity::active:
    case Quantity::active_tasks:
    case Quantity::drift:
    case Quantity::f_wanted:
    case Quantity::step:
      break;
  }
  return nullptr;
}

}  // namespace

const std::vector<double>& values_of(const State& state, Quantity quantity) {
  static const std::vector<double> kNone;
  if (const std::vector<double>* const member = find_member(state, quantity)) return *member;
  const auto found = state.others.find(quantity);
  return found == state.others.end() ? kNone : found->second;
}

std::vector<double>& place_of(State& state, Quantity quantity) {
  std::vector<double>* const member = find_member(state, quantity);
  return member != nullptr ? *member : state.others[quantity];
}

StateClass class_of_state(int index) {
  // One state of twenty is neutral; the first of them is also at rest.
  constexpr std::string_view kCycle = "nrafrltarfraflrtarfb";
  static_assert(kCycle.size() == kStatesOfEveryClass);
  constexpr std::string_view kLetters = "nrlftab";
  const char letter = kCycle[static_cast<std::size_t>(index) % kCycle.size()];
  return kStateClasses[kLetters.find(letter)];
}

State draw_state(const StateSpace& space, int index) {
  // Each state has its own seed.
  Rng rng(space.seed * 0x9E3779B97F4A7C15U + static_cast<std::uint64_t>(index));
  const auto nv = static_cast<std::size_t>(space.subject.model.nv);
  State state;
  state.index = index;
  state.kind = class_of_state(index);
  state.q = draw_q(rng, space, state);
  const bool at_rest = index == 0;
  const Speed size = at_rest ? Speed{0, 0} : speed(state.kind);
  state.qd = draw_rates(rng, state.kind, nv, size.velocity);
  state.qdd = draw_rates(rng, state.kind, nv, size.acceleration);
  const auto rows = static_cast<std::size_t>(interpreter::row_count(space.subject.points));
  state.xdd_cmd = draw_rates(rng, state.kind, rows, size.acceleration);
  state.f_ext = draw_rates(rng, state.kind, 6 * space.subject.external.size(), at_rest ? 0 : 50);
  // Forces of the size that such a motion requires.
  const auto forces = TermSizes(space.subject, state.q).forces(state.qd, state.qdd, state.f_ext);
  for (std::size_t i = 0; i < nv; ++i) {
    state.tau.push_back(at_rest ? 0 : rng.within(forces[static_cast<Eigen::Index>(i)]));
  }
  for (const auto& [quantity, count] : space.others) {
    if (is_of_model(quantity)) {
      state.others[quantity] = draw_model(rng, space.subject.inputs, quantity, state);
      continue;
    }
    if (quantity == Quantity::step) {
      state.others[quantity] = {info_of(quantity).range * rng.unit()};
      continue;
    }
    // At rest too: a direction is none without a length.
    state.others[quantity] = draw_rates(rng, state.kind, static_cast<std::size_t>(count),
                                        speed(state.kind).acceleration);
  }
  if (space.single_precision) round_to_float(state);
  const auto rounded = [&](double x) {
    return space.single_precision ? static_cast<double>(static_cast<float>(x)) : x;
  };
  for (const double angle : state.q) {
    state.sin_q.push_back(rounded(std::sin(angle)));
    state.cos_q.push_back(rounded(std::cos(angle)));
  }
  return state;
}

}  // namespace treeline
