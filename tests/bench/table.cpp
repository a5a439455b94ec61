#include <fmt/format.h>

#include "bench_robots.hpp"
#include "report.hpp"

namespace treeline::bench {
namespace {

constexpr const char* kLegend =
    "Nanoseconds a state, {} of the repetitions, all measured in turn in one process. warm: back "
    "to "
    "back, 64 states;\nratio: to the first line. dependent: q waits for the last call's output. "
    "cold: "
    "code and data out of the core's caches.\nflushed: out of all caches. instr: instructions a "
    "call, "
    "counted by callgrind. flops: + - * /, sine and cosine not counted.\nfl/cyc, B/cyc: flops and "
    "bytes of code run through in a cycle, warm. limit: the nearer of two, the share of the flops "
    "that\n"
    "this core can do (of a scalar stream, of packed ones where eight states make a call), and of "
    "the "
    "bytes of straight-line\ncode that it can fetch (from the first or the second level, as the "
    "function's size has it). compile: s and MiB.\n";

std::string number(double value, int width, int digits) {
  return value > 0 ? fmt::format("{:>{}.{}f}", value, width, digits)
                   : fmt::format("{:>{}}", "", width);
}

std::string print_time(const std::optional<double>& time) {
  return number(time.value_or(0), 9, time && *time < 100 ? 1 : 0);
}

/// Prints the share of the nearest limit: "85% flops" or "93% code".
std::string print_limit(const Row& row, const Limits& limits) {
  if (row.flops_a_cycle <= 0) return {};
  constexpr long kFirstLevel = 32 << 10;
  const bool batch = !row.subject->source_prefix.empty();
  const double flops = row.flops_a_cycle / (batch ? limits.packed_fma : limits.scalar_fma);
  const double code =
      row.code_a_cycle / (row.facts.code_bytes > kFirstLevel ? limits.far_code : limits.near_code);
  return fmt::format("{:.0f}% {}", 100 * std::max(flops, code), flops > code ? "flops" : "code");
}

std::string print_row(const Row& row, const std::optional<double>& first, const Machine& machine,
                      bool least) {
  const Facts& f = row.facts;
  const auto warm = row.time(Mode::warm, least);
  std::string text = fmt::format("  {:<36}", row.subject->implementation);
  text += print_time(warm) + number(warm && first ? *warm / *first : 0, 7, 2);
  text += ' ';
  for (const Mode mode : {Mode::dependent, Mode::cold, Mode::flushed}) {
    text += print_time(row.time(mode, least));
  }
  text += number(static_cast<double>(row.instructions), 7, 0);
  text += number(static_cast<double>(f.flops), 7, 0);
  text += number(row.flops_a_cycle, 7, 2) + number(row.code_a_cycle, 7, 1);
  text += fmt::format("{:>11}", print_limit(row, machine.limits));
  text += number(static_cast<double>(f.code_bytes), 8, 0);
  text += number(static_cast<double>(f.stack_bytes), 7, 0);
  text += number(f.compile_seconds, 8, 2) + number(f.compile_mib, 5, 0);
  return text.substr(0, text.find_last_not_of(' ') + 1) + '\n';
}

std::string print_heading(const Row& row) {
  return fmt::format(
      "{:<38}{:>9}{:>7}{:>10}{:>9}{:>9}{:>7}{:>7}{:>7}{:>7}{:>11}{:>8}{:>7}{:>8}{:>5}\n",
      name_of(row.function), "warm", "ratio", "dependent", "cold", "flushed", "instr", "flops",
      "fl/cyc", "B/cyc", "limit", "code", "stack", "compile", "MiB");
}

/// Prints the cost of making all functions of each implementation.
std::string print_compilation(const Measured& measured) {
  std::string text;
  for (const Subject& subject : measured.subjects) {
    if (subject.facts.empty()) continue;
    const Compilation all = read_compilation(subject);
    const std::string made = all.generation_seconds > 0
                                 ? fmt::format("generated in {:.2f} s, {:.0f} MiB;",
                                               all.generation_seconds, all.generation_mib)
                                 : std::string();
    text += fmt::format("  {:<36} {} functions: {} compiled in {:.1f} s, {:.0f} MiB; {} bytes\n",
                        subject.implementation, all.functions, made, all.seconds, all.peak_mib,
                        all.code_bytes);
  }
  return text;
}

}  // namespace

std::string print_table(const std::vector<Row>& rows, const Machine& machine, bool least) {
  std::string text = fmt::format("{}, {}\n{}\n{}", machine.processor, machine.caches,
                                 machine.limits.text(), kBuild);
  text += fmt::format(fmt::runtime(kLegend), least ? "least" : "median");
  std::optional<double> first;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Measured& measured = *rows[i].measured;
    const bool new_robot = i == 0 || &measured != rows[i - 1].measured;
    if (new_robot) {
      text += fmt::format("\n== {}: {} velocities, {} task rows\n", measured.robot.robot,
                          measured.robot.model.nv, measured.robot.rows());
    }
    if (new_robot || rows[i].function != rows[i - 1].function) {
      first = rows[i].time(Mode::warm, least);
      text += print_heading(rows[i]);
    }
    text += print_row(rows[i], first, machine, least);
    const bool last = i + 1 == rows.size() || rows[i + 1].measured != &measured;
    if (last) text += print_compilation(measured);
  }
  return text;
}

}  // namespace treeline::bench
