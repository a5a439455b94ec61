#include "emission/cpp/print_runtime.hpp"

#include <algorithm>

#include "emission/controller_unit.hpp"
#include "emission/cpp/print_controller.hpp"
#include "emission/cpp/templates.hpp"
#include "emission/describe_program.hpp"
#include "emission/misra/print_sin_cos.hpp"

namespace treeline::cpp {
namespace {

/// A header of the runtime in the robot's own namespace, so that robots generated at
/// different times live in one program, and in one folder with those that it includes.
std::string print_header(const EmissionContext& context, std::string_view header) {
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

}  // namespace

std::vector<GeneratedFile> print_runtime(const EmissionContext& context,
                                         std::span<const Program> programs,
                                         std::span<const Program> batch) {
  const bool damped = !context.heaviest.empty();
  const bool has_batch = !batch.empty();
  const bool limited = context.limits.has_value();
  const bool controlled = context.controller != nullptr;
  std::vector<GeneratedFile> files;
  if (has_batch || damped || limited || controlled ||
      std::any_of(programs.begin(), programs.end(), uses_trigonometry)) {
    files.push_back({"sin_cos.hpp", context.misra ? misra::print_sin_cos(context)
                                                  : print_header(context, templates::kSinCos)});
  }
  bool lanes = has_batch || std::any_of(programs.begin(), programs.end(), uses_lanes);
  if (controlled) {
    for (const Program* const program : context.controller->programs()) {
      lanes = lanes || uses_lanes(*program);
    }
    for (const GeneratedFile& file : list_controller_headers()) {
      files.push_back({file.name, print_header(context, file.text)});
    }
  }
  if (lanes) {
    files.push_back({"lanes.hpp", print_header(context, templates::kLanes)});
  }
  if (has_batch) {
    files.push_back({"states.hpp", print_header(context, templates::kStates)});
  }
  if (damped) {
    files.push_back({"damped_solve.hpp", print_header(context, templates::kDampedSolve)});
    files.push_back({"ldlt.hpp", print_header(context, templates::kLdlt)});
    files.push_back({"symmetric_eigen.hpp", print_header(context, templates::kSymmetricEigen)});
  }
  if (limited) {
    files.push_back({"limited_torque.hpp", print_header(context, templates::kLimitedTorque)});
    files.push_back({"quadratic_program.hpp", print_header(context, templates::kQuadraticProgram)});
  }
  if (damped || limited || controlled) {
    files.push_back({"square_root.hpp", print_header(context, templates::kSquareRoot)});
  }
  return files;
}

}  // namespace treeline::cpp
