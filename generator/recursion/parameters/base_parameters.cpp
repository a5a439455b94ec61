#include "recursion/parameters/base_parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "recursion/algebra/row_space.hpp"
#include "recursion/methods/merge_mimics.hpp"
#include "recursion/parameters/felt_motion.hpp"

namespace treeline {
namespace {

using Kind = ModelParameter::Kind;

/// Coefficients that are residue of cancellation in 50 digits.
const Digits50& residue() {
  static const Digits50 kOfCancellation("1e-25");
  return kOfCancellation;
}

/// Entries of J of the parameters 4..9.
constexpr std::array<std::array<int, 2>, 6> kEntries = {
    {{0, 0}, {0, 1}, {1, 1}, {0, 2}, {1, 2}, {2, 2}}};

/// Parameters of a link that name base parameters, the first choice first. With z as axis they are
/// those of Khalil: h_x, h_y, Ixx - Iyy, products and Izz.
constexpr std::array<int, kBodyNumbers> kPreferred = {1, 2, 3, 4, 5, 7, 8, 9, 6, 0, kRotorNumber};

/// A body whose inertial parameter `entry` is one, about its frame's origin: Sigma = tr(J)/2 - J.
Inertia unit_body(int entry) {
  if (entry < 4) return unit_inertia(entry);
  const auto [i, j] = kEntries[static_cast<std::size_t>(entry - 4)];
  Inertia body;
  body.Sigma(i, j) = body.Sigma(j, i) = -1;
  if (i == j) body.Sigma += Digits50Matrix3::Identity() / 2;
  return body;
}

/// The inertial parameters of a body.
std::array<Digits50, kInertialParameters> parameters_of(const Inertia& body) {
  const Digits50Matrix3 J = rotational_inertia(body);
  std::array<Digits50, kInertialParameters> parameters{body.mass, body.h(0), body.h(1), body.h(2)};
  for (std::size_t k = 0; k < kEntries.size(); ++k) {
    parameters[4 + k] = J(kEntries[k][0], kEntries[k][1]);
  }
  return parameters;
}

void add(const Combination& terms, const Digits50& factor, Combination& sum) {
  if (abs(factor) <= residue()) return;
  for (const auto& [parameter, coefficient] : terms) {
    Digits50& entry = sum[parameter];
    entry += factor * coefficient;
    if (abs(entry) <= residue()) sum.erase(parameter);
  }
}

/// Goes inward: of each link the parameters with what those behind it have added to them.
class Inward {
 public:
  Inward(const Mechanism& mechanism, const SceneRegressor& asked) : mechanism_(mechanism) {
    SceneRegressor of_all = asked;
    of_all.links.clear();
    of_all.none = false;
    of_all.payloads.clear();
    found_.parameters = list_model_parameters(mechanism, of_all);
    sums_.resize(mechanism.link_frames.size());
    for (std::size_t k = 0; k < found_.parameters.size(); ++k) {
      const ModelParameter& parameter = found_.parameters[k];
      if (parameter.kind == Kind::inertial) sums_[parameter.frame][at(parameter.entry)][k] = 1;
      if (parameter.kind == Kind::rotor) rotors_[link_of(parameter, mechanism)] = k;
      if (parameter.kind == Kind::viscous || parameter.kind == Kind::coulomb) add_friction(k);
    }
  }

  BaseParameters run() {
    std::set<std::size_t> with_rotors;
    for (const auto& [link, parameter] : rotors_) with_rotors.insert(link);
    const auto motions = felt_motions(mechanism_, units_, with_rotors);
    for (std::size_t frame = motions.size(); frame-- > 0;) {
      add_rotor(frame);
      gather(frame, motions[frame]);
    }
    for (BaseParameter& each : found_.base) scale(each);
    std::sort(found_.base.begin(), found_.base.end(),
              [](const auto& a, const auto& b) { return a.parameter < b.parameter; });
    merge_mimics(mechanism_, units_.tolerance, found_);
    list_those_without_effect();
    return std::move(found_);
  }

