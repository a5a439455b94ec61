#include "packaging/describe_package.hpp"

#include <fmt/format.h>

#include <cctype>
#include <string_view>
#include <vector>

#include "description/printable.hpp"
#include "emission/c_family_syntax.hpp"
#include "emission/generator_version.hpp"
#include "emission/print_optimize.hpp"
#include "target/target.hpp"

namespace treeline {
namespace {

bool is_source(const std::string& file) {
  return file.ends_with(".cpp") || file.ends_with(".c");
}
bool is_header(const std::string& file) {
  return file.ends_with(".hpp") || file.ends_with(".h");
}

/// As the emitted CMakeLists.txt compiles: without fast mathematics, and on microcontrollers
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
  for (const GeneratedFile& file : generation.files) {
    if (is_source(file.name)) sources.push_back("../src/" + file.name);
    if (is_source(file.name) || is_header(file.name)) {
      pack_files.push_back(fmt::format("<file category=\"{}\" name=\"src/{}\"/>",
                                       is_source(file.name) ? "source" : "header", file.name));
    }
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
          {"pack_files", fmt::format("{}", fmt::join(pack_files, "\n"))},
          {"flags", fmt::format("{}", fmt::join(flags, " "))},
          {"quoted_flags", fmt::format("\"{}\"", fmt::join(flags, "\", \""))}};
}

}  // namespace treeline
