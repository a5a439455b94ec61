#include "bench/bench.hpp"

#include <algorithm>
#include <utility>

#include "bench/bench_truths.hpp"
#include "bench/contender.hpp"
#include "bench/peer_contenders.hpp"
#include "bench/plan_builds.hpp"
#include "compilation/temporary_folder.hpp"
#include "emission/write_files.hpp"

namespace treeline {
namespace {

constexpr std::size_t kTimedStates = 64;

/// Summarises the times of one contender's code at each of its places.
void summarise_places(const std::vector<Timing>& timings, BenchRow& row) {
  const auto by_time = [](const Timing& a, const Timing& b) {
    return a.nanoseconds < b.nanoseconds;
  };
  std::vector<Timing> sorted = timings;
  std::sort(sorted.begin(), sorted.end(), by_time);
  row.timing = sorted[sorted.size() / 2];
  row.placement = sorted.back().nanoseconds / sorted.front().nanoseconds;
}

/// Ends of the results that are compared. Forces are not compared where rows depend on each other:
/// their distribution is a choice.
std::vector<std::size_t> compared_ends(const GeneratedFunction& function) {
  std::vector<std::size_t> ends;
  for (const Result& result : function.program.results) {
    ends.push_back((ends.empty() ? 0 : ends.back()) + result.values.size());
    if (function.function == Function::constrained_forward_dynamics) break;
  }
  return ends;
}

class Bench {
 public:
  /// `work` is an empty folder for compiling.
  Bench(const Robot& robot, const Scene& scene, const BenchOptions& options,
        const std::filesystem::path& work, Diagnostics& diagnostics)
      : robot_(robot), scene_(scene), options_(options), diagnostics_(diagnostics), work_(work) {}

  std::optional<BenchReport> run() {
    tell("generating", 0, 1);
    const auto builds = plan_builds(robot_, scene_, options_.flags, options_.groups, diagnostics_);
    if (!builds) return std::nullopt;
    tell("generating", 1, 1);
    truths_.emplace(robot_, scene_, builds->front().functions, options_);
    for (const StateReference& reference : truths_->timed()) {
      if (timed_.size() < kTimedStates) timed_.push_back(reference.state);
    }
    if (!compile(*builds)) return std::nullopt;
    if (wants(VariantGroup::interpreter)) add(interpreter_contenders(robot_, scene_, timed_));
    if (wants(VariantGroup::solve) && !add_factorisations(builds->front())) return std::nullopt;
    if (wants(VariantGroup::peer) && !add_peers(builds->front().functions)) return std::nullopt;
    return measure(builds->front().functions);
  }

 private:
  void tell(const char* what, int done, int total) const {
    if (options_.progress) options_.progress(what, done, total);
  }

  [[nodiscard]] bool wants(VariantGroup group) const { return is_wanted(group, options_.groups); }

  void add(std::vector<Contender> contenders) {
    std::move(contenders.begin(), contenders.end(), std::back_inserter(contenders_));
  }

  bool compile(const std::vector<VariantBuild>& builds) {
    const int total = static_cast<int>(builds.size());
    for (int i = 0; i < total; ++i) {
      tell("compiling", i, total);
      const std::string folder = "build" + std::to_string(i);
      auto made = compile_contenders(builds[static_cast<std::size_t>(i)], timed_, work_ / folder,
                                     options_.places, i == 0 ? &command_ : nullptr, diagnostics_);
      if (!made) return false;
      add(std::move(*made));
    }
    tell("compiling", total, total);
    return true;
  }

  /// Adds factorisations of the emitted Lambda^-1 in double, if the scene has Lambda.
  bool add_factorisations(const VariantBuild& emitted) {
    const auto& functions = scene_.functions;
    if (std::find(functions.begin(), functions.end(), Function::lambda) == functions.end()) {
      return true;
    }
    Scene scene = scene_;
    scene.real = Real::float64;
    scene.functions = {Function::lambda_inverse};
    const auto build = plan_emitted(robot_, scene, emitted.flags, diagnostics_);
    if (!build) return false;
    auto made =
        compile_contenders(*build, timed_, work_ / "lambda_inverse", 1, nullptr, diagnostics_);
    if (!made) return false;
    const int rows = build->functions.front().program.results.front().argument.rows;
    add(factorisation_contenders(made->front(), rows));
    return true;
  }

