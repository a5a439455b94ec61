#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <stdexcept>

#include "check/judges.hpp"
#include "choice/for_each_index.hpp"
#include "compilation/print_entry.hpp"
#include "generation/describe_limits.hpp"
#include "oracle/limited_optimum.hpp"

namespace treeline {
namespace {

/// k of the cost, as docs/explanation/limits.md states it.
double hierarchy_of(Real real) {
  return real == Real::float32 ? 30 : 1000;
}

/// Seventh root of so many units of rounding: cones of supports that are held less are left out.
double least_share_of(Real real) {
  return std::pow((real == Real::float32 ? 1 << 8 : 1 << 16) * unit_of(real), 1.0 / 7);
}

/// Largest error as a multiple of the effect of rounding the matrices. The unknowns of all levels
/// are one vector, in which the slack's are 100 k times as large as the posture's. Small unknowns
/// have the rounding errors of large ones, ten times over; and ten times again where cones of
/// supports that are held in part are as many times as wide as the slack says.
double of_sensitivity(Real real, const LimitFacts& facts) {
  return (facts.has_shares() ? 10000 : 1000) * hierarchy_of(real);
}

constexpr int kPerturbations = 2;

std::size_t find_supported(const Generation& generation, bool batch) {
  const auto functions = all_callable(generation);
  for (std::size_t i = 0; i < functions.size(); ++i) {
    if (functions[i].function != Function::supported_control_torque) continue;
    if ((functions[i].batch > 0) == batch) return i;
  }
  throw std::logic_error("limits without supported_control_torque");
}

/// Result of one call.
struct LimitedCall {
  std::vector<double> tau, f, lost;
  bool limited = false, solved = false;
  double slack = 0;
  LimitSides sides;
  bool wrote_out_of_bounds = false;
};

/// A state with what both laws gave there. Entries of a batch go from lane to lane, so that calls
/// are made one after the other.
struct CalledState {
  const State* state;
  LimitedCall limited, unlimited;
};

class LimitsJudge {
 public:
  LimitsJudge(const Robot& robot, const Scene& scene, const Generation& generation,
              const GeneratedLibrary& library, bool batch)
      : real_(scene.real),
        library_(library),
        supported_(find_supported(generation, batch)),
        entry_(library.find_entry(limited_stem(batch))),
        facts_(describe_limits(robot, scene, generation.mechanism, generation.functions)),
        subject_(make_subject<Digits50>(robot, scene, &generation.mechanism)) {
    if (entry_ == nullptr) throw std::logic_error("the entry of limits is not in the library");
  }

  LimitsReport judge(const std::vector<StateReference>& references, int threads);

 private:
  struct Compared {
    bool certified = false, irregular = false;
    int corrections = 0;
    std::array<double, 4> errors{};  ///< see `LimitsReport::worst_of`
    double sensitivity = 0;          ///< the same of rounded matrices, the largest
    [[nodiscard]] double error() const { return *std::max_element(errors.begin(), errors.end()); }
  };

  [[nodiscard]] LimitedCall call(const State& state) const;
  /// tau and f of the unlimited law.
  [[nodiscard]] LimitedCall call_unlimited(const State& state) const;
  void note_call(const LimitedCall& call, const LimitedCall& unlimited, LimitsReport& report) const;
  [[nodiscard]] Compared compare(const CalledState& called) const;
  /// Sizes of the results of the unlimited law.
  struct Yardsticks {
    double tau, f, lost;
  };
  [[nodiscard]] std::array<double, 4> errors_of(const LimitedCall& actual,
                                                const LimitedOptimum& optimum,
                                                const Yardsticks& sizes) const;
  [[nodiscard]] std::size_t velocities() const { return facts_.torque.size(); }
  [[nodiscard]] std::size_t held() const { return facts_.force_weights.size(); }
  [[nodiscard]] std::size_t sides() const {
    return velocities() - facts_.passive.size() + facts_.cones.size() + 1;
  }

