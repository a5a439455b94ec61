#include "emission/emit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "emission/check_emission.hpp"
#include "emission/comment.hpp"
#include "emission/fill_template.hpp"
#include "emission/print_batch.hpp"
#include "emission/print_contract.hpp"
#include "emission/print_damped.hpp"
#include "emission/print_eigen.hpp"
#include "emission/print_joints.hpp"
#include "emission/print_manifest.hpp"
#include "emission/print_source.hpp"
#include "emission/print_target.hpp"
#include "emission/templates.hpp"

namespace treeline {
namespace {

/// A header of the runtime in the robot's own namespace, so that robots generated at
/// different times live in one program, and in one folder with those that it includes.
std::string print_runtime(const EmissionContext& context, std::string_view header) {
  std::string text(header);
  const auto replace_all = [&text](std::string_view old, const std::string& by) {
    for (std::size_t at = text.find(old); at != std::string::npos;
         at = text.find(old, at + by.size())) {
      text.replace(at, old.size(), by);
    }
  };
  replace_all("treeline::core", context.name + "::detail");
  replace_all("#include \"core/", "#include \"");
  return text;
}

std::string print_cmake(const EmissionContext& context, std::span<const Program> programs,
                        std::span<const Program> batch) {
  std::string sources;
  for (const Program& program : programs) {
    sources += program.name + ".cpp\n";
  }
  for (const Program& program : batch) {
    sources += "batch_" + program.name + ".cpp\n";
  }
  return fill_template(templates::kCMakeLists, {{"robot", context.robot},
                                                {"name", context.name},
                                                {"contraction", contraction_default(context)},
                                                {"target_flags", print_target_flags(context)},
                                                {"sources", sources}});
}

/// `puma560`, `sin_cos.hpp`: `TREELINE_PUMA560_SIN_COS_HPP`. Two robots' files of one name must
/// not hide each other.
std::string guard_name(const std::string& robot, const std::string& file) {
  const bool own = file.starts_with(robot);
  std::string name = "TREELINE_" + (own ? "" : robot + "_") + file;
  for (char& c : name) {
    c = c == '.' ? '_' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return name;
}

/// Coding rules for firmware ask for include guards; `#pragma once` is no part of the language.
void guard_headers(const std::string& robot, std::vector<GeneratedFile>& files) {
  constexpr std::string_view kOnce = "#pragma once\n";
  for (GeneratedFile& file : files) {
    if (!file.text.starts_with(kOnce)) continue;
    const std::string name = guard_name(robot, file.name);
    file.text = fmt::format("#ifndef {0}\n#define {0}\n{1}\n#endif  // {0}\n", name,
                            file.text.substr(kOnce.size()));
  }
}

/// The headers of the runtime that these sources include.
void add_runtime(const EmissionContext& context, std::span<const Program> programs, bool has_batch,
                 std::vector<GeneratedFile>& files) {
  const bool damped = !context.heaviest.empty();
  if (has_batch || damped || std::any_of(programs.begin(), programs.end(), uses_trigonometry)) {
    files.push_back({"sin_cos.hpp", print_runtime(context, templates::kSinCos)});
  }
  if (has_batch || std::any_of(programs.begin(), programs.end(), uses_lanes)) {
    files.push_back({"lanes.hpp", print_runtime(context, templates::kLanes)});
  }
  if (has_batch) {
    files.push_back({"states.hpp", print_runtime(context, templates::kStates)});
  }
  if (damped) {
    files.push_back({"damped_solve.hpp", print_runtime(context, templates::kDampedSolve)});
    files.push_back({"ldlt.hpp", print_runtime(context, templates::kLdlt)});
    files.push_back({"square_root.hpp", print_runtime(context, templates::kSquareRoot)});
    files.push_back({"symmetric_eigen.hpp", print_runtime(context, templates::kSymmetricEigen)});
  }
}

}  // namespace

std::vector<GeneratedFile> emit(const EmissionContext& context, std::span<const Program> programs,
                                Diagnostics& diagnostics, std::span<const Program> batch) {
  Diagnostics own;
  check_emission(context, programs, own);
  for (const Diagnostic& diagnostic : own.list()) {
    diagnostics.add(diagnostic);
  }
  if (own.has_errors()) {
    return {};
  }
  std::vector<GeneratedFile> files = {{context.name + ".hpp", print_contract(context, programs)},
                                      {context.name + "_eigen.hpp", print_eigen(context, programs)},
                                      {context.name + "_joints.hpp", print_joints(context)},
                                      {"CMakeLists.txt", print_cmake(context, programs, batch)}};
  for (const Program& program : programs) {
    files.push_back({program.name + ".cpp", print_source(context, program)});
  }
  if (!batch.empty()) {
    files.push_back({context.name + "_batch.hpp", print_batch_header(context, batch)});
  }
  for (const Program& program : batch) {
    files.push_back({"batch_" + program.name + ".cpp", print_batch_source(context, program)});
  }
  if (!context.heaviest.empty()) {
    files.push_back({context.name + "_damped.hpp", print_damped(context, programs)});
  }
  for (GeneratedFile& file : files) file.text = harmless(file.text);
  add_runtime(context, programs, !batch.empty(), files);
  guard_headers(context.name, files);
  std::vector<std::string> names = {kManifestName};
  for (const GeneratedFile& file : files) {
    names.push_back(file.name);
  }
  std::sort(names.begin(), names.end());
  files.push_back({kManifestName, print_manifest(context, programs, names)});
  std::sort(files.begin(), files.end(),
            [](const GeneratedFile& a, const GeneratedFile& b) { return a.name < b.name; });
  return files;
}

}  // namespace treeline
