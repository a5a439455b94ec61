#include "emission/c/print_project.hpp"

#include "emission/c/templates.hpp"
#include "emission/fill_template.hpp"
#include "emission/print_optimize.hpp"
#include "emission/print_target.hpp"

namespace treeline::c {
std::string print_project(const EmissionContext& context, std::span<const Program> programs,
                          std::span<const Program> batch) {
  std::string sources;
  for (const Program& program : programs) sources += program.name + ".c\n";
  for (const Program& program : batch) sources += "batch_" + program.name + ".c\n";
  if (!context.effective_mass_limits.empty()) sources += "damped_control_torque.c\n";
  if (context.limits) sources += "limited_control_torque.c\n";
  if (context.prefetch) sources += "prefetch.c\n";
  return fill_template(
      templates::kCMakeLists,
      {{"robot", context.robot},
       {"name", context.name},
       {"sources", sources},
       {"contraction", contraction_default(context)},
       {"target_flags", print_target_flags(context) + print_extra_passes(context, programs, batch) +
                            print_small_code(context, programs, batch)}});
}

}  // namespace treeline::c
