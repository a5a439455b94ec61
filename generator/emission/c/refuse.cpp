#include "emission/c/refuse.hpp"

#include <fmt/format.h>

#include "emission/c/hides_header.hpp"
#include "emission/misra/refuse.hpp"

namespace treeline::c {

void refuse(const EmissionContext& context, Diagnostics& diagnostics) {
  misra::refuse(context, diagnostics);
  refuse_hidden_header(context, diagnostics);
}

void refuse_hidden_header(const EmissionContext& context, Diagnostics& diagnostics) {
  if (hides_header(context.name)) {
    diagnostics.add({Severity::error, "", 0, "name",
                     fmt::format("the header {0}.h would hide C's own <{0}.h>", context.name),
                     "Choose another name in the scene (key `name`) or with --name."});
  }
}

}  // namespace treeline::c
