#include "check/judge_limits.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <stdexcept>

#include "check/judge_function.hpp"
#include "check/print_entry.hpp"
#include "generation/describe_limits.hpp"
#include "generation/for_each_index.hpp"
#include "oracle/limited_optimum.hpp"

namespace treeline {
namespace {

/// k of the cost, as generator/README.md states it.
double hierarchy_of(Real real) {
  return real == Real::float32 ? 30 : 1000;
}

/// How many times the effect of rounding the matrices an error may be: the unknowns of all levels
/// are one vector, in which those of the slack are 100 k times as large as those of the posture.
/// What is small in it has the rounding errors of what is large, ten times over.
double of_sensitivity(Real real) {
  return 1000 * hierarchy_of(real);
}

constexpr int kPerturbations = 2;

std::size_t find_supported(const Generation& generation) {
  const auto functions = all_callable(generation);
  for (std::size_t i = 0; i < functions.size(); ++i) {
    const bool batch = functions[i].batch > 0;
    if (!batch && functions[i].function == Function::supported_control_torque) return i;
  }
  throw std::logic_error("limits without supported_control_torque");
}

/// What one call gave.
struct LimitedCall {
  std::vector<double> tau, f, lost;
  bool limited = false, solved = false;
  double slack = 0;
  LimitSides sides;
  bool wrote_out_of_bounds = false;
};

class LimitsJudge {
 public:
  LimitsJudge(const Robot& robot, const Scene& scene, const Generation& generation,
              const GeneratedLibrary& library)
      : real_(scene.real),
        library_(library),
        supported_(find_supported(generation)),
        entry_(library.find_entry(kLimitedName)),
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
  void note_call(const State& state, const LimitedCall& call, LimitsReport& report) const;
  [[nodiscard]] Compared compare(const State& state) const;
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

void LimitsJudge::note_call(const State& state, const LimitedCall& call,
                            LimitsReport& report) const {
  ++report.states;
  report.out_of_bounds += call.wrote_out_of_bounds ? 1 : 0;
  const LimitedCall unlimited = call_unlimited(state);
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

LimitsJudge::Compared LimitsJudge::compare(const State& state) const {
  const LimitedCall result = call(state);
  const LimitedCall unlimited = call_unlimited(state);
  const LimitProblem problem =
      limit_problem(subject_, state, unlimited.tau, unlimited.f, hierarchy_of(real_));
  Compared compared;
  compared.irregular = !has_ordinary_freedoms(problem, facts_);
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

/// Evenly spread over what is listed, at most `most`.
std::vector<std::size_t> spread(const std::vector<std::size_t>& listed, std::size_t most) {
  if (listed.size() <= most) return listed;
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < most; ++i) chosen.push_back(listed[i * listed.size() / most]);
  return chosen;
}

LimitsReport LimitsJudge::judge(const std::vector<StateReference>& references, int threads) {
  LimitsReport report;
  std::vector<std::size_t> limited;
  for (std::size_t i = 0; i < references.size(); ++i) {
    const LimitedCall result = call(references[i].state);
    note_call(references[i].state, result, report);
    if (result.limited && result.solved) limited.push_back(i);
  }
  const auto chosen = spread(limited, kMostCertified);
  std::vector<double> errors;
  std::mutex noting;
  const auto look_at = [&](std::size_t i) {
    const State& state = references[chosen[i]].state;
    const Compared compared = compare(state);
    const std::lock_guard lock(noting);
    report.irregular += compared.irregular ? 1 : 0;
    report.certified += compared.certified ? 1 : 0;
    report.uncertain += compared.irregular || compared.certified ? 0 : 1;
    if (!compared.certified) return;
    report.corrected += compared.corrections > 0 ? 1 : 0;
    errors.push_back(compared.error());
    report.of_bound =
        std::max(report.of_bound,
                 compared.error() / (of_sensitivity(real_) * std::max(1.0, compared.sensitivity)));
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
  const GeneratedFunction& supported = functions[find_supported(generation)];
  return {{kLimitedName,
           scene.language == Language::c
               ? print_c_limited_entry(scene.name, supported)
               : print_limited_entry(scene.name, supported, scene.profile == Profile::misra)}};
}

LimitsReport judge_limits(const Robot& robot, const Scene& scene, const Generation& generation,
                          const std::vector<StateReference>& references,
                          const GeneratedLibrary& library, int threads) {
  return LimitsJudge(robot, scene, generation, library).judge(references, threads);
}

}  // namespace treeline
