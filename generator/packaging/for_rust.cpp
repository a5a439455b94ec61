#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
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
#include "text/identifier.hpp"

namespace treeline {
namespace {

namespace templates = package_templates;

/// Words of Rust, those it keeps for later too.
constexpr auto kWords = std::to_array<std::string_view>(
    {"Self",     "abstract", "as",      "async", "await",    "become", "box",    "break", "const",
     "continue", "crate",    "do",      "dyn",   "else",     "enum",   "extern", "false", "final",
     "fn",       "for",      "gen",     "if",    "impl",     "in",     "let",    "loop",  "macro",
     "match",    "mod",      "move",    "mut",   "override", "priv",   "pub",    "ref",   "return",
     "self",     "static",   "struct",  "super", "trait",    "true",   "try",    "type",  "typeof",
     "union",    "unsafe",   "unsized", "use",   "virtual",  "where",  "while",  "yield"});
/// Crates that every program has, and the one that compiles C.
constexpr auto kCrates =
    std::to_array<std::string_view>({"alloc", "cc", "core", "proc_macro", "std", "test"});

template <class Names>
bool holds(const Names& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// A name of C that Rust takes too: `type` becomes `type_`.
std::string rust_name(const std::string& name) {
  return holds(kWords, name) ? name + "_" : name;
}

/// Robots named like a word of Rust or a crate that is always there: `core_robot`.
std::string crate_name(const std::string& name) {
  return holds(kWords, name) || holds(kCrates, name) ? name + "_robot" : name;
}

/// Text as it stands, in a comment that rustdoc reads as Markdown.
std::string print_doc(const std::string& mark, std::string text) {
  std::replace(text.begin(), text.end(), '`', '\'');
  if (!text.ends_with('\n')) text += '\n';
  return comment(mark, "```text\n" + text + "```\n");
}

/// A number without the suffix that C has.
std::string print_float(double value) {
  std::string text = make_c_family_syntax(true).literal(value);
  text.pop_back();
  return text;
}

/// An array of constants; `size` is that of its entries.
std::string print_constant(const std::string& name, const std::string& type, std::size_t size,
                           const std::string& entries, const char* meaning) {
  return fmt::format("/// {}\npub const {}: [{}; {}] = [\n    {}];\n", meaning, in_capitals(name),
                     type, size, entries);
}

/// Names, home and limits, and the effective masses of damped control where there is such.
std::string print_constants(const EmissionContext& context, bool damped, const std::string& real) {
  Syntax syntax = make_c_family_syntax(false);
  if (context.single_precision) syntax.literal = print_float;
  const JointArrays arrays = describe_joints(context, syntax, real + "::MAX");
  std::string text;
  if (damped) {
    std::vector<std::string> heaviest;
    for (const double mass : context.effective_mass_limits) {
      heaviest.push_back(syntax.literal(mass));
    }
    text += print_constant("heaviest", real, heaviest.size(),
                           fmt::format("{}", fmt::join(heaviest, ", ")), kHeaviest);
  }
  for (const JointArray& each : kJointArrays) {
    const std::size_t size =
        each.of_velocities ? context.velocity_rows.size() : context.coordinate_rows.size();
    text += print_constant(each.name, each.is_text ? "&str" : real, size,
                           arrays.holes.at(each.name), each.meaning);
  }
  if (arrays.task_rows == 0) return text;
  return text + print_constant("task_row_names", "&str", arrays.task_rows, arrays.task_row_names,
                               kTaskRowNames);
}

/// The functions as Rust calls them, and as C has them.
void add_functions(const Scene& scene, const Generation& generation, PackageFacts& facts) {
  const std::string& real = facts.at("real");
  const int nq = std::stoi(facts.at("nq")), nv = std::stoi(facts.at("nv"));
  const auto size_of = [&](const Argument& argument) {
    const int size = argument.rows * argument.cols;
    if (argument.name == "q" && size == nq) return std::string("NQ");
    const bool of_joints = argument.meaning.starts_with("joint ") && argument.cols == 1;
    return of_joints && size == nv ? "NV" : std::to_string(size);
  };
  for (const GeneratedFunction& generated : list_functions(generation)) {
    const Program& program = generated.program;
    std::string taken, given, declared;
    const auto add = [&](const Argument& argument, bool written) {
      const std::string name = rust_name(argument.name);
      taken +=
          fmt::format(", {}: &{}[{}; {}]", name, written ? "mut " : "", real, size_of(argument));
      given += fmt::format(", {}.as{}_ptr()", name, written ? "_mut" : "");
      declared += fmt::format(", {}: *{} {}", name, written ? "mut" : "const", real);
    };
    for (const Argument& argument : program.arguments) add(argument, false);
    for (std::size_t i = 0; i < count_written(generated); ++i) {
      add(program.results[i].argument, true);
    }
    const bool composed = is_composed(generated);
    if (composed) add({"heaviest", std::stoi(facts.at("nx")), 1, ""}, false);
    const std::string returned = composed ? " -> " + real : "";
    const std::string symbol = scene.name + "_" + program.name;
    facts["functions"] += fmt::format(
        "\n/// `{0}`, of which the header in C says:\n{1}pub fn {0}({2}){3} {{\n"
        "    // SAFETY: the arrays have the sizes that C states, and those written overlap none.\n"
        "    unsafe {{ native::{4}({5}) }}\n}}\n",
        rust_name(program.name),
        print_doc("///", find_comment(generation.files, symbol) +
                             (composed ? "The array above is HEAVIEST.\n" : "")),
        taken.substr(2), returned, symbol, given.substr(2));
    facts["native"] +=
        fmt::format("        pub fn {}({}){};\n", symbol, declared.substr(2), returned);
  }
}

/// Sources with the flags that each has for itself.
std::string quote_rust_sources(const Scene& scene, const Generation& generation) {
  std::string text;
  for (const auto& [file, flags] : list_packaged_sources(scene, generation)) {
    text +=
        fmt::format("    (\"src/{}\", &[{}]),\n", file, flags.empty() ? "" : "\"" + flags + "\"");
  }
  return text;
}

/// A call of the first function, at home and at rest.
std::string print_example(const PackageFacts& facts, const Program& program) {
  std::string before, list;
  const std::string& crate = facts.at("crate");
  for (const Argument& argument : program.arguments) {
    list += argument.name == "q" ? fmt::format("&{}::HOME, ", crate)
                                 : fmt::format("&[0.0; {}], ", argument.rows * argument.cols);
  }
  for (const Result& result : program.results) {
    const Argument& argument = result.argument;
    before += fmt::format("//! let mut {} = [0.0; {}];\n", rust_name(argument.name),
                          argument.rows * argument.cols);
    list += fmt::format("&mut {}, ", rust_name(argument.name));
  }
  list.resize(list.size() - 2);
  return fmt::format("{}//! {}::{}({});", before, crate, rust_name(program.name), list);
}

}  // namespace

std::vector<PackageFolder> for_rust(PackageFacts facts, const Robot& robot, const Scene& scene,
                                    const Generation& generation) {
  const EmissionContext context = describe_scene(robot, scene, generation.mechanism);
  facts["version"] += "+" + digest_of_files(generation.files).substr(0, 12);
  facts["crate"] = crate_name(scene.name);
  facts["real"] = scene.real == Real::float32 ? "f32" : "f64";
  facts["quoted_flags"] = quote_flags(facts, scene);
  facts["sources"] = quote_rust_sources(scene, generation);
  facts["constants"] = print_constants(context, generation.damped.has_value(), facts["real"]);
  facts["nq"] = std::to_string(context.coordinate_rows.size());
  facts["nv"] = std::to_string(context.velocity_rows.size());
  facts["nx"] = std::to_string(context.task_rows);
  facts["conventions"] = print_doc("//!", harmless(generation.conventions));
  facts["example"] = print_example(facts, generation.functions.front().program);
  facts["not_called"] = comment("//!", describe_not_called(scene, "Rust"));
  facts["functions"] = facts["native"] = "";
  add_functions(scene, generation, facts);
  const auto fill = [&](const std::string& name, std::string_view text) {
    return GeneratedFile{name, fill_holes(text, facts)};
  };
  return {{"",
           {fill("Cargo.toml", templates::kRustManifest), fill("build.rs", templates::kRustBuild),
            fill("lib.rs", templates::kRustLibrary)}}};
}

}  // namespace treeline
