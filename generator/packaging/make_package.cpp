#include "packaging/make_package.hpp"

#include <string_view>

#include "packaging/describe_package.hpp"
#include "packaging/for_firmware.hpp"
#include "packaging/for_fmu.hpp"
#include "packaging/for_python.hpp"
#include "packaging/for_ros2_control.hpp"
#include "packaging/for_rust.hpp"
#include "packaging/for_wasm.hpp"
#include "packaging/print_example.hpp"
#include "packaging/templates.hpp"

namespace treeline {
namespace {

namespace templates = package_templates;

GeneratedFile fill(const std::string& name, std::string_view text, const PackageFacts& facts) {
  return {name, fill_facts(text, facts)};
}

std::vector<PackageFolder> for_cmake(const PackageFacts& facts) {
  return {{"", {fill("CMakeLists.txt", templates::kCMakeLists, facts)}}};
}

std::vector<PackageFolder> for_platformio(const PackageFacts& facts) {
  return {{"", {fill("library.json", templates::kPlatformioLibrary, facts)}}};
}

std::vector<PackageFolder> for_zephyr(const PackageFacts& facts) {
  return {{"zephyr",
           {fill("module.yml", templates::kZephyrModule, facts),
            fill("Kconfig", templates::kZephyrKconfig, facts),
            fill("CMakeLists.txt", templates::kZephyrCMakeLists, facts)}}};
}

std::vector<PackageFolder> for_arduino(const PackageFacts& facts, const Scene& scene,
                                       const Generation& generation) {
  const std::string example = scene.name + "_time";
  return {{"",
           {fill("library.properties", templates::kArduinoLibrary, facts),
            fill("keywords.txt", templates::kArduinoKeywords, facts)}},
          {"examples/" + example, {{example + ".ino", print_example(scene, generation, facts)}}}};
}

std::vector<PackageFolder> for_cmsis(const PackageFacts& facts) {
  return {{"", {fill("Treeline." + facts.at("name") + ".pdsc", templates::kCmsisPack, facts)}}};
}

std::vector<PackageFolder> describe_to_tool(PackageKind kind, const PackageFacts& facts,
                                            const Robot& robot, const Scene& scene,
                                            const Generation& generation) {
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
    case PackageKind::python:
      return for_python(facts, scene, generation);
    case PackageKind::fmu:
    case PackageKind::fmu3:
      return for_fmu(kind, facts, robot, scene, generation);
    case PackageKind::rust:
      return for_rust(facts, robot, scene, generation);
    case PackageKind::wasm:
      return for_wasm(facts, robot, scene, generation);
    case PackageKind::ros2_control:
      return for_ros2_control(facts, robot, scene, generation);
    case PackageKind::firmware:
      return for_firmware(facts, robot, scene, generation);
  }
  return {};
}

}  // namespace

std::vector<PackageFolder> make_package(PackageKind kind, const Robot& robot, const Scene& scene,
                                        const Generation& generation) {
  if (kind == PackageKind::none) return {{"", generation.files}};
  const PackageFacts facts = describe_package(robot, scene, generation);
  std::vector<PackageFolder> folders = describe_to_tool(kind, facts, robot, scene, generation);
  folders.push_back({"src", generation.files});
  // CMake's project joins them itself, and Arduino compiles whatever it finds.
  const bool lists_sources = kind != PackageKind::cmake && kind != PackageKind::arduino;
  if (lists_sources && !facts.at("joined").empty()) {
    folders.back().files.push_back({scene.name + "_loops.c", facts.at("joined")});
  }
  return folders;
}

}  // namespace treeline
