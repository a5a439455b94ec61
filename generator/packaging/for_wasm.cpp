#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <string_view>

#include "emission/c_family_syntax.hpp"
#include "emission/comment.hpp"
#include "emission/descriptions.hpp"
#include "emission/emitted_text.hpp"
#include "emission/print_files.hpp"
#include "generation/describe_scene.hpp"
#include "packaging/call_c.hpp"
#include "packaging/package_kinds.hpp"
#include "packaging/templates.hpp"

namespace treeline {
namespace {

namespace templates = package_templates;

/// Words of JavaScript that C does not keep, as names of arguments.
constexpr auto kScriptWords = std::to_array<std::string_view>(
    {"arguments",  "await",     "class",   "debugger", "delete",     "eval",    "export",
     "extends",    "false",     "finally", "function", "implements", "import",  "in",
     "instanceof", "interface", "let",     "new",      "null",       "package", "private",
     "protected",  "public",    "super",   "this",     "throw",      "true",    "try",
     "typeof",     "var",       "with",    "yield"});

/// A name of C that JavaScript takes too: `new` becomes `new_`.
std::string js_name(const std::string& name) {
  return std::find(kScriptWords.begin(), kScriptWords.end(), name) == kScriptWords.end()
             ? name
             : name + "_";
}

/// A name of npm has small letters.
std::string npm_name(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return name;
}

/// A comment that editors show as the documentation of what follows.
std::string print_script_doc(const std::string& text) {
  return "/**\n" + comment(" *", text) + " */\n";
}

/// A number without the suffix that C has.
std::string print_number(double value) {
  std::string text = make_c_family_syntax(true).literal(value);
  text.pop_back();
  return text;
}

/// Adds a constant to the module and its types.
void add_frozen(const std::string& name, const char* type, const std::string& entries,
                const char* meaning, PackageFacts& facts, PackageFacts& types) {
  facts["constants"] +=
      fmt::format("export const {} = Object.freeze([\n    {}]);\n", name, entries);
  types["constants"] +=
      print_script_doc(meaning) + fmt::format("export const {}: readonly {}[];\n", name, type);
}

/// Names, home and limits, and the effective masses of damped control where there is such.
void add_all_frozen(const EmissionContext& context, bool damped, PackageFacts& facts,
                    PackageFacts& types) {
  Syntax syntax = make_c_family_syntax(false);
  if (context.single_precision) syntax.literal = print_number;
  const JointArrays arrays = describe_joints(context, syntax, "Infinity");
  if (damped) {
    std::vector<std::string> heaviest;
    for (const double mass : context.effective_mass_limits) {
      heaviest.push_back(syntax.literal(mass));
    }
    add_frozen("heaviest", "number", fmt::format("{}", fmt::join(heaviest, ", ")), kHeaviest, facts,
               types);
  }
  for (const JointArray& each : kJointArrays) {
    add_frozen(each.name, each.is_text ? "string" : "number", arrays.holes.at(each.name),
               each.meaning, facts, types);
  }
  if (arrays.task_rows == 0) return;
  add_frozen("task_row_names", "string", arrays.task_row_names, kTaskRowNames, facts, types);
}

/// The functions as the module binds them, and as TypeScript sees them.
void bind_functions(const Scene& scene, const Generation& generation, std::size_t task_rows,
                    PackageFacts& facts, PackageFacts& types) {
  int most = 0;
  const std::string array = facts.at("real");
  for (const GeneratedFunction& generated : list_functions(generation)) {
    const Program& program = generated.program;
    const bool composed = is_composed(generated);
    int numbers = 0;
    std::string takes, gives, parameters, results;
    const auto add = [&](const std::string& name, int size, bool written) {
      (written ? gives : takes) += fmt::format("[\"{}\", {}], ", name, size);
      if (!written) parameters += fmt::format(", {}: Numbers", js_name(name));
      numbers += size;
    };
    for (const Argument& each : program.arguments) add(each.name, each.rows * each.cols, false);
    if (composed) add("heaviest", static_cast<int>(task_rows), false);
    for (std::size_t i = 0; i < program.results.size(); ++i) {
      const Argument& each = program.results[i].argument;
      const bool written = i < count_written(generated);
      if (written) add(each.name, each.rows * each.cols, true);
      results += fmt::format("; {}: {}", each.name, written ? array : "number");
    }
    const bool single = program.results.size() == 1;
    const std::string symbol = scene.name + "_" + program.name;
    facts["functions"] +=
        fmt::format("export const {} = bind(\"{}\",\n  [{}],\n  [{}]{});\n", program.name, symbol,
                    takes.substr(0, takes.size() - 2), gives.substr(0, gives.size() - 2),
                    composed ? ", \"" + program.results.back().argument.name + "\"" : "");
    types["functions"] +=
        fmt::format("{}export function {}({}): {};\n\n",
                    print_script_doc(find_comment(generation.files, symbol)), program.name,
                    parameters.substr(2), single ? array : "{ " + results.substr(2) + " }");
    facts["exports"] += " \\\n  -Wl,--export=" + symbol;
    most = std::max(most, numbers);
  }
  types["functions"].resize(types["functions"].size() - 2);
  facts["functions"].pop_back();
  facts["most_numbers"] = std::to_string(most);
}

/// A line of the script for each source, with the flags that it has for itself.
std::string print_compilation(const Scene& scene, const Generation& generation) {
  std::string text;
  for (const auto& [file, flags] : list_packaged_sources(scene, generation)) {
    text += fmt::format("{}compile {}{}", text.empty() ? "" : "\n", file,
                        flags.empty() ? "" : " " + flags);
  }
  return text;
}

}  // namespace

std::vector<PackageFolder> for_wasm(PackageFacts facts, const Robot& robot, const Scene& scene,
                                    const Generation& generation) {
  const EmissionContext context = describe_scene(robot, scene, generation.mechanism);
  facts["version"] += "+" + digest_of_files(generation.files).substr(0, 12);
  facts["package"] = npm_name(scene.name);
  facts["real"] = scene.real == Real::float32 ? "Float32Array" : "Float64Array";
  facts["compile"] = print_compilation(scene, generation);
  facts["constants"] = facts["functions"] = facts["exports"] = "";
  PackageFacts types = facts;
  types["conventions"] = comment("//", "\n" + generation.conventions);
  types["not_called"] = comment("//", describe_not_called(scene, "JavaScript"));
  add_all_frozen(context, generation.damped.has_value(), facts, types);
  bind_functions(scene, generation, static_cast<std::size_t>(context.task_rows), facts, types);
  const auto fill = [&](const std::string& name, std::string_view text) {
    return GeneratedFile{name, fill_holes(text, name.ends_with(".d.mts") ? types : facts)};
  };
  return {{"",
           {fill("build", templates::kWasmBuild), fill("package.json", templates::kWasmPackage),
            fill(scene.name + ".d.mts", templates::kWasmTypes),
            fill(scene.name + ".mjs", templates::kWasmModule)}}};
}

}  // namespace treeline
