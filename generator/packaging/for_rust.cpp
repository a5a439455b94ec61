#include "packaging/for_rust.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <regex>
#include <sstream>
#include <string_view>

#include "emission/c_family_syntax.hpp"
#include "emission/comment.hpp"
#include "emission/print_identity.hpp"
#include "packaging/call_c.hpp"
#include "packaging/templates.hpp"

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

/// An array of constants in C, `static const double arm_home[6] = {...}`, as one of Rust.
std::string print_constant(const std::string& robot, const std::string& real,
                           const std::string& declared) {
  const std::size_t bracket = declared.find('['), brace = declared.find('{');
  const std::size_t name = declared.rfind(" " + robot + "_", bracket) + robot.size() + 2;
  const std::string size = declared.substr(bracket + 1, declared.find(']') - bracket - 1);
  const bool is_text = declared.starts_with("static const char");
  std::string entries = declared.substr(brace + 1);
  if (!is_text) {
    entries = std::regex_replace(entries, std::regex("([0-9.])[fF]\\b"), "$1");
    entries = std::regex_replace(entries, std::regex("\\w+_UNLIMITED"), real + "::MAX");
  }
  return fmt::format("pub const {}: [{}; {}] = [{}];\n",
                     in_capitals(declared.substr(name, bracket - name)), is_text ? "&str" : real,
                     size, entries);
}

/// The arrays of constants in the headers of C: names, home and limits.
std::string print_constants(const Scene& scene, const std::vector<GeneratedFile>& files) {
  const std::string real = scene.real == Real::float32 ? "f32" : "f64";
  std::string text, doc;
  for (const GeneratedFile& file : files) {
    if (!file.name.ends_with("_joints.h") && !file.name.ends_with("_damped.h")) continue;
    std::istringstream lines(file.text);
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with("///")) doc = line + "\n";
      if (!line.starts_with("static const ") || line.find('{') == line.npos) continue;
      std::string declared = line;
      while (!declared.ends_with("};") && std::getline(lines, line)) declared += "\n" + line;
      declared.resize(declared.size() - 2);
      text += doc + print_constant(scene.name, real, declared);
    }
  }
  return text;
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
std::string list_sources(const PackageFacts& facts, const Scene& scene,
                         const Generation& generation) {
  const auto own = list_own_flags(scene, generation);
  std::string text;
  std::istringstream words(facts.at("sources"));
  for (std::string word; words >> word;) {  // "../src/" and a name
    const auto found = own.find(word.substr(7));
    text += fmt::format("    (\"{}\", &[{}]),\n", word.substr(3),
                        found == own.end() ? "" : fmt::format("\"{}\"", found->second));
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

/// The length of an array of constants, or 0.
std::string length_of(const std::string& constants, const std::string& name) {
  std::smatch found;
  const std::regex length("const " + name + ": \\[[^;]*; (\\d+)\\]");
  return std::regex_search(constants, found, length) ? found.str(1) : "0";
}

}  // namespace

std::vector<PackageFolder> for_rust(PackageFacts facts, const Scene& scene,
                                    const Generation& generation) {
  facts["version"] += "+" + digest_of_files(generation.files).substr(0, 12);
  facts["crate"] = crate_name(scene.name);
  facts["real"] = scene.real == Real::float32 ? "f32" : "f64";
  facts["quoted_flags"] = quote_flags(facts, scene);
  facts["sources"] = list_sources(facts, scene, generation);
  facts["constants"] = print_constants(scene, generation.files);
  facts["nq"] = length_of(facts["constants"], "HOME");
  facts["nv"] = length_of(facts["constants"], "VELOCITY_LIMITS");
  facts["nx"] = length_of(facts["constants"], "TASK_ROW_NAMES");
  facts["conventions"] = print_doc("//!", harmless(generation.conventions));
  facts["example"] = print_example(facts, generation.functions.front().program);
  facts["not_called"] = comment("//!", describe_not_called(scene, "Rust"));
  facts["functions"] = facts["native"] = "";
  add_functions(scene, generation, facts);
  const auto fill = [&](const std::string& name, std::string_view text) {
    return GeneratedFile{name, fill_facts(text, facts)};
  };
  return {{"",
           {fill("Cargo.toml", templates::kRustManifest), fill("build.rs", templates::kRustBuild),
            fill("lib.rs", templates::kRustLibrary)}}};
}

}  // namespace treeline
