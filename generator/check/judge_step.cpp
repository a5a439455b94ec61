#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "check/judges.hpp"
#include "check/step_dynamics.hpp"
#include "check/step_library.hpp"
#include "check/step_motion.hpp"
#include "compilation/print_step_entry.hpp"
#include "compilation/run_commands.hpp"
#include "core/mode.hpp"
#include "emission/controller_unit.hpp"
#include "emission/write_files.hpp"

namespace treeline {
namespace {

namespace fs = std::filesystem;

/// Steps between two that are compared although nothing happens in them.
constexpr int kStride = 10;

/// Allowed errors: ulp of the largest number of a member, and the share of what rounding changes:
/// that of the inputs, and of law and interpreter in the code's type.
constexpr long double kFloorUlp = 16;
constexpr long double kOfRounding = 16;

/// Times that the inputs are rounded.
constexpr int kRoundings = 3;

/// Least size of a member, SI units: terms that cancel, such as those of a rotation matrix, have
/// it.
constexpr long double kOrdinary = 1;

/// The laws in long double, and in the code's type: the difference is what rounding does.
struct References {
  StepLibrary exact, rounding;
};

/// The command that makes a library of the laws in numbers of that type, and the library.
struct ReferenceBuild {
  Command command;
  fs::path library;
};

std::optional<ReferenceBuild> write_reference(const Scene& scene, const Generation& generation,
                                              Command command, const fs::path& folder,
                                              const char* real, Diagnostics& diagnostics) {
  const auto files =
      print_step_reference(scene.name, generation.laws, *generation.controller, real);
  if (!write_files(folder, files, diagnostics)) return std::nullopt;
  for (const char* word : {"-std=c++17", "-O1", "-fPIC", "-shared", "-Wl,-Bsymbolic", "-o"}) {
    command.emplace_back(word);
  }
  const fs::path library = folder / "libstep_reference.so";
  command.push_back(library);
  for (const std::string& stem : list_reference_stems()) {
    command.push_back(folder / (stem + ".cpp"));
  }
  return ReferenceBuild{std::move(command), library};
}

std::optional<References> compile_references(const Scene& scene, const Generation& generation,
                                             const CompileOptions& options, const fs::path& work,
                                             Diagnostics& diagnostics) {
  CompileOptions of_laws = options;
  of_laws.language = Language::cpp;
  if (options.language == Language::c) of_laws.compiler.clear();
  const auto compiler = find_compiler(of_laws, work, diagnostics);
  if (!compiler) return std::nullopt;
  const char* const real = scene.real == Real::float32 ? "float" : "double";
  const auto exact = write_reference(scene, generation, *compiler, work / "step_exact",
                                     "long double", diagnostics);
  const auto rounding =
      write_reference(scene, generation, *compiler, work / "step_rounding", real, diagnostics);
  if (!exact || !rounding) return std::nullopt;
  for (const CommandOutcome& outcome :
       run_commands({exact->command, rounding->command}, count_cores(options.jobs), work)) {
    if (outcome.started && outcome.exit_code == 0) continue;
    diagnostics.add({Severity::error, work, 0, "",
                     "the controller's reference does not compile" + first_lines(outcome.output),
                     "It needs a compiler of C++17 for this machine, such as g++."});
    return std::nullopt;
  }
  auto in_long_double = StepLibrary::load(exact->library, diagnostics);
  auto in_real = StepLibrary::load(rounding->library, diagnostics);
  if (!in_long_double || !in_real) return std::nullopt;
  return References{std::move(*in_long_double), std::move(*in_real)};
}

class StepJudge {
 public:
  StepJudge(const StepLibrary& emitted, const References& references, StepDynamics& dynamics,
            std::uint64_t seed, StepReport& report)
      : emitted_(emitted),
        references_(references),
        dynamics_(dynamics),
        defaults_(emitted.default_config()),
        rng_(seed),
        seed_(seed),
        report_(report) {}

  void run_motion(int index);
  void finish() {
    report_.median = quantile(errors_, 0.5);
    report_.percent_99 = quantile(errors_, 0.99);
  }