 private:
  using Sums = std::array<Combination, kBodyNumbers>;

  static std::size_t at(int entry) { return static_cast<std::size_t>(entry); }

  /// Friction is a base parameter, or part of one whose column is a multiple of its own.
  void add_friction(std::size_t k) {
    const ModelParameter& own = found_.parameters[k];
    for (BaseParameter& base : found_.base) {
      const ModelParameter& named = found_.parameters[base.parameter];
      const bool alike =
          named.kind == own.kind && named.v == own.v &&
          abs(Digits50(own.sharpness - named.sharpness)) <= residue() * own.sharpness;
      if (!alike) continue;
      base.combination[k] = own.factor / named.factor;
      return;
    }
    found_.base.push_back({k, {{k, Digits50(1)}}});
  }

  /// The rotor of the joint that carries a link.
  void add_rotor(std::size_t frame) {
    const auto found = rotors_.find(at(mechanism_.link_frames[frame].link));
    if (found != rotors_.end()) sums_[frame][kRotorNumber][found->second] = 1;
  }

  /// Numbers in the axes of the moving link, of the parameters of its frame.
  [[nodiscard]] Digits50Rows numbers_by_parameter(std::size_t frame) const {
    const Digits50Pose pose = in_units(mechanism_.link_frames[frame].pose, units_);
    Digits50Rows numbers = Digits50Rows::Zero(kBodyNumbers, kBodyNumbers);
    for (int k = 0; k < kInertialParameters; ++k) {
      numbers.col(k) = numbers_of(transformed(unit_body(k), pose)).transpose();
    }
    numbers(kRotorNumber, kRotorNumber) = 1;
    return numbers;
  }

  /// Makes base parameters of what the joint's motion reveals; the rest goes to the link before.
  void gather(std::size_t frame, const FeltMotion& motion) {
    const ReducedRows felt = reduce(motion.moving * numbers_by_parameter(frame),
                                    {kPreferred.begin(), kPreferred.end()}, units_.tolerance);
    const auto is_base = [&](int entry) {
      return std::find(felt.pivots.begin(), felt.pivots.end(), entry) != felt.pivots.end();
    };
    for (std::size_t row = 0; row < felt.pivots.size(); ++row) {
      Combination sum = sums_[frame][at(felt.pivots[row])];
      for (int entry = 0; entry < kBodyNumbers; ++entry) {
        if (is_base(entry)) continue;
        add(sums_[frame][at(entry)], felt.rows(static_cast<Eigen::Index>(row), entry), sum);
      }
      found_.base.push_back({parameter_at(frame, felt.pivots[row]), std::move(sum)});
    }
    for (int entry = 0; motion.parent >= 0 && entry < kBodyNumbers; ++entry) {
      if (is_base(entry) || sums_[frame][at(entry)].empty()) continue;
      hand_over(frame, entry, felt, motion);
    }
  }

  [[nodiscard]] std::size_t parameter_at(std::size_t frame, int entry) const {
    if (entry != kRotorNumber) return kInertialParameters * frame + at(entry);
    return rotors_.at(at(mechanism_.link_frames[frame].link));
  }

  /// A parameter that names no base parameter, less what it adds to those, does nothing at its
  /// joint. So it is one of the link before.
  void hand_over(std::size_t frame, int entry, const ReducedRows& felt, const FeltMotion& motion) {
    Inertia body = entry == kRotorNumber ? Inertia{} : unit_body(entry);
    for (std::size_t row = 0; row < felt.pivots.size(); ++row) {
      if (felt.pivots[row] == kRotorNumber) continue;
      const Digits50 share = -felt.rows(static_cast<Eigen::Index>(row), entry);
      const Inertia base = unit_body(felt.pivots[row]);
      body = body + Inertia{share * base.mass, share * base.h, share * base.Sigma};
    }
    const auto parent = at(motion.parent);
    const Digits50Pose moved = inverse(in_units(mechanism_.link_frames[parent].pose, units_)) *
                               motion.placement *
                               in_units(mechanism_.link_frames[frame].pose, units_);
    const auto values = parameters_of(transformed(body, moved));
    for (std::size_t k = 0; k < values.size(); ++k) {
      add(sums_[frame][at(entry)], values[k], sums_[parent][k]);
    }
  }

