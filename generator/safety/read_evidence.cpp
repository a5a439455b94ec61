#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "emission/generated_file.hpp"
#include "safety/evidence.hpp"
#include "text/read_text_file.hpp"
#include "text/round_outward.hpp"

namespace treeline {
namespace {

using nlohmann::json;

std::string number(const json& value) {
  return value.is_number() ? fmt::format("{:.2f}", value.get<double>()) : "unknown";
}

/// A bound, with three digits.
std::string bound(const json& value) {
  return value.is_number() ? fmt::format("{:g}", round_up(value.get<double>(), 3)) : "unknown";
}

std::string whole(const json& value) {
  return value.is_number() ? fmt::format("{}", value.get<long long>()) : "unknown";
}

/// The controller's step, as `check` compares it.
void read_step(const json& step, Evidence& evidence) {
  evidence.rows.push_back({step.at("name"),
                           {number(step.at("worst")), "by rounding, see the facts",
                            fmt::format("modes or faults: {}", whole(step.at("differ"))),
                            whole(step.at("code_bytes")), whole(step.at("stack_bytes"))}});
  evidence.facts.push_back(fmt::format(
      "The step: {} steps in {} motions, {} compared with the same laws in long double and "
      "dynamics "
      "in 50 digits, the worst at {:.0f} % of what rounding explains; {} steps break a rule.",
      whole(step.at("steps")), whole(step.at("motions")), whole(step.at("compared")),
      100 * step.at("of_bound").get<double>(), whole(step.at("broken_rules"))));
}

void read_check(const json& report, Evidence& evidence) {
  evidence.kind = "`treeline check`: results compared with an interpreter in 50 digits";
  evidence.facts = {
      fmt::format("{} states, seed {}.", whole(report.at("states")), whole(report.at("seed"))),
      fmt::format("Compiled by `{}`.", report.at("compile").at("command").get<std::string>()),
      "Code and stack are those of this compiler on the machine that ran the check."};
  evidence.columns = {"worst error, ulp", "allowed, ulp", "states with other bits than the graph",
                      "code, bytes", "stack, bytes"};
  for (const json& f : report.at("functions")) {
    evidence.rows.push_back(
        {f.at("name"),
         {number(f.at("worst").at("error")), bound(f.at("worst").at("bound")),
          whole(f.at("bits_differ")), whole(f.at("code_bytes")), whole(f.at("stack_bytes"))}});
  }
  if (report.contains("step") && !report.at("step").is_null()) {
    read_step(report.at("step"), evidence);
  }
}

void read_board(const json& report, Evidence& evidence) {
  evidence.kind = fmt::format("`treeline check --target {}`: run on a board that QEMU imitates",
                              report.at("target").get<std::string>());
  evidence.facts = {
      fmt::format("{} states.", whole(report.at("states"))),
      fmt::format("Compiled by {}: `{}`.", report.at("compiler").get<std::string>(),
                  report.at("command").get<std::string>()),
      "Stack is what the compiler measured, summed over the deepest path of calls, without the "
      "compiler's own library; instructions are counted by QEMU."};
  evidence.columns = {"text, bytes",        "constants, bytes",
                      "stack, bytes",       "instructions, least",
                      "instructions, most", "states with other bits than the host"};
  for (const json& f : report.at("functions")) {
    evidence.rows.push_back({f.at("name"),
                             {whole(f.at("text_bytes")), whole(f.at("constant_bytes")),
                              whole(f.at("stack_bytes")), whole(f.at("least_instructions")),
                              whole(f.at("most_instructions")), whole(f.at("bits_differ"))}});
  }
}

void read_certificate(const json& report, Evidence& evidence) {
  const std::string coq = report.at("coq");
  evidence.kind = "`treeline certify`: rounding bounds proven by another program";
  evidence.facts = {fmt::format("Proven by {}{}{}.", report.at("gappa").get<std::string>(),
                                coq.empty() ? "" : ", each step checked by ", coq),
                    "The proofs are of code without contraction (`-ffp-contract=off`)."};
  evidence.columns = {"result", "proven bound", "stated bound", "steps"};
  for (const json& f : report.at("functions")) {
    if (f.contains("skipped")) {
      evidence.rows.push_back({f.at("name"), {"none: " + f.at("skipped").get<std::string>()}});
    }
    for (const json& r : f.value("results", json::array())) {
      evidence.rows.push_back(
          {f.at("name"),
           {r.at("name"), bound(r.at("proven")), bound(r.at("stated")), whole(f.at("steps"))}});
    }
    if (f.contains("failed")) {
      evidence.rows.push_back({f.at("name"), {"FAILED: " + f.at("failed").get<std::string>()}});
    }
  }
}

/// Other code that the report is about; empty if it is about these files.
std::string find_other_subject(const json& report, const EvidenceSubject& subject) {
  if (!report.contains("digest") || !report.contains("generator")) {
    return "code that it does not name, for it has no digest";
  }
  const std::string version = report.at("generator");
  if (version != generator_version()) return "code of Treeline " + version;
  const std::string made_for = report.at("digest");
  if (made_for == subject.digest) return {};
  return fmt::format("other code, of digest {}: the inputs or the options differ", made_for);
}

/// Fills in what the report says. Throws json::exception if it is none of these reports.
void read(const json& report, Evidence& evidence) {
  evidence.passed = report.at("passed");
  if (report.contains("gappa")) {
    read_certificate(report, evidence);
  } else if (report.contains("target")) {
    read_board(report, evidence);
  } else {
    read_check(report, evidence);
  }
}

}  // namespace

std::optional<Evidence> read_evidence(const std::string& path, const EvidenceSubject& subject,
                                      Diagnostics& diagnostics) {
  const auto text = read_text_file(path, diagnostics);
  if (!text) return std::nullopt;
  Evidence evidence{
      std::filesystem::path(path).filename().string(), digest(*text), {}, {}, {}, {}, {}, {}};
  std::string fault = "is no report of check or certify";
  try {
    const json report = json::parse(*text);
    read(report, evidence);
    const std::string of = report.at("name");
    if (of == subject.name) {
      evidence.stale = find_other_subject(report, subject);
      return evidence;
    }
    fault = fmt::format("is a report about {}, not {}", of, subject.name);
  } catch (const json::exception&) {
  }
  diagnostics.add({Severity::error, path, 0, "", fault,
                   "Print one with `treeline check ... --json` or `treeline certify ... --json`."});
  return std::nullopt;
}

}  // namespace treeline