 private:
  [[nodiscard]] StepNumbers rounded(const StepNumbers& numbers, StepPart part);
  [[nodiscard]] StepResult refer(const StepMotion& motion, const StepNumbers& before,
                                 const StepNumbers& output, bool exact);
  void note_rules(const StepMotion& motion, const StepNumbers& before, const StepResult& made);
  void compare(const StepMotion& motion, const StepNumbers& before, const StepResult& made);
  void compare_numbers(const StepResult& made, const StepResult& exact,
                       const std::vector<StepResult>& near);
  [[nodiscard]] std::string place_of(const StepMember& member) const {
    return fmt::format("{} of step {} of motion {}", member.name, step_, motion_);
  }

  const StepLibrary& emitted_;
  const References& references_;
  StepDynamics& dynamics_;
  StepNumbers defaults_;
  Rng rng_;
  std::uint64_t seed_;
  StepReport& report_;
  std::vector<double> errors_;
  int motion_ = 0, step_ = 0;
};

/// Every number of the code's type moved by up to an ulp of itself.
StepNumbers StepJudge::rounded(const StepNumbers& numbers, StepPart part) {
  StepNumbers moved = numbers;
  for (const StepMember& member : emitted_.members(part)) {
    for (std::size_t i = 0; i < member.count && !member.is_whole; ++i) {
      moved[member.at + i] *= 1 + static_cast<long double>(rng_.within(dynamics_.unit()));
    }
  }
  return moved;
}

StepResult StepJudge::refer(const StepMotion& motion, const StepNumbers& before,
                            const StepNumbers& output, bool exact) {
  dynamics_.compute_in_fifty(exact);
  StepResult made{exact ? before : rounded(before, StepPart::state), output};
  const StepNumbers input = exact ? motion.input() : rounded(motion.input(), StepPart::input);
  const StepLibrary& reference = exact ? references_.exact : references_.rounding;
  reference.step(motion.config(), made.state, input, made.output);
  return made;
}

/// Members that are whole numbers and differ; null if none does.
const StepMember* find_difference(const StepLibrary& library, const StepResult& a,
                                  const StepResult& b) {
  for (const StepPart part : {StepPart::output, StepPart::state}) {
    const StepNumbers& in_a = part == StepPart::output ? a.output : a.state;
    const StepNumbers& in_b = part == StepPart::output ? b.output : b.state;
    for (const StepMember& member : library.members(part)) {
      for (std::size_t i = member.at; member.is_whole && i < member.at + member.count; ++i) {
        if (in_a[i] != in_b[i]) return &member;
      }
    }
  }
  return nullptr;
}

/// Largest difference of a member's numbers; infinite if one alone is not finite.
long double difference(const StepMember& member, const StepNumbers& a, const StepNumbers& b) {
  long double most = 0;
  for (std::size_t i = member.at; i < member.at + member.count; ++i) {
    if (!std::isfinite(a[i]) && !std::isfinite(b[i])) continue;
    const long double apart = std::abs(a[i] - b[i]);
    most =
        std::isfinite(apart) ? std::max(most, apart) : std::numeric_limits<long double>::infinity();
  }
  return most;
}

long double largest(const StepMember& member, const StepNumbers& numbers) {
  const StepNumbers zeros(numbers.size());
  return difference(member, numbers, zeros);
}

void StepJudge::compare_numbers(const StepResult& made, const StepResult& exact,
                                const std::vector<StepResult>& near) {
  const auto unit = static_cast<long double>(dynamics_.unit());
  double worst = 0;
  bool beyond = false;
  for (const StepPart part : {StepPart::output, StepPart::state}) {
    const auto of = [&](const StepResult& result) -> const StepNumbers& {
      return part == StepPart::output ? result.output : result.state;
    };
    for (const StepMember& member : emitted_.members(part)) {
      if (member.is_whole) continue;
      long double by_rounding = 0;
      for (const StepResult& each : near) {
        by_rounding = std::max(by_rounding, difference(member, of(each), of(exact)));
      }
      const long double size = std::max(largest(member, of(exact)), kOrdinary);
      const long double error = difference(member, of(made), of(exact));
      const long double scale = std::max(unit * size, by_rounding);
      const long double allowed = (kFloorUlp * unit * size) + (kOfRounding * by_rounding);
      worst = std::max(worst, static_cast<double>(error / scale));
      const auto of_bound = static_cast<double>(error / allowed);
      beyond = beyond || !(of_bound <= 1);
      if (of_bound > report_.of_bound) {
        report_.of_bound = of_bound;
        report_.worst_place = place_of(member);
      }
    }
  }
  errors_.push_back(worst);
  report_.worst = std::max(report_.worst, worst);
  report_.beyond_bound += beyond ? 1 : 0;
}

void StepJudge::compare(const StepMotion& motion, const StepNumbers& before,
                        const StepResult& made) {
  const StepNumbers output = emitted_.zeros(StepPart::output);
  const StepResult exact = refer(motion, before, output, true);
  std::vector<StepResult> near;
  for (int k = 0; k < kRoundings; ++k) near.push_back(refer(motion, before, output, false));
  ++report_.compared;
  const StepMember* const differs = find_difference(emitted_, made, exact);
  const bool tie = std::any_of(near.begin(), near.end(), [&](const StepResult& each) {
    return find_difference(emitted_, exact, each) != nullptr;
  });
  if (tie) {
    ++report_.ties;
  } else if (differs == nullptr) {
    compare_numbers(made, exact, near);
  } else if (report_.differ++ == 0) {
    report_.first_difference = place_of(*differs);
  }
}

void StepJudge::note_rules(const StepMotion& motion, const StepNumbers& before,
                           const StepResult& made) {
  const SeenStep seen{emitted_,    defaults_,          before,          motion.input(),
                      made.output, motion.has_reset(), dynamics_.unit()};
  const auto mode = static_cast<std::size_t>(seen.number(StepPart::output, "mode"));
  ++report_.modes[std::min(mode, report_.modes.size() - 1)];
  report_.faults |= seen.bits(StepPart::output, "faults");
  report_.refused += seen.number(StepPart::output, "refused") != 0 ? 1 : 0;
  const std::string broken = find_broken_rule(seen);
  if (broken.empty() || report_.broken++ > 0) return;
  report_.first_broken = fmt::format("{} in step {} of motion {}", broken, step_, motion_);
}

void StepJudge::run_motion(int index) {
  StepMotion motion(emitted_, dynamics_, index, seed_);
  motion_ = index;
  ++report_.motions;
  run_steps(emitted_, motion, [&](const MadeStep& made) {
    step_ = made.index;
    ++report_.steps;
    note_rules(motion, made.before, made.result);
    if (made.stands_out || step_ % kStride == 0) compare(motion, made.before, made.result);
  });
}

void add_measures(const Generation& generation, const Compilation& compilation,
                  StepReport& report) {
  int stack = 0;
  bool known = true;
  const CompiledFunction& step = compilation.functions.at("controller");
  report.code_bytes = step.code_bytes;
  report.compile_seconds = step.seconds;
  for (const Program* const program : generation.controller->programs()) {
    const CompiledFunction& called = compilation.functions.at(program->name);
    report.compile_seconds += called.seconds;
    if (report.code_bytes && called.code_bytes) *report.code_bytes += *called.code_bytes;
    known = known && called.stack_bytes.has_value();
    stack = std::max(stack, called.stack_bytes.value_or(0));
  }
  if (known && step.stack_bytes) report.stack_bytes = *step.stack_bytes + stack;
}

}  // namespace

CompileOptions with_controller(const Scene& scene, const Generation& generation,
                               CompileOptions options) {
  if (!generation.controller) return options;
  options.stems.emplace_back("controller");
  for (const Program* const program : generation.controller->programs()) {
    options.stems.push_back(program->name);
  }
  const std::string header = find_controller_header(scene.name, generation.files);
  options.more.push_back({kStepStem, print_step_entry(scene.name, header, "long double")});
  return options;
}

std::optional<StepReport> judge_step(const Robot& robot, const Scene& scene,
                                     const Generation& generation, const CheckOptions& options,
                                     const Compilation& compilation, const fs::path& work,
                                     Diagnostics& diagnostics) {
  const auto references = compile_references(scene, generation, options.compile, work, diagnostics);
  if (!references) return std::nullopt;
  const auto emitted = StepLibrary::load(compilation.library, diagnostics);
  if (!emitted) return std::nullopt;
  StepDynamics dynamics(robot, scene, generation, options.references.seed);
  references->exact.connect(&StepDynamics::compute, &dynamics);
  references->rounding.connect(&StepDynamics::compute, &dynamics);
  StepReport report;
  report.name = scene.name + "_step";
  StepJudge judge(*emitted, *references, dynamics, options.references.seed, report);
  for (int motion = 0; motion < StepMotion::kMishaps; ++motion) judge.run_motion(motion);
  judge.finish();
  add_measures(generation, compilation, report);
  return report;
}

}  // namespace treeline
