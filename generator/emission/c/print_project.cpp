#include "emission/c/print_project.hpp"

#include <fmt/format.h>

#include "emission/c/print_loops.hpp"
#include "emission/c/templates.hpp"
#include "emission/fill_template.hpp"
#include "emission/list_sources.hpp"
#include "emission/print_identity.hpp"
#include "emission/print_optimize.hpp"
#include "emission/print_selftest.hpp"
#include "emission/print_target.hpp"

namespace treeline::c {
namespace {

/// Lines of CMake that make the source `joined` of others; none where its name is empty.
std::string print_joined(const std::string& joined, std::span<const Program> programs) {
  if (joined.empty()) return {};
  std::string text =
      "# The functions that loop over links, as one source: so they share the loops.\n"
      "set(joined \"\")\nforeach(source IN ITEMS\n";
  for (const Program& program : programs) {
    if (program.loops) text += "    " + program.name + ".c\n";
  }
  text.pop_back();
  return text + fmt::format(
                    ")\n"
                    "  string(APPEND joined \"#include \\\"${{CMAKE_CURRENT_SOURCE_DIR}}/"
                    "${{source}}\\\"\\n\")\n"
                    "endforeach()\n"
                    "file(GENERATE OUTPUT \"{0}.c\" CONTENT \"${{joined}}\")\n"
                    "set_source_files_properties(\"{0}.c\" PROPERTIES GENERATED TRUE)\n",
                    joined);
}

}  // namespace

std::string print_project(const EmissionContext& context, std::span<const Program> programs,
                          std::span<const Program> batch) {
  const std::vector<Program> plain = list_sources(context, programs);
  const std::string joined = joined_loops(context, plain);
  std::string sources = joined.empty() ? "" : joined + ".c\n";
  if (context.controller) sources += "controller.c\n";
  for (const Program& program : plain) {
    if (joined.empty() || !program.loops) sources += program.name + ".c\n";
  }
  for (const Program& program : batch) sources += "batch_" + program.name + ".c\n";
  if (!context.effective_mass_limits.empty()) sources += "damped_control_torque.c\n";
  if (context.limits) sources += "limited_control_torque.c\n";
  if (context.limits && !batch.empty()) sources += "batch_limited_control_torque.c\n";
  if (context.prefetch) sources += "prefetch.c\n";
  if (context.selftest) sources += std::string(kSelftestStem) + ".c\n";
  sources += std::string(kIdentityStem) + ".c\n";
  return fill_template(
      templates::kCMakeLists,
      {{"robot", context.robot},
       {"name", context.name},
       {"joined", print_joined(joined, plain)},
       {"sources", sources},
       {"contraction", contraction_default(context)},
       {"target_flags", print_target_flags(context) + print_extra_passes(context, programs, batch) +
                            print_small_code(context, programs, batch) +
                            print_huge_code(context, programs, batch)}});
}

}  // namespace treeline::c