  bool add_peers(const std::vector<GeneratedFunction>& functions) {
    if (options_.peers.peers.empty()) return true;
    const auto description = describe_to_peers(robot_, scene_, no_peers_);
    if (!description) return true;
    if (truths_->lacks_held_states()) {
      no_peers_ = "no state was found that keeps the constraints";
      return true;
    }
    const GeneratedFile urdf{"peers.urdf", print_plain_urdf(robot_, scene_)};
    const auto folder = work_ / "peers";
    if (!write_files(folder, {urdf}, diagnostics_)) return false;
    for (const LoadedPeer& peer : options_.peers.peers) {
      tell("opening", static_cast<int>(peers_.size()),
           static_cast<int>(options_.peers.peers.size()));
      auto made =
          peer_contenders(peer, *description, folder / urdf.name, scene_, functions, timed_);
      if (truths_->has_quaternions() && !scene_.holds_rows() && !made.contenders.empty()) {
        made.peer.remarks.emplace_back("is compared where quaternions have unit length in double");
      }
      peers_.push_back(std::move(made.peer));
      add(std::move(made.contenders));
    }
    return true;
  }

  BenchReport measure(const std::vector<GeneratedFunction>& functions) {
    BenchReport report{scene_.name,     robot_.name,   describe_machine(command_),
                       options_.states, options_.seed, {}};
    report.peers = peers_;
    report.absent_peers = options_.peers.absent;
    report.no_peers = no_peers_;
    const int total = static_cast<int>(functions.size());
    for (int i = 0; i < total; ++i) {
      tell("measuring", i, total);
      report.functions.push_back(
          measure_function(functions[static_cast<std::size_t>(i)], static_cast<std::size_t>(i)));
    }
    tell("measuring", total, total);
    return report;
  }

  BenchFunction measure_function(const GeneratedFunction& function, std::size_t i) const {
    BenchFunction made{function.function, {}, 0, 0};
    for (const StateReference& reference : truths_->timed()) {
      ++(is_comparable(reference.functions[i]) ? made.states : made.singular);
    }
    const std::vector<std::size_t> ends = compared_ends(function);
    std::vector<TimedPass> passes;
    std::vector<std::size_t> ends_of_rows;
    for (const Contender& contender : contenders_) {
      if (contender.variant.function != function.function) continue;
      BenchRow row = measure_errors(contender, i, ends);
      if (contender.variant.group == VariantGroup::peer && !(row.norm.median <= kAgreement)) {
        made.disagreeing.push_back(std::move(row));
        continue;
      }
      made.rows.push_back(std::move(row));
      passes.insert(passes.end(), contender.passes.begin(), contender.passes.end());
      ends_of_rows.push_back(passes.size());
    }
    const std::vector<Timing> timings = time_passes(passes, options_.timing);
    auto next = timings.begin();
    for (std::size_t k = 0; k < made.rows.size(); ++k) {
      const auto end = timings.begin() + static_cast<std::ptrdiff_t>(ends_of_rows[k]);
      summarise_places({next, end}, made.rows[k]);
      next = end;
    }
    mark_front(made.rows);
    return made;
  }

  BenchRow measure_errors(const Contender& contender, std::size_t i,
                          const std::vector<std::size_t>& ends) const {
    std::vector<double> norms;
    std::vector<double> components;
    for (const StateReference& reference : truths_->of(contender.variant)) {
      const FunctionReference& truth = reference.functions[i];
      if (!is_comparable(truth)) continue;
      const AnswerError error = measure_error(contender.call(reference.state), truth, ends);
      norms.push_back(error.norm);
      components.push_back(error.component);
    }
    BenchRow row{contender.variant, {}, 1, summarise_errors(norms), summarise_errors(components)};
    row.compiled = contender.compiled;
    return row;
  }

  const Robot& robot_;
  const Scene& scene_;
  const BenchOptions& options_;
  Diagnostics& diagnostics_;
  const std::filesystem::path& work_;
  std::string command_;
  std::optional<BenchTruths> truths_;
  std::vector<State> timed_;
  std::vector<Contender> contenders_;
  std::vector<BenchPeer> peers_;
  std::string no_peers_;
};

}  // namespace

std::optional<BenchReport> run_bench(const Robot& robot, const Scene& scene,
                                     const BenchOptions& options, Diagnostics& diagnostics) {
  const auto work = make_temporary_folder(diagnostics);
  if (!work) return std::nullopt;
  return Bench(robot, scene, options, work->path(), diagnostics).run();
}

}  // namespace treeline
