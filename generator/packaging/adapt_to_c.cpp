#include "packaging/adapt_to_c.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "description/states_key.hpp"

namespace treeline {

namespace {

/// A kind of package that is compiled from C, in words and as the command line has it.
struct PackageOfC {
  PackageKind kind;
  const char* words;
  const char* option;
  std::string_view caller;  ///< see `caller_of`
};
constexpr PackageOfC kPackagesOfC[] = {
    {PackageKind::python, "a package for Python", "python", "Python"},
    {PackageKind::rust, "a package for Rust", "rust", "Rust"},
    {PackageKind::fmu, "an FMU", "fmu", ""},
    {PackageKind::fmu3, "an FMU", "fmu3", ""},
    {PackageKind::wasm, "a package for WebAssembly", "wasm", "JavaScript"},
    {PackageKind::ros2_control, "a package for ros2_control", "ros2_control", ""},
    {PackageKind::firmware, "firmware", "firmware", ""}};

const PackageOfC* find_package_of_c(PackageKind kind) {
  const auto* const at =
      std::find_if(std::begin(kPackagesOfC), std::end(kPackagesOfC),
                   [&](const PackageOfC& package) { return package.kind == kind; });
  return at == std::end(kPackagesOfC) ? nullptr : at;
}

}  // namespace

bool is_fmu(PackageKind kind) {
  return kind == PackageKind::fmu || kind == PackageKind::fmu3;
}

bool is_compiled_from_c(PackageKind kind) {
  return find_package_of_c(kind) != nullptr;
}

std::string describe(PackageKind kind) {
  const PackageOfC* const package = find_package_of_c(kind);
  return package == nullptr ? "" : package->words;
}

std::string option_of(PackageKind kind) {
  const PackageOfC* const package = find_package_of_c(kind);
  return package == nullptr ? "" : package->option;
}

std::string_view caller_of(PackageKind kind) {
  const PackageOfC* const package = find_package_of_c(kind);
  return package == nullptr ? "" : package->caller;
}

void adapt_to_c(PackageKind kind, const std::string& text, Scene& scene, Diagnostics& diagnostics) {
  if (scene.language != Language::c && states_key(text, "language")) {
    diagnostics.add({Severity::note, scene.file, 0, "language",
                     describe(kind) + " is compiled from C, whatever the scene says", ""});
  }
  scene.language = Language::c;
  if (!scene.controller || !is_fmu(kind) || scene.functions.empty()) return;
  scene.controller.reset();
  diagnostics.add(
      {Severity::warning, scene.file, 0, "controller",
       "it is left out: an FMU is that of the robot where the scene has functions",
       "For one of the controller write functions: []. Or generate it in C, without --package " +
           option_of(kind) + "."});
}

}  // namespace treeline
