#include "emission/c/print_project.hpp"

#include "emission/c/templates.hpp"
#include "emission/describe_program.hpp"
#include "emission/fill_template.hpp"
#include "emission/print_optimize.hpp"
#include "emission/print_target.hpp"

namespace treeline::c {
namespace {

/// GCC's passes that save spills, for functions that they do not take minutes for.
std::string print_optimize(std::span<const Program> programs) {
  std::string sources;
  for (const Program& program : programs) {
    if (!is_long(program)) sources += "      " + program.name + ".c\n";
  }
  if (sources.empty()) return {};
  return "if(CMAKE_C_COMPILER_ID STREQUAL \"GNU\")\n"
         "  # Fewer spills and copies in long straight-line code; no arithmetic changes.\n"
         "  set_source_files_properties(\n" +
         sources +
         "    PROPERTIES COMPILE_OPTIONS \"-flive-range-shrinkage;-frename-registers\")\n"
         "endif()\n";
}

}  // namespace

std::string print_project(const EmissionContext& context, std::span<const Program> programs,
                          std::span<const Program> /*batch*/) {
  std::string sources;
  for (const Program& program : programs) sources += program.name + ".c\n";
  if (!context.heaviest.empty()) sources += "damped_control_torque.c\n";
  if (context.limits) sources += "limited_control_torque.c\n";
  if (context.prefetch) sources += "prefetch.c\n";
  return fill_template(
      templates::kCMakeLists,
      {{"robot", context.robot},
       {"name", context.name},
       {"sources", sources},
       {"contraction", contraction_default(context)},
       {"target_flags", print_target_flags(context)},
       {"optimize", print_optimize(programs) + print_small_code(context, programs)}});
}

}  // namespace treeline::c
