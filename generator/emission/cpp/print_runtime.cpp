#include "emission/cpp/print_runtime.hpp"

#include <algorithm>
#include <utility>

#include "emission/cpp/print_loop_headers.hpp"
#include "emission/cpp/templates.hpp"
#include "emission/describe_program.hpp"
#include "emission/list_sources.hpp"
#include "emission/misra/follow_rules.hpp"
#include "emission/print_columns.hpp"
#include "emission/print_damped_headers.hpp"
#include "emission/print_limit_headers.hpp"
#include "emission/print_sin_cos.hpp"
#include "emission/print_square_root.hpp"

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

/// What functions include that loop over a table of links.
std::vector<GeneratedFile> list_loop_headers(const EmissionContext& context,
                                             std::span<const Program> programs) {
  std::vector<GeneratedFile> files = print_loop_headers(context, list_sources(context, programs));
  for (GeneratedFile& file : files) file.text = print_header(context, file.text);
  return files;
}

/// For `profile: misra`, which has headers of its own.
std::vector<GeneratedFile> print_safe_runtime(const EmissionContext& context,
                                              std::span<const Program> programs) {
  std::vector<GeneratedFile> files;
  const bool damped = !context.effective_mass_limits.empty();
  const bool limited = context.limits.has_value();
  const bool controlled = context.controller != nullptr;
  const bool loops = has_loops(context, programs);
  if (damped || controlled || loops ||
      std::any_of(programs.begin(), programs.end(), uses_trigonometry)) {
    files.push_back(print_sin_cos(context));
  }
  if (loops) {
    for (const GeneratedFile& file : list_loop_headers(context, programs)) {
      files.push_back({file.name, misra::follow_rules(context, file.text)});
    }
  }
  if (damped) {
    for (GeneratedFile& file : print_damped_headers(context)) files.push_back(std::move(file));
  }
  if (limited) {
    for (GeneratedFile& file : print_limit_headers(context)) {
      files.push_back(std::move(file));
    }
  }
  if (limited || controlled || damped) files.push_back(print_square_root(context));
  return files;
}

}  // namespace

std::vector<GeneratedFile> print_runtime(const EmissionContext& context,
                                         std::span<const Program> programs,
                                         std::span<const Program> batch) {
  if (context.misra) return print_safe_runtime(context, programs);
  const bool damped = !context.effective_mass_limits.empty();
  const bool has_batch = !batch.empty();
  const bool limited = context.limits.has_value();
  const bool controlled = context.controller != nullptr;
  const bool loops = has_loops(context, programs);
  std::vector<GeneratedFile> files;
  if (loops || has_batch || damped || limited || controlled ||
      std::any_of(programs.begin(), programs.end(), uses_trigonometry)) {
    files.push_back({"sin_cos.hpp", print_header(context, print_sines_in_lanes())});
  }
  const std::vector<Program> sources = list_sources(context, programs);
  const bool lanes = has_batch || std::any_of(sources.begin(), sources.end(), uses_lanes);
  if (lanes) {
    files.push_back({"lanes.hpp", print_header(context, templates::kLanes)});
  }
  if (has_batch) {
    files.push_back({"load_lanes.hpp", print_header(context, templates::kLoadLanes)});
    files.push_back({"states.hpp", print_header(context, templates::kStates)});
  }
  if (damped) {
    for (GeneratedFile& file : print_damped_headers(context)) files.push_back(std::move(file));
  }
  if (limited) {
    for (GeneratedFile& file : print_limit_headers(context)) files.push_back(std::move(file));
  }
  if (loops) {
    for (GeneratedFile& file : list_loop_headers(context, programs))
      files.push_back(std::move(file));
  }
  if (damped || limited || controlled) {
    files.push_back(print_square_root(context));
  }
  for (GeneratedFile& file : print_column_headers(context, programs)) {
    files.push_back(std::move(file));
  }
  return files;
}

}  // namespace treeline::cpp
