#include "report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "bench_robots.hpp"
#include "facts.hpp"
#include "measure.hpp"

namespace treeline::bench {
namespace {

const Times* find_times(const AllTimes& times, const Measured& measured, Function function,
                        const Subject& subject, Mode mode) {
  const auto found = times.find(measured.robot.robot + '/' + name_of(function) + '/' +
                                subject.implementation + '/' + name_of(mode));
  return found == times.end() ? nullptr : &found->second;
}

/// What the tables are printed from.
struct Tables {
  const AllTimes& times;
  const Machine& machine;
  bool least;
  std::string text = {};

  [[nodiscard]] std::optional<double> time_of(const Measured& measured, Function function,
                                              const Subject& subject, Mode mode) const {
    const Times* found = find_times(times, measured, function, subject, mode);
    if (found == nullptr) return std::nullopt;
    return least ? found->least() : found->median();
  }
  [[nodiscard]] bool measured_any(const Measured& measured, Function function) const;
  void print_function(const Measured& measured, Function function);
  void print_facts(const Measured& measured);
  void print_fact(const Measured& measured, Function function, const Subject& subject);
  void print_compilation(const Measured& measured);
};

bool Tables::measured_any(const Measured& measured, Function function) const {
  for (const Subject& subject : measured.subjects) {
    for (const Mode mode : kModes) {
      if (time_of(measured, function, subject, mode)) return true;
    }
  }
  return false;
}

/// " 1234 (2.1x)" or blanks.
std::string print_time(std::optional<double> time, std::optional<double> first) {
  if (!time) return fmt::format("{:>18}", "");
  const std::string ratio = first ? fmt::format("({:.2f}x)", *time / *first) : "";
  return fmt::format("{:>9.{}f} {:<8}", *time, *time < 100 ? 1 : 0, ratio);
}

void Tables::print_function(const Measured& measured, Function function) {
  text += fmt::format("{:<31}{:>9}{:>18}{:>18}{:>18}\n", name_of(function), "warm", "dependent",
                      "cold", "flushed");
  for (const Subject& subject : measured.subjects) {
    if (!subject.routines.contains(function)) continue;
    text += fmt::format("  {:<29}", subject.implementation);
    for (const Mode mode : kModes) {
      text += print_time(time_of(measured, function, subject, mode),
                         time_of(measured, function, measured.subjects[0], mode));
    }
    text += '\n';
  }
}

void Tables::print_fact(const Measured& measured, Function function, const Subject& subject) {
  const Facts f = read_facts(subject, name_of(function));
  const auto warm = time_of(measured, function, subject, Mode::warm);
  const double cycles = warm ? *warm * machine.gigahertz : 0;
  const auto a_cycle = [&](long count) {
    return cycles > 0 ? static_cast<double>(count) / cycles : 0.0;
  };
  text += fmt::format(
      "  {:<17}{:<28}{:>6}{:>5}{:>6}{:>10.2f}{:>12.2f}{:>9.1f}{:>7}{:>7}{:>8.2f} s{:>5.0f}\n",
      name_of(function), subject.implementation, f.flops, f.divisions, f.sin_cos,
      warm ? static_cast<double>(f.flops) / *warm : 0, a_cycle(f.flops), a_cycle(f.code_bytes),
      f.code_bytes, f.stack_bytes, f.compile_seconds, f.compile_mib);
}

void Tables::print_facts(const Measured& measured) {
  text += fmt::format("{:<47}{:>6}{:>5}{:>6}{:>10}{:>12}{:>9}{:>7}{:>7}{:>10}{:>5}\n",
                      "generated code", "flops", "div", "sin", "flops/ns", "flops/cycle", "B/cycle",
                      "code", "stack", "compile", "MiB");
  for (const Function function : kFunctions) {
    if (!measured_any(measured, function)) continue;
    for (const Subject& subject : measured.subjects) {
      if (!subject.facts.empty()) print_fact(measured, function, subject);
    }
  }
}

void Tables::print_compilation(const Measured& measured) {
  for (const Subject& subject : measured.subjects) {
    if (subject.facts.empty()) continue;
    const Compilation all = read_compilation(subject);
    text += fmt::format("  {:<45}all {} functions{:>42}{:>7}{:>7}{:>8.2f} s{:>5.0f}\n",
                        subject.implementation, all.functions, "", all.code_bytes, "", all.seconds,
                        all.peak_mib);
  }
}

nlohmann::ordered_json json_line(const Measured& measured, Function function,
                                 const Subject& subject, const AllTimes& times) {
  nlohmann::ordered_json line{{"robot", measured.robot.robot},
                              {"function", name_of(function)},
                              {"implementation", subject.implementation}};
  for (const Mode mode : kModes) {
    if (const Times* found = find_times(times, measured, function, subject, mode)) {
      line[name_of(mode) + "_ns"] = found->median();
      line[name_of(mode) + "_least_ns"] = found->least();
    }
  }
  if (!subject.facts.empty()) {
    const Facts f = read_facts(subject, name_of(function));
    line["method"] = f.method;
    line["flops"] = f.flops;
    line["code_bytes"] = f.code_bytes;
    line["stack_bytes"] = f.stack_bytes;
    line["compile_seconds"] = f.compile_seconds;
    line["compile_mib"] = f.compile_mib;
  }
  return line;
}

}  // namespace

double Times::median() const {
  auto sorted = repetitions;
  std::sort(sorted.begin(), sorted.end());
  const std::size_t n = sorted.size();
  return n == 0 ? 0 : (sorted[(n - 1) / 2] + sorted[n / 2]) / 2;
}

double Times::least() const {
  return *std::min_element(repetitions.begin(), repetitions.end());
}

void Collector::ReportRuns(const std::vector<Run>& runs) {
  for (const Run& run : runs) {
    if (run.error_occurred) {
      GetErrorStream() << run.benchmark_name() << ": " << run.error_message << '\n';
    } else if (run.run_type == Run::RT_Iteration) {
      times[run.run_name.function_name].repetitions.push_back(run.GetAdjustedRealTime());
    }
  }
}

std::string print_tables(const std::vector<Measured>& robots, const AllTimes& times,
                         const Machine& machine, bool least) {
  Tables tables{times, machine, least};
  tables.text = fmt::format(
      "{}, {}, {:.2f} GHz measured\n{}"
      "Nanoseconds a call, {} of the repetitions, all measured in turn in one process; in brackets "
      "the ratio to the\nfirst line. warm: back to back, 64 states. dependent: q waits for the "
      "last "
      "call's output. cold: code and data\nout of the core's caches. flushed: out of all caches. "
      "B/cycle: bytes of code run through, warm; a "
      "function larger\nthan L1i ends where the core fetches no faster.\n",
      machine.processor, machine.caches, machine.gigahertz, kBuild, least ? "least" : "median");
  for (const Measured& measured : robots) {
    const auto any = [&](Function function) { return tables.measured_any(measured, function); };
    if (std::none_of(std::begin(kFunctions), std::end(kFunctions), any)) continue;
    tables.text += fmt::format("\n== {}: {} velocities, {} task rows\n", measured.robot.robot,
                               measured.robot.model.nv, measured.robot.rows());
    for (const Function function : kFunctions) {
      if (any(function)) tables.print_function(measured, function);
    }
    tables.print_facts(measured);
    tables.print_compilation(measured);
  }
  return tables.text;
}

std::string print_json_lines(const std::vector<Measured>& robots, const AllTimes& times,
                             const Machine& machine) {
  std::string text;
  for (const Measured& measured : robots) {
    for (const Function function : kFunctions) {
      for (const Subject& subject : measured.subjects) {
        if (!subject.routines.contains(function)) continue;
        auto line = json_line(measured, function, subject, times);
        line["processor"] = machine.processor;
        line["gigahertz"] = machine.gigahertz;
        line["build"] = kBuild;
        text += line.dump() + '\n';
      }
    }
  }
  return text;
}

}  // namespace treeline::bench
