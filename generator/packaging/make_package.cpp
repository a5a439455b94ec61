#include <algorithm>
#include <string_view>
#include <utility>

#include "description/scene_queries.hpp"
#include "emission/emitted_text.hpp"
#include "emission/generated_file.hpp"
#include "packaging/package_kinds.hpp"
#include "packaging/templates.hpp"

namespace treeline {
namespace {

namespace templates = package_templates;

GeneratedFile fill(const std::string& name, std::string_view text, const PackageFacts& facts) {
  return {name, fill_holes(text, facts)};
}

std::vector<PackageFolder> for_cmake(PackageFacts facts, const Robot& /*robot*/,
                                     const Scene& /*scene*/, const Generation& /*generation*/) {
  return {{"", {fill("CMakeLists.txt", templates::kCmakeCMakeLists, facts)}}};
}

std::vector<PackageFolder> for_platformio(PackageFacts facts, const Robot& /*robot*/,
                                          const Scene& /*scene*/,
                                          const Generation& /*generation*/) {
  return {{"", {fill("library.json", templates::kPlatformioLibrary, facts)}}};
}

std::vector<PackageFolder> for_zephyr(PackageFacts facts, const Robot& /*robot*/,
                                      const Scene& /*scene*/, const Generation& /*generation*/) {
  return {{"zephyr",
           {fill("module.yml", templates::kZephyrModule, facts),
            fill("Kconfig", templates::kZephyrKconfig, facts),
            fill("CMakeLists.txt", templates::kZephyrCMakeLists, facts)}}};
}

std::vector<PackageFolder> for_arduino(PackageFacts facts, const Robot& /*robot*/,
                                       const Scene& scene, const Generation& generation) {
  const std::string example = scene.name + "_time";
  return {{"",
           {fill("library.properties", templates::kArduinoLibrary, facts),
            fill("keywords.txt", templates::kArduinoKeywords, facts)}},
          {"examples/" + example, {{example + ".ino", print_example(scene, generation, facts)}}}};
}

std::vector<PackageFolder> for_cmsis(PackageFacts facts, const Robot& /*robot*/, const Scene& scene,
                                     const Generation& /*generation*/) {
  return {{"", {fill("Treeline." + scene.name + ".pdsc", templates::kCmsisPack, facts)}}};
}

constexpr PackageKind kPackages[] = {
    // CMake's project joins sources itself, and Arduino compiles whatever it finds.
    {.option = "cmake", .make = for_cmake, .joins_sources = false},
    {.option = "platformio", .make = for_platformio, .is_for_firmware = true},
    {.option = "zephyr", .make = for_zephyr, .is_for_firmware = true},
    {.option = "arduino",
     .make = for_arduino,
     .calls_a_function = true,
     .is_for_firmware = true,
     .joins_sources = false},
    {.option = "cmsis", .make = for_cmsis, .is_for_firmware = true},
    {.option = "python", .make = for_python, .of_c = "a package for Python", .caller = "Python"},
    {.option = "rust",
     .make = for_rust,
     .of_c = "a package for Rust",
     .caller = "Rust",
     .calls_a_function = true},
    {.option = "fmu",
     .make = for_fmu2,
     .of_c = "an FMU",
     .is_unit = true,
     .calls_a_function = true,
     .refuse = refuse_for_fmu},
    {.option = "fmu3",
     .make = for_fmu3,
     .of_c = "an FMU",
     .is_unit = true,
     .calls_a_function = true,
     .refuse = refuse_for_fmu},
    {.option = "wasm",
     .make = for_wasm,
     .of_c = "a package for WebAssembly",
     .caller = "JavaScript",
     .calls_a_function = true},
    {.option = "ros2_control",
     .make = for_ros2_control,
     .of_c = "a package for ros2_control",
     .refuse = refuse_for_ros2_control},
    {.option = "firmware",
     .make = for_firmware,
     .of_c = "firmware",
     .refuse = refuse_for_firmware}};

}  // namespace

std::span<const PackageKind> list_packages() {
  return kPackages;
}

const PackageKind* find_package(std::string_view option) {
  const auto* const at =
      std::find_if(std::begin(kPackages), std::end(kPackages),
                   [&](const PackageKind& kind) { return kind.option == option; });
  return at == std::end(kPackages) ? nullptr : at;
}

std::vector<PackageFolder> make_package(const PackageKind* kind, const Robot& robot,
                                        const Scene& scene, const Generation& generation) {
  if (kind == nullptr) return {{"", generation.files}};
  const PackageFacts facts = describe_package(robot, scene, generation);
  std::vector<PackageFolder> folders = kind->make(facts, robot, scene, generation);
  std::vector<GeneratedFile> joined;
  if (kind->joins_sources && !facts.at("joined").empty()) {
    joined.push_back({scene.name + "_loops.c", facts.at("joined")});
  }
  folders.push_back({"src", std::move(joined)});
  for (PackageFolder& folder : folders) {
    for (GeneratedFile& file : folder.files) state_licence(file);
  }
  auto& src = folders.back().files;
  src.insert(src.begin(), generation.files.begin(), generation.files.end());
  return folders;
}

void adapt_to_c(const PackageKind& kind, const std::string& text, Scene& scene,
                Diagnostics& diagnostics) {
  if (scene.language != Language::c && states_key(text, "language")) {
    diagnostics.add({Severity::note, scene.file, 0, "language",
                     std::string(kind.of_c) + " is compiled from C, whatever the scene says", ""});
  }
  scene.language = Language::c;
  if (!scene.controller || !kind.is_unit || scene.functions.empty()) return;
  scene.controller.reset();
  diagnostics.add(
      {Severity::warning, scene.file, 0, "controller",
       "it is left out: an FMU is that of the robot where the scene has functions",
       "For one of the controller write functions: []. Or generate it in C, without --package " +
           std::string(kind.option) + "."});
}

}  // namespace treeline
