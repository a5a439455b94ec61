#include "safety/describe_safety.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bounds/bound_rounding.hpp"
#include "description/follow_target.hpp"
#include "emission/backend.hpp"
#include "emission/controller_unit.hpp"
#include "emission/costs.hpp"
#include "emission/descriptions.hpp"
#include "emission/generated_file.hpp"
#include "emission/print_files.hpp"

namespace treeline {
namespace {

/// Statements about the functions alone, where there is a controller too.
constexpr const char* kBehaviour =
    "- {0}traight-line code: no loop, no branch on data, no recursion, no heap, no exception, no\n"
    "  global or static variable, no call but of sine and cosine, which are part of the code.\n"
    "- The same inputs give the same bits{1}. On targets with instructions for `Real` a call of a\n"
    "  straight-line function takes the same instructions whatever its inputs.\n"
    "- {2} reentrant and keep no state.\n";

std::string print_behaviour(const Scene& scene, const Generation& generation) {
  if (!generation.controller) {
    return fmt::format(fmt::runtime(kBehaviour), "S", "", "Functions are");
  }
  const std::string own =
      generation.functions.empty()
          ? "The functions `controller_*`, which the step calls,"
          : fmt::format("The functions of `{}{}`", scene.name, backend_of(scene.language).header);
  return fmt::format(fmt::runtime(kBehaviour), own + " are s",
                     ", those of the step from the same state", "These functions are");
}

constexpr const char* kLooping =
    "- Functions by loops over a table of links are not straight-line: they have loops of "
    "constant\n"
    "  length, branches on constants of that table alone, and calls of functions of the headers\n"
    "  `link_*.hpp`. What is said of time and bits holds for them, too.\n";

constexpr const char* kEnding =
    "- Functions that end with the call of a routine are not straight-line: the routine, in a "
    "header\n"
    "  beside them, has loops of constant length and branches on the function's constants alone. "
    "What\n  is said of time and bits holds for them, too.\n";

constexpr const char* kGround =
    "- `{}_ground_step` is for simulation, and is not straight-line: it branches on its inputs, "
    "has\n"
    "  loops of bounded length, takes the longer the more points touch the ground, and keeps the "
    "last\n  impulses in the caller's object. `treeline check` compiles it and compares nothing.\n";

constexpr const char* kDamped =
    "- `damped_control_torque` is not straight-line: it calls the functions above and has loops, "
    "of\n  bounded length. The header tells its typical errors, no bound.\n";

constexpr const char* kLimited =
    "- `limited_control_torque` is not straight-line: it calls the functions above and solves a "
    "quadratic\n  program, whose most iterations and operations its header tells. Its time depends "
    "on its inputs,\n  and it keeps the active limits of the last cycle in the caller's object.\n";

constexpr const char* kNotCovered =
    "- Whether URDF and scene describe the real robot: masses, limits, frames, gravity.\n"
    "- Friction, flexible links, contact and closed chains beyond what the scene names.\n"
    "- Reading of sensors, and the wiring of motors and brakes.\n"
    "- {}\n"
    "- Compiler, linker, processor, interrupts, caches, and time on the target.\n"
    "- Qualification of Treeline as a tool. It is not qualified. Its output has to be verified, "
    "for\n  which the evidence above is meant.\n";

std::string print_not_covered(bool stepping) {
  return fmt::format(
      fmt::runtime(kNotCovered),
      stepping
          ? "Range checks of inputs, limits and reactions to faults in the functions: only the\n"
            "  controller's step has those that its section names. The caller has to supply others."
          : "Range checks of inputs, limits on commands, reactions to faults: the code has none "
            "of\n  them. The caller has to supply them.");
}

std::string print_files(const Generation& generation, const Provenance& provenance) {
  std::string text = "| file | role | SHA-256 |\n|---|---|---|\n";
  const auto row = [&text](const std::string& name, const char* role, const std::string& bytes) {
    text += fmt::format("| `{}` | {} | `{}` |\n", name, role, digest(bytes));
  };
  for (const Provenance::File& file : list_inputs(provenance)) {
    if (!file.name.empty()) row(file.name, "input", file.text);
  }
  for (const GeneratedFile& file : generation.files) row(file.name, "output", file.text);
  return text;
}

std::string print_assumptions(const Scene& scene, const Generation& generation) {
  const bool single = scene.real == Real::float32;
  const SineWords sines = describe_sines(single, scene.profile == Profile::misra);
  const std::string domain = describe_domain(generation);
  return fmt::format(
      "1. Inputs{} are finite. A NaN or an infinity makes NaN or infinite what depends on it; "
      "nothing "
      "is trapped or replaced. Results have to be tested by the caller.\n"
      "2. {} Results stay finite while squares and sums fit `Real`.\n"
      "3. Sines and cosines are within 0.8 ulp up to {} rad, and further on those of an angle "
      "within two units in its last place; an angle beyond {} rad counts as {}.\n"
      "4. Rounding is to nearest. Subnormal numbers are not flushed to zero.\n"
      "5. `Real` is {} of IEC 60559, every operation rounds to it. The header stops the compiler "
      "where it tells otherwise; clang does not tell of `-funsafe-math-optimizations`, "
      "`-fassociative-math`, `-freciprocal-math`.\n"
      "6. Products and sums may be contracted within the stated bounds. For the same bits "
      "everywhere, and for proofs of `certify`: `-ffp-contract=off`, with g++ also "
      "`-fno-tree-slp-vectorize`.\n"
      "7. Arguments of one call do not overlap and have at least the stated sizes.\n",
      generation.controller ? " of functions (those of the step may be anything)" : "",
      domain.empty()
          ? "No bound of errors is stated."
          : fmt::format("Bounds of errors hold for {}. Beyond, no bound is stated.", domain),
      sines.accurate, sines.largest, sines.beyond, single ? "binary32" : "binary64");
}

const char* word_of(const RoundingBound& bound) {
  switch (bound.kind) {
    case RoundingBound::Kind::proven:
      return "proven";
    case RoundingBound::Kind::searched:
      return "searched, not proven";
    case RoundingBound::Kind::typical:
      return "typical, no bound";
    case RoundingBound::Kind::none:
      break;
  }
  return "none";
}

std::string print_functions(const Scene& scene, const Generation& generation) {
  const bool single = scene.real == Real::float32;
  std::string text =
      "| function | operations | stack, an estimate | rounding error | kind of bound |\n"
      "|---|---|---|---|---|\n";
  for (const GeneratedFunction& function : generation.functions) {
    const Program& program = function.program;
    text +=
        fmt::format("| `{}` | {} | {} bytes | {} | {} |\n", program.name, describe_cost(program),
                    count_stack_values(program, scene.profile == Profile::misra) *
                        static_cast<std::size_t>(bytes_of(scene.real)),
                    describe(function.rounding, program, single ? 0x1p-24 : 0x1p-53),
                    word_of(function.rounding));
  }
  if (generation.controller) {
    const auto bytes = static_cast<std::size_t>(bytes_of(scene.real));
    for (const Program* const program : generation.controller->programs()) {
      text += fmt::format("| `{}` | {} | {} bytes | none is stated | none |\n", program->name,
                          describe_cost(*program),
                          count_stack_values(*program, scene.profile == Profile::misra) * bytes);
    }
  }
  for (const GeneratedFunction& function : generation.functions) {
    if (function.program.singular.empty()) continue;
    text += fmt::format("\nAt singularities `{}` is {}\n", function.program.name,
                        function.program.singular);
  }
  return text;
}

std::string print_evidence(const std::vector<Evidence>& all) {
  if (all.empty()) {
    return "None was named. `--evidence` takes reports of `treeline check`, `treeline check "
           "--target` and `treeline certify`, printed with `--json`.\n";
  }
  std::string text;
  for (const Evidence& evidence : all) {
    const char* const verdict = !evidence.stale.empty() ? "stale"
                                : evidence.passed       ? "passed"
                                                        : "FAILED";
    text += fmt::format("### {}\n\n{}: **{}**. SHA-256 `{}`.\n\n", evidence.file, evidence.kind,
                        verdict, evidence.digest);
    if (!evidence.stale.empty()) {
      text +=
          fmt::format("It was made for {}. It says nothing of these files.\n\n", evidence.stale);
      continue;
    }
    for (const std::string& fact : evidence.facts) text += "- " + fact + "\n";
    text += fmt::format("\n| function | {} |\n|---", fmt::join(evidence.columns, " | "));
    for (std::size_t i = 0; i < evidence.columns.size(); ++i) text += "|---";
    text += "|\n";
    for (const EvidenceRow& row : evidence.rows) {
      text += fmt::format("| `{}` | {}", row.function, fmt::join(row.cells, " | "));
      for (std::size_t i = row.cells.size(); i < evidence.columns.size(); ++i) text += " |";
      text += " |\n";
    }
    text += "\n";
  }
  return text;
}

}  // namespace

std::string describe_safety(const Scene& scene, const Generation& generation,
                            const Provenance& provenance, const std::vector<Evidence>& evidence) {
  const std::string options = describe_options(provenance, generation);
  std::string text = fmt::format(
      "# {}: notes for a safety review\n\nGenerated by Treeline {}. Digest of the files, as in "
      "`manifest.json`: `{}`. Options that override the "
      "scene: {}. Language: {}. Number type: {}. Target: {}.\n",
      scene.name, generator_version(), digest_of_files(generation.files),
      options.empty() ? "none" : "`" + options.substr(1) + "`", backend_of(scene.language).standard,
      scene.real == Real::float32 ? "float" : "double", scene.target);
  const auto section = [&text](const char* title, const std::string& body) {
    text += fmt::format("\n## {}\n\n{}", title, body);
  };
  section("Inputs and outputs", print_files(generation, provenance));
  const bool loops = std::any_of(
      generation.files.begin(), generation.files.end(),
      [](const GeneratedFile& file) { return file.name.starts_with("link_functions."); });
  const bool ends = std::any_of(
      generation.functions.begin(), generation.functions.end(),
      [](const GeneratedFunction& function) { return function.program.ending != nullptr; });
  const bool stepping = generation.controller != nullptr;
  section("Behaviour of the code",
          print_behaviour(scene, generation) + (loops ? kLooping : "") +
              (stepping ? describe_step_behaviour(scene.name) : "") + (ends ? kEnding : "") +
              (scene.ground_step ? fmt::format(kGround, scene.name) : "") +
              (generation.damped ? kDamped : "") + (scene.has_limits() ? kLimited : ""));
  section("Assumptions that the surrounding program has to meet",
          print_assumptions(scene, generation));
  section("Functions",
          print_functions(scene, generation) +
              "\nOperations and errors are derived from the expression graph. The stack is an "
              "estimate, the values that live at once; compilers take more. Measured figures are "
              "below, where a report has them. \"Searched\" bounds are four times the worst that a "
              "search met.\n");
  if (stepping) section("The controller's step", describe_step(scene, generation));
  section("Coding rules", describe_deviations(scene));
  section("Evidence", print_evidence(evidence));
  section("Not covered", print_not_covered(stepping));
  return text;
}

}  // namespace treeline
