#include "packaging/make_package.hpp"

#include <initializer_list>
#include <string_view>

#include "emission/fill_template.hpp"
#include "packaging/describe_package.hpp"
#include "packaging/print_example.hpp"
#include "packaging/templates.hpp"

namespace treeline {
namespace {

namespace templates = package_templates;

/// The file that a template makes of those facts which it names.
GeneratedFile fill(const std::string& name, std::string_view text, const PackageFacts& facts,
                   std::initializer_list<const char*> holes) {
  std::map<std::string, std::string> values;
  for (const char* hole : holes) values.emplace(hole, facts.at(hole));
  return {name, fill_template(text, values)};
}

std::vector<PackageFolder> for_cmake(const PackageFacts& facts) {
  return {{"",
           {fill("CMakeLists.txt", templates::kCMakeLists, facts,
                 {"robot", "name", "version", "cmake_language", "header_patterns"})}}};
}

std::vector<PackageFolder> for_platformio(const PackageFacts& facts) {
  return {{"",
           {fill("library.json", templates::kPlatformioLibrary, facts,
                 {"name", "version", "robot", "header", "quoted_flags", "source_filter"})}}};
}

std::vector<PackageFolder> for_zephyr(const PackageFacts& facts) {
  return {
      {"zephyr",
       {fill("module.yml", templates::kZephyrModule, facts, {"robot", "name"}),
        fill("Kconfig", templates::kZephyrKconfig, facts, {"NAME", "name", "requirement", "robot"}),
        fill("CMakeLists.txt", templates::kZephyrCMakeLists, facts,
             {"NAME", "name", "sources", "flags", "small_sources"})}}};
}

std::vector<PackageFolder> for_arduino(const PackageFacts& facts, const Scene& scene,
                                       const Generation& generation) {
  const std::string example = scene.name + "_time";
  return {{"",
           {fill("library.properties", templates::kArduinoLibrary, facts,
                 {"name", "version", "robot", "functions", "header"}),
            fill("keywords.txt", templates::kArduinoKeywords, facts, {"keywords"})}},
          {"examples/" + example, {{example + ".ino", print_example(scene, generation, facts)}}}};
}

std::vector<PackageFolder> for_cmsis(const PackageFacts& facts) {
  return {{"",
           {fill("Treeline." + facts.at("name") + ".pdsc", templates::kCmsisPack, facts,
                 {"name", "robot", "version", "flags", "pack_files"})}}};
}

std::vector<PackageFolder> describe_to_tool(PackageKind kind, const PackageFacts& facts,
                                            const Scene& scene, const Generation& generation) {
  switch (kind) {
    case PackageKind::none:
      return {};
    case PackageKind::cmake:
      return for_cmake(facts);
    case PackageKind::platformio:
      return for_platformio(facts);
    case PackageKind::zephyr:
      return for_zephyr(facts);
    case PackageKind::arduino:
      return for_arduino(facts, scene, generation);
    case PackageKind::cmsis:
      return for_cmsis(facts);
  }
  return {};
}

}  // namespace

std::vector<PackageFolder> make_package(PackageKind kind, const Robot& robot, const Scene& scene,
                                        const Generation& generation) {
  if (kind == PackageKind::none) return {{"", generation.files}};
  const PackageFacts facts = describe_package(robot, scene, generation);
  std::vector<PackageFolder> folders = describe_to_tool(kind, facts, scene, generation);
  folders.push_back({"src", generation.files});
  // CMake's project joins them itself, and Arduino compiles whatever it finds.
  const bool lists_sources = kind != PackageKind::cmake && kind != PackageKind::arduino;
  if (lists_sources && !facts.at("joined").empty()) {
    folders.back().files.push_back({scene.name + "_loops.c", facts.at("joined")});
  }
  return folders;
}

}  // namespace treeline
