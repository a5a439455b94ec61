#include "emission/print_manifest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "description/scene_words.hpp"
#include "emission/controller_unit.hpp"
#include "emission/costs.hpp"
#include "emission/descriptions.hpp"
#include "emission/emitted_text.hpp"
#include "emission/generated_file.hpp"
#include "emission/print_files.hpp"
#include "emission/print_target.hpp"
#include "emission/templates.hpp"
#include "passes/count_operations.hpp"
#include "program/ending.hpp"
#include "text/printable.hpp"

namespace treeline {
namespace {

/// The elements of a JSON array, one a line.
template <class Range, class Print>
std::string print_list(const Range& range, Print print) {
  std::string list;
  for (const auto& element : range) {
    list += (list.empty() ? "" : ",\n") + print(element);
  }
  return list;
}

std::string print_digest(const std::string& file, const std::string& text) {
  return fmt::format(R"({{"file": {}, "sha256": "{}"}})", quote_json(file), digest(text));
}

std::string print_input(const EmissionContext::Input& input) {
  return print_digest(input.file, input.text);
}

/// The inputs that are files; a scene may be none.
std::vector<EmissionContext::Input> files_of(const EmissionContext& context) {
  std::vector<EmissionContext::Input> files;
  for (const EmissionContext::Input& input : context.inputs) {
    if (!input.file.empty()) files.push_back(input);
  }
  return files;
}

/// How many operations share how many instructions, and what that costs.
std::string print_lanes(const Program& whole) {
  const Program& program = printed_lines(whole);
  if (program.packs.empty()) {
    return "";
  }
  std::ptrdiff_t shared = 0;
  for (const LanePack& pack : program.packs) {
    shared += std::count_if(pack.begin(), pack.end(), [](std::uint32_t node) { return node != 0; });
  }
  return fmt::format(R"(, "lanes": {{"packs": {}, "operations": {}, "moves": {}}})",
                     program.packs.size(), shared, program.lane_moves);
}

/// Operations that arguments about the robot add: `, "input_flops": {"gravity": 12}`.
std::string print_input_costs(const EmissionContext& context, const Program& program) {
  const auto costs = context.input_costs.find(program.name);
  if (costs == context.input_costs.end()) return {};
  std::string list;
  for (const EmissionContext::InputCost& cost : costs->second) {
    list +=
        fmt::format("{}{}: {}", list.empty() ? "" : ", ", quote_json(cost.argument), cost.flops);
  }
  return fmt::format(R"(, "input_flops": {{{}}})", list);
}

std::string print_function(const EmissionContext& context, const Program& program) {
  const auto rounding = context.rounding.find(program.name);
  const std::string bound = rounding == context.rounding.end()
                                ? std::string()
                                : fmt::format(R"(, "rounding": {})", quote_json(rounding->second));
  const std::string singular =
      program.singular.empty() ? std::string()
                               : fmt::format(R"(, "singular": {})", quote_json(program.singular));
  const OperationCount count = count_operations(program);
  return fmt::format(
      R"({{"name": {}, "route": {}, "method": {}, "flops": {}, "add": {}, "mul": {}, "div": {}, )"
      R"("sin_cos": {}, "live_values": {}{}{}{}{}}})",
      quote_json(program.name), quote_json(key_of(program.route)),
      quote_json(describe(program.route)), count.flops(), count.add, count.mul, count.div,
      count.sin_cos, count_stack_values(program, false), print_input_costs(context, program),
      print_lanes(program), singular, bound);
}

/// Prints the manifest's entry of NAME_damped.hpp, whose function is composed of others.
std::string print_damped_function(const EmissionContext& context,
                                  std::span<const Program> programs) {
  const DampedCost cost = cost_of_damped(context, programs);
  const auto rounding = context.rounding.find("damped_control_torque");
  const std::string bound = rounding == context.rounding.end()
                                ? std::string()
                                : fmt::format(R"(, "rounding": {})", quote_json(rounding->second));
  return fmt::format(
      ",\n"
      R"({{"name": "damped_control_torque", "flops": {}, "add": {}, "mul": {}, )"
      R"("div": {}, "square_roots": {}, "sin_cos": {}, "live_values": {}{}}})",
      cost.count.flops(), cost.count.add, cost.count.mul, cost.count.div, cost.square_roots,
      cost.count.sin_cos, cost.values, bound);
}

/// Prints the manifest's entry of NAME_limited.hpp, which calls `supported_control_torque`.
std::string print_limited_function(const EmissionContext& context,
                                   std::span<const Program> programs) {
  const LimitCost cost = cost_of_limits(*context.limits, context.velocities);
  const auto supported = std::find_if(programs.begin(), programs.end(), [](const Program& program) {
    return program.name == "supported_control_torque";
  });
  return fmt::format(
      ",\n"
      R"({{"name": "limited_control_torque", "flops": {}, "unknowns": {}, "rows": {}, )"
      R"("most_iterations": {}, "flops_of_iteration": {}}})",
      count_operations(*supported).flops(), cost.unknowns, cost.rows, cost.iterations,
      cost.flops_of_iteration);
}

std::string print_method(const EmissionContext::Method& method) {
  const std::string lanes = method.lanes > 0 ? fmt::format(R"(, "lanes": {})", method.lanes) : "";
  return fmt::format(R"({{"route": {}, "method": {}, "flops": {}, "cost": {:.0f}{}}})",
                     quote_json(method.route), quote_json(method.name), method.flops, method.cost,
                     lanes);
}

std::string print_choice(const EmissionContext::ChoiceRow& choice) {
  std::string rejected;
  for (const EmissionContext::Method& method : choice.rejected) {
    rejected += (rejected.empty() ? "" : ", ") + print_method(method);
  }
  return fmt::format(R"({{"function": {}, "chosen": {}, "rejected": [{}]}})",
                     quote_json(choice.function), print_method(choice.chosen), rejected);
}

/// A source with its own flags, those for GCC alone apart.
std::string print_source_entry(const Source& source) {
  const OwnFlags& own = source.flags;
  std::string text = fmt::format(R"({{"file": {})", quote_json(source.file));
  if (own.is_small) text += fmt::format(R"(, "flags": "{}")", kSmallCodeFlag);
  if (own.is_huge) text += fmt::format(R"(, "flags": "{}")", kHugeFlag);
  if (own.is_long) text += fmt::format(R"(, "gcc_flags": "{}")", kNoExtraPasses);
  if (source.is_joined) text += R"(, "joined": true)";
  return text + "}";
}

/// Prints the manifest's entry of NAME_step: sources to compile, and the estimate of its stack.
std::string print_controller_entry(const EmissionContext& context) {
  if (!context.controller) return {};
  std::string sources;
  for (const std::string& source : list_controller_sources(context.language, *context.controller)) {
    sources += (sources.empty() ? "" : ", ") + quote_json(source);
  }
  return fmt::format(
      "  \"controller\": {{\"step\": {}, \"stack_bytes_estimate\": {}, \"sources\": [{}]}},\n",
      quote_json(context.name + "_step"),
      count_step_stack(*context.controller, context.misra, number_bytes(context)), sources);
}

/// The language that the scene names; C++ is none to name.
std::string print_language(const EmissionContext& context) {
  if (context.language == Language::cpp) return {};
  return fmt::format("  \"language\": {},\n", quote_json(word_of(context.language)));
}

}  // namespace

std::string quote_json(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      quoted += std::string("\\") + c;
    } else if (static_cast<unsigned char>(c) < 0x20) {
      quoted += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    } else {
      quoted += c;
    }
  }
  return printable_json(quoted) + "\"";
}

