#include "packaging/describe_package.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string_view>
#include <vector>

#include "emission/c_family_syntax.hpp"
#include "emission/fill_template.hpp"
#include "emission/generator_version.hpp"
#include "emission/print_optimize.hpp"
#include "target/target.hpp"
#include "text/printable.hpp"

namespace treeline {
namespace {

bool is_source(const std::string& file) {
  return file.ends_with(".cpp") || file.ends_with(".c");
}
bool is_header(const std::string& file) {
  return file.ends_with(".hpp") || file.ends_with(".h");
}

/// Flags as in the emitted CMakeLists.txt: without fast mathematics, and on microcontrollers
/// without fused operations, so that the bits are those of every other machine.
std::vector<std::string> flags_of(const Scene& scene) {
  std::vector<std::string> flags = {"-fno-fast-math"};
  if (scene.optimize == Optimize::size) flags.emplace_back(kSmallCodeFlag);
  if (scene.language == Language::cpp) flags.emplace_back("-std=gnu++17");
  const Target* const target = find_target(scene.target);
  if (target != nullptr && !target->contracts) flags.emplace_back("-ffp-contract=off");
  return flags;
}

/// Lines of CMake that compile for small code what `optimize: balanced` says; with `size` the flags
/// of all do.
std::string print_small_sources(const Scene& scene, const Generation& generation) {
  if (scene.optimize != Optimize::balanced) return {};
  std::string text;
  for (const std::string& source : generation.small_sources) text += "../src/" + source + " ";
  return text.empty() ? text
                      : fmt::format("set_property(SOURCE {}APPEND PROPERTY COMPILE_OPTIONS {})",
                                    text, kSmallCodeFlag);
}

/// Sources of C that share the loops over a table of links if they are compiled as one. None where
/// there would be only one.
std::vector<std::string> list_looping_sources(const Scene& scene, const Generation& generation) {
  std::vector<std::string> sources;
  if (scene.language != Language::c) return sources;
  for (const GeneratedFunction& generated : generation.functions) {
    if (generated.program.loops) sources.push_back(generated.program.name + ".c");
  }
  if (sources.size() == 1) sources.clear();
  return sources;
}

/// Category of a file in CMSIS.
std::string category_of(const std::string& file, const std::vector<std::string>& included) {
  if (is_header(file)) return "header";
  const bool compiled = std::find(included.begin(), included.end(), file) == included.end();
  return compiled ? "source" : "other";
}

/// The source that includes others.
std::string print_joined_source(const std::vector<std::string>& sources) {
  if (sources.empty()) return {};
  std::string text =
      "// As one source these share the loops over a table of links: do not compile them alone "
      "too.\n";
  for (const std::string& source : sources) text += fmt::format("#include \"{}\"\n", source);
  return text;
}

/// Sources that PlatformIO compiles, where they are not all.
std::string print_source_filter(const std::vector<std::string>& left_out) {
  if (left_out.empty()) return {};
  return fmt::format(",\n    \"srcFilter\": [\"+<*>\", \"-<{}>\"]",
                     fmt::join(left_out, ">\", \"-<"));
}

/// Text that is harmless in JSON, XML and lists of properties: letters, digits, some punctuation.
std::string plain(const std::string& text) {
  std::string result;
  for (const char c : printable(text)) {
    const bool safe = std::isalnum(static_cast<unsigned char>(c)) != 0 ||
                      std::string_view(" _-.,:()").find(c) != std::string_view::npos;
    result += safe ? c : '_';
  }
  return result;
}

}  // namespace

PackageFacts describe_package(const Robot& robot, const Scene& scene,
                              const Generation& generation) {
  std::vector<std::string> functions, keywords, sources, pack_files;
  for (const GeneratedFunction& generated : generation.functions) {
    const bool prefixed = scene.language == Language::c;
    functions.push_back(generated.program.name);
    keywords.push_back(
        fmt::format("{}{}\tKEYWORD2", prefixed ? scene.name + "_" : "", generated.program.name));
  }
  const std::vector<std::string> looping = list_looping_sources(scene, generation);
  const std::string joined = print_joined_source(looping);
  std::vector<std::string> files;
  for (const GeneratedFile& file : generation.files) files.push_back(file.name);
  if (!joined.empty()) files.push_back(scene.name + "_loops.c");
  for (const std::string& file : files) {
    if (!is_source(file) && !is_header(file)) continue;
    const std::string category = category_of(file, looping);
    if (category == "source") sources.push_back("../src/" + file);
    pack_files.push_back(fmt::format("<file category=\"{}\" name=\"src/{}\"/>", category, file));
  }
  const bool is_c = scene.language == Language::c;
  const std::string ending = is_c ? "h" : "hpp";
  const auto flags = flags_of(scene);
  return {{"robot", plain(robot.name)},
          {"name", scene.name},
          {"NAME", in_capitals(scene.name)},
          {"version", generator_version()},
          {"cmake_language", is_c ? "C" : "CXX"},
          {"header", scene.name + "." + ending},
          {"joints_header", scene.name + "_joints." + ending},
          {"header_patterns", is_c ? "PATTERN \"*.h\"" : "PATTERN \"*.hpp\" PATTERN \"*.h\""},
          {"functions", fmt::format("{}", fmt::join(functions, ", "))},
          {"keywords", fmt::format("{}", fmt::join(keywords, "\n"))},
          {"requirement", is_c ? "" : "\tdepends on CPP"},
          {"small_sources", print_small_sources(scene, generation)},
          {"sources", fmt::format("{}", fmt::join(sources, "\n"))},
          {"joined", joined},
          {"source_filter", print_source_filter(looping)},
          {"pack_files", fmt::format("{}", fmt::join(pack_files, "\n"))},
          {"flags", fmt::format("{}", fmt::join(flags, " "))},
          {"quoted_flags", fmt::format("\"{}\"", fmt::join(flags, "\", \""))}};
}

std::string fill_facts(std::string_view text, const PackageFacts& facts) {
  PackageFacts used;
  for (const auto& [name, value] : facts) {
    if (text.find("{{" + name + "}}") != text.npos) used[name] = value;
  }
  return fill_template(text, used);
}

}  // namespace treeline