  /// Power of the unit of length in a parameter's unit.
  [[nodiscard]] Digits50 unit_of(std::size_t parameter) const {
    const ModelParameter& of = found_.parameters[parameter];
    const bool is_moment = of.kind == Kind::rotor ? !of.slides : of.entry > 3;
    if (is_moment) return units_.length * units_.length;
    return of.kind == Kind::inertial && of.entry > 0 ? units_.length : Digits50(1);
  }

  void scale(BaseParameter& base) const {
    const Digits50 own = unit_of(base.parameter);
    for (auto& [parameter, coefficient] : base.combination) coefficient *= own / unit_of(parameter);
  }

  void list_those_without_effect() {
    for (std::size_t k = 0; k < found_.parameters.size(); ++k) {
      const bool counts =
          std::any_of(found_.base.begin(), found_.base.end(),
                      [&](const BaseParameter& base) { return base.combination.contains(k); });
      if (!counts) found_.without_effect.push_back(k);
    }
  }

  const Mechanism& mechanism_;
  FeltUnits units_ = felt_units(mechanism_);
  BaseParameters found_;
  std::map<std::size_t, std::size_t> rotors_;  ///< by link of the mechanism
  std::vector<Sums> sums_;                     ///< by frame, in the units of length
};

}  // namespace

BaseParameters find_base_parameters(const Mechanism& mechanism, const SceneRegressor& asked) {
  return Inward(mechanism, asked).run();
}

std::shared_ptr<const BaseParameters> base_parameters_of(const Mechanism& mechanism) {
  BaseParameterMemo& memo = *mechanism.base_parameters;
  const std::lock_guard lock(memo.mutex);
  if (!memo.found || !(memo.asked == mechanism.regressor)) {
    memo.asked = mechanism.regressor;
    memo.found = std::make_shared<const BaseParameters>(
        find_base_parameters(mechanism, mechanism.regressor));
  }
  return memo.found;
}

Digits50 value_in_files(const ModelParameter& parameter, const Mechanism& mechanism) {
  if (!parameter.is_of_body()) {
    const JointDrive& drive = mechanism.links[link_of(parameter, mechanism)].drive;
    const Digits50& felt = parameter.kind == Kind::rotor     ? drive.inertia
                           : parameter.kind == Kind::viscous ? drive.damping
                                                             : drive.friction;
    return abs(felt) / parameter.factor;
  }
  Inertia matter = mechanism.link_matter[parameter.frame];
  const MechanismPoint& frame = mechanism.link_frames[parameter.frame];
  for (const auto* inertias : {&mechanism.inputs.parameters, &mechanism.inputs.base}) {
    for (const MechanismInertia& own : *inertias) {
      if (own.frame.link != frame.link) continue;
      matter = matter + transformed(own.nominal, inverse(frame.pose) * own.frame.pose);
    }
  }
  return parameters_of(matter)[static_cast<std::size_t>(parameter.entry)];
}

Digits50 value_in_files(const BaseParameter& base, const BaseParameters& found,
                        const Mechanism& mechanism) {
  Digits50 value = 0;
  for (const auto& [parameter, coefficient] : base.combination) {
    value += coefficient * value_in_files(found.parameters[parameter], mechanism);
  }
  return value;
}

std::string describe(const BaseParameter& base, const BaseParameters& found) {
  std::string text = name_of(found.parameters[base.parameter]);
  for (const auto& [parameter, exact] : base.combination) {
    if (parameter == base.parameter) continue;
    const auto coefficient = static_cast<double>(exact);
    const double size = std::abs(coefficient);
    text += fmt::format(" {} {}{}", coefficient < 0 ? "-" : "+",
                        size == 1 ? "" : fmt::format("{:.9g} ", size),
                        name_of(found.parameters[parameter]));
  }
  return text;
}

}  // namespace treeline