std::string print_manifest(const EmissionContext& context, std::span<const Program> programs,
                           const std::vector<GeneratedFile>& files,
                           const std::vector<Source>& sources) {
  std::vector<GeneratedFile> sorted = files;
  std::sort(sorted.begin(), sorted.end(),
            [](const GeneratedFile& a, const GeneratedFile& b) { return a.name < b.name; });
  std::vector<Source> own_sources = sources;  // but for the one that is made of others
  std::erase_if(own_sources, [](const Source& each) { return each.of == Source::Of::joined; });
  std::vector<std::string> names = {kManifestName};
  for (const GeneratedFile& file : sorted) names.push_back(file.name);
  std::sort(names.begin(), names.end());
  return fill_template(
      templates::kManifest,
      {{"generator", quote_json(fmt::format("treeline {}", generator_version()))},
       {"name", quote_json(context.name)},
       {"robot", quote_json(context.robot)},
       {"command", quote_json(context.command)},
       {"language", print_language(context)},
       {"profile", context.misra ? "  \"profile\": \"misra\",\n" : ""},
       {"real", context.single_precision ? "\"float\"" : "\"double\""},
       {"target", print_target_lines(context)},
       {"coordinates", std::to_string(context.coordinates)},
       {"velocities", std::to_string(context.velocities)},
       {"task_rows", std::to_string(context.task_rows)},
       {"scene", files_of(context).size() < context.inputs.size() ? "  \"scene\": null,\n" : ""},
       {"inputs", print_list(files_of(context), print_input)},
       {"domain", quote_json(context.domain)},
       {"functions",
        print_list(programs, [&context](const Program& p) { return print_function(context, p); }) +
            (context.effective_mass_limits.empty() ? ""
                                                   : print_damped_function(context, programs)) +
            (context.limits ? print_limited_function(context, programs) : "")},
       {"controller", print_controller_entry(context)},
       {"measured", context.measured.empty()
                        ? ""
                        : fmt::format("  \"measured\": {},\n", quote_json(context.measured))},
       {"choices", print_list(context.choices, print_choice)},
       {"sources", print_list(own_sources, print_source_entry)},
       {"digest", quote_json(digest_of_files(sorted))},
       {"outputs",
        print_list(sorted, [](const GeneratedFile& f) { return print_digest(f.name, f.text); })},
       {"files", print_list(names, [](const std::string& f) { return quote_json(f); })}});
}

std::vector<std::string> read_manifest_files(std::string_view manifest) {
  const auto json = nlohmann::json::parse(manifest, nullptr, false);
  std::vector<std::string> files;
  if (!json.is_object() || !json.contains("files")) return files;
  for (const auto& file : json["files"]) {
    if (file.is_string()) files.push_back(file.get<std::string>());
  }
  return files;
}

}  // namespace treeline