  Real real_;
  const GeneratedLibrary& library_;
  std::size_t supported_;
  CompiledEntry entry_;
  LimitFacts facts_;
  Subject<Digits50> subject_;
};

/// Takes the next `count` entries.
std::vector<double> take(std::vector<double>::const_iterator& next, std::size_t count) {
  const auto first = next;
  next += static_cast<std::ptrdiff_t>(count);
  return {first, next};
}

LimitedCall LimitsJudge::call(const State& state) const {
  const std::size_t rows = facts_.task_weights.size();
  const CallResult result =
      library_.call_entry(entry_, supported_, state, {velocities(), held(), rows, 3, sides()});
  auto next = result.entries.cbegin();
  LimitedCall call;
  call.tau = take(next, velocities());
  call.f = take(next, held());
  call.lost = take(next, rows);
  call.limited = *next++ != 0;
  call.solved = *next++ == 0;
  call.slack = *next++;
  for (const double side : take(next, sides())) call.sides.push_back(side == 2 ? 0 : int(side));
  call.wrote_out_of_bounds = result.wrote_out_of_bounds;
  return call;
}

LimitedCall LimitsJudge::call_unlimited(const State& state) const {
  const CallResult result = library_.call(supported_, state);
  auto next = result.entries.cbegin();
  LimitedCall call;
  call.tau = take(next, velocities());
  call.f = take(next, held());
  return call;
}

void LimitsJudge::note_call(const LimitedCall& call, const LimitedCall& unlimited,
                            LimitsReport& report) const {
  ++report.states;
  report.out_of_bounds += call.wrote_out_of_bounds ? 1 : 0;
  if (!are_finite(unlimited.tau) || !are_finite(unlimited.f)) {
    ++report.singular;
    return;
  }
  report.unsolved += call.solved ? 0 : 1;
  bool within = true;
  for (std::size_t v = 0; v < velocities(); ++v) {
    const double limit = real_ == Real::float32
                             ? static_cast<double>(static_cast<float>(facts_.torque[v]))
                             : facts_.torque[v];
    within = within && std::abs(call.tau[v]) <= limit;  // false for NaN
  }
  report.beyond_limits += within ? 0 : 1;
  if (call.limited) {
    ++report.limited;
    return;
  }
  const bool same =
      std::equal(call.tau.begin(), call.tau.end(), unlimited.tau.begin(), same_bits) &&
      std::equal(call.f.begin(), call.f.end(), unlimited.f.begin(), same_bits);
  report.changed += same ? 0 : 1;
}

double largest_of(const std::vector<double>& entries) {
  double largest = 0;
  for (const double x : entries) largest = std::max(largest, std::abs(x));
  return largest;
}

/// The largest difference, relative to the larger of `size` and the expected entries.
double relative_error(const std::vector<double>& actual,
                      const interpreter::Vector<Digits50>& expected, double size) {
  double difference = 0;
  for (std::size_t i = 0; i < actual.size(); ++i) {
    const Digits50& x = expected(static_cast<Eigen::Index>(i));
    difference = std::max(difference, static_cast<double>(Digits50(abs(x - actual[i]))));
    size = std::max(size, static_cast<double>(Digits50(abs(x))));
  }
  return difference == 0 ? 0 : difference / size;
}

std::vector<double> in_double(const interpreter::Vector<Digits50>& x) {
  std::vector<double> entries;
  for (const Digits50& each : x) entries.push_back(static_cast<double>(each));
  return entries;
}

LimitedCall call_of(const LimitedOptimum& optimum) {
  LimitedCall call;
  call.tau = in_double(optimum.tau);
  call.f = in_double(optimum.f);
  call.lost = in_double(optimum.lost);
  call.slack = static_cast<double>(optimum.slack);
  return call;
}

std::array<double, 4> LimitsJudge::errors_of(const LimitedCall& actual,
                                             const LimitedOptimum& optimum,
                                             const Yardsticks& sizes) const {
  const auto slack = interpreter::Vector<Digits50>::Constant(1, optimum.slack);
  std::array<double, 4> errors{relative_error(actual.tau, optimum.tau, sizes.tau),
                               relative_error(actual.f, optimum.f, sizes.f),
                               relative_error({actual.slack}, slack, std::max(1.0, sizes.f)),
                               relative_error(actual.lost, optimum.lost, sizes.lost)};
  for (double& error : errors) error /= unit_of(real_);
  return errors;
}

LimitsJudge::Compared LimitsJudge::compare(const CalledState& called) const {
  const auto& [at, result, unlimited] = called;
  const State& state = *at;
  const LimitProblem problem = limit_problem(subject_, state, unlimited.tau, unlimited.f,
                                             hierarchy_of(real_), least_share_of(real_));
  Compared compared;
  compared.irregular = !fits_freedoms(problem, facts_, real_);
  if (compared.irregular) return compared;
  const auto optimum = find_limited_optimum(problem, facts_, result.sides);
  compared.certified = optimum.has_value();
  if (!optimum) return compared;
  compared.corrections = optimum->corrections;
  const Yardsticks sizes{largest_of(unlimited.tau), largest_of(unlimited.f),
                         static_cast<double>(optimum->lost_size)};
  compared.errors = errors_of(result, *optimum, sizes);
  const auto seed = static_cast<std::uint64_t>(state.index);
  for (int k = 0; k < kPerturbations; ++k) {
    const LimitProblem near =
        perturbed(problem, unit_of(real_), kPerturbations * seed + static_cast<std::uint64_t>(k));
    const LimitedCall moved = call_of(point_at_limits(near, facts_, optimum->sides));
    for (const double error : errors_of(moved, *optimum, sizes)) {
      compared.sensitivity = std::max(compared.sensitivity, error);
    }
  }
  return compared;
}

/// Places that are evenly spread over `count`, at most `most`.
std::vector<std::size_t> spread(std::size_t count, std::size_t most) {
  const std::size_t chosen = std::min(count, most);
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < chosen; ++i) places.push_back(i * count / chosen);
  return places;
}

LimitsReport LimitsJudge::judge(const std::vector<StateReference>& references, int threads) {
  LimitsReport report;
  std::vector<CalledState> limited;
  for (const auto& [state, functions] : references) {
    CalledState called{&state, call(state), call_unlimited(state)};
    note_call(called.limited, called.unlimited, report);
    if (called.limited.limited && called.limited.solved) limited.push_back(std::move(called));
  }
  const auto chosen = spread(limited.size(), kMostCertified);
  std::vector<double> errors;
  std::mutex noting;
  const auto look_at = [&](std::size_t i) {
    const State& state = *limited[chosen[i]].state;
    const Compared compared = compare(limited[chosen[i]]);
    const std::lock_guard lock(noting);
    report.irregular += compared.irregular ? 1 : 0;
    report.certified += compared.certified ? 1 : 0;
    report.uncertain += compared.irregular || compared.certified ? 0 : 1;
    if (!compared.certified) return;
    report.corrected += compared.corrections > 0 ? 1 : 0;
    errors.push_back(compared.error());
    report.of_bound = std::max(
        report.of_bound,
        compared.error() / (of_sensitivity(real_, facts_) * std::max(1.0, compared.sensitivity)));
    for (std::size_t k = 0; k < compared.errors.size(); ++k) {
      report.worst_of[k] = std::max(report.worst_of[k], compared.errors[k]);
    }
    const bool is_worse = report.worst_state < 0 || compared.error() > report.worst ||
                          (compared.error() == report.worst && state.index < report.worst_state);
    if (!is_worse) return;
    report.worst = compared.error();
    report.worst_sensitivity = compared.sensitivity;
    report.worst_state = state.index;
  };
  for_each_index(chosen.size(), look_at, threads);
  report.median = quantile(errors, 0.5);
  return report;
}

}  // namespace

std::vector<WorkSource> limited_sources(const Scene& scene, const Generation& generation) {
  if (!scene.has_limits()) return {};
  const auto functions = all_callable(generation);
  std::vector<WorkSource> sources;
  const auto add = [&](bool batch) {
    const GeneratedFunction& supported = functions[find_supported(generation, batch)];
    sources.push_back({limited_stem(batch), scene.language == Language::c
                                                ? print_c_limited_entry(scene.name, supported)
                                                : print_limited_entry(scene.name, supported)});
  };
  add(false);
  if (!generation.batch.empty()) add(true);
  return sources;
}

LimitsReport judge_limits(const Robot& robot, const Scene& scene, const Generation& generation,
                          const std::vector<StateReference>& references,
                          const GeneratedLibrary& library, bool batch, int threads) {
  LimitsReport report =
      LimitsJudge(robot, scene, generation, library, batch).judge(references, threads);
  report.name = limited_stem(batch);
  return report;
}

}  // namespace treeline
