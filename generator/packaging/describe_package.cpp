#include "packaging/describe_package.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <string_view>
#include <vector>

#include "emission/backend.hpp"
#include "emission/c_family_syntax.hpp"
#include "emission/generated_file.hpp"
#include "emission/list_sources.hpp"
#include "target/target.hpp"
#include "text/identifier.hpp"
#include "text/printable.hpp"

namespace treeline {
namespace {

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

/// The source that includes others: those of the functions that loop.
std::string print_joined_source(const std::vector<std::string>& joined) {
  if (joined.empty()) return {};
  std::string text =
      "// As one source these share the loops over a table of links: do not compile them alone "
      "too.\n";
  for (const std::string& file : joined) text += fmt::format("#include \"{}\"\n", file);
  return text;
}

std::vector<std::string> list_joined(const Generation& generation) {
  std::vector<std::string> files;
  for (const Source& source : generation.sources) {
    const bool asked = source.of == Source::Of::function;
    if (source.is_joined && asked) files.push_back(source.file);
  }
  if (files.size() == 1) files.clear();
  return files;
}

/// Sources that PlatformIO compiles, where they are not all.
std::string print_source_filter(const std::vector<std::string>& left_out) {
  if (left_out.empty()) return {};
  return fmt::format(",\n    \"srcFilter\": [\"+<*>\", \"-<{}>\"]",
                     fmt::join(left_out, ">\", \"-<"));
}

/// Rows of CMSIS: headers, sources, and what sources include.
std::string list_pack_files(const Scene& scene, const Generation& generation) {
  std::set<std::string> compiled, included;
  for (const PackagedSource& source : list_packaged_sources(scene, generation)) {
    compiled.insert(source.file);
  }
  for (const std::string& file : list_joined(generation)) included.insert(file);
  std::string text;
  const auto add = [&](const char* category, const std::string& file) {
    text += fmt::format("{}<file category=\"{}\" name=\"src/{}\"/>", text.empty() ? "" : "\n",
                        category, file);
  };
  for (const GeneratedFile& file : generation.files) {
    if (is_header(file.name)) add("header", file.name);
    if (compiled.erase(file.name) > 0) add("source", file.name);
    if (included.contains(file.name)) add("other", file.name);
  }
  for (const std::string& file : compiled) add("source", file);
  return text;
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

std::vector<PackagedSource> list_packaged_sources(const Scene& scene,
                                                  const Generation& generation) {
  const std::vector<std::string> joined = list_joined(generation);
  std::vector<PackagedSource> sources;
  for (const Source& source : generation.sources) {
    if (source.of == Source::Of::joined) continue;
    if (std::find(joined.begin(), joined.end(), source.file) != joined.end()) continue;
    sources.push_back({source.file, source.flags.is_huge ? kHugeFlag : ""});
  }
  std::sort(sources.begin(), sources.end(),
            [](const PackagedSource& a, const PackagedSource& b) { return a.file < b.file; });
  if (!joined.empty()) sources.push_back({scene.name + "_loops.c", ""});
  return sources;
}

PackageFacts describe_package(const Robot& robot, const Scene& scene,
                              const Generation& generation) {
  const Backend& backend = backend_of(scene.language);
  const std::string prefix = backend.has_namespaces ? "" : scene.name + "_";
  std::vector<std::string> functions, keywords, sources;
  for (const GeneratedFunction& generated : generation.functions) {
    functions.push_back(generated.program.name);
    keywords.push_back(fmt::format("{}{}\tKEYWORD2", prefix, generated.program.name));
  }
  for (const PackagedSource& source : list_packaged_sources(scene, generation)) {
    sources.push_back("../src/" + source.file);
  }
  const std::vector<std::string> joined = list_joined(generation);
  const auto flags = flags_of(scene);
  return {{"robot", plain(robot.name)},
          {"name", scene.name},
          {"NAME", in_capitals(scene.name)},
          {"version", generator_version()},
          {"cmake_language", std::string(backend.cmake)},
          {"header", scene.name + std::string(backend.header)},
          {"joints_header", scene.name + "_joints" + std::string(backend.header)},
          {"functions", fmt::format("{}", fmt::join(functions, ", "))},
          {"keywords", fmt::format("{}", fmt::join(keywords, "\n"))},
          {"requirement", scene.language == Language::cpp ? "\tdepends on CPP" : ""},
          {"sources", fmt::format("{}", fmt::join(sources, "\n"))},
          {"joined", print_joined_source(joined)},
          {"source_filter", print_source_filter(joined)},
          {"pack_files", list_pack_files(scene, generation)},
          {"flags", fmt::format("{}", fmt::join(flags, " "))},
          {"quoted_flags", fmt::format("\"{}\"", fmt::join(flags, "\", \""))}};
}

}  // namespace treeline
