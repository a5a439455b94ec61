#include "emission/c/refuse.hpp"

#include <fmt/format.h>

#include "emission/c/hides_header.hpp"
#include "emission/misra/refuse.hpp"

namespace treeline::c {
void refuse(const EmissionContext& context, Diagnostics& diagnostics) {
  misra::refuse(context, diagnostics);
  if (context.controlled) {
    diagnostics.add({Severity::error, "", 0, "controller",
                     "a controller is compiled from C++17 (runtime/core), which C cannot include",
                     "Generate C++ (`language: c++`): NAME_controller.h is a header for C as well, "
                     "so that C links and calls NAME_step."});
  }
  if (hides_header(context.name)) {
    diagnostics.add({Severity::error, "", 0, "name",
                     fmt::format("the header {0}.h would hide C's own <{0}.h>", context.name),
                     "Choose another name in the scene (key `name`) or with --name."});
  }
}

}  // namespace treeline::c
