#include "emission/misra/refuse.hpp"

#include <string>

namespace treeline::misra {

void refuse(const EmissionContext& context, Diagnostics& diagnostics) {
  if (!context.misra) return;
  const auto report = [&diagnostics](const char* key, const char* fault, const char* remedy) {
    diagnostics.add({Severity::error, "", 0, key, fault, remedy});
  };
  if (context.lanes > 1) {
    report("lanes", "lanes are vectors of the compiler, which `profile: misra` does not use",
           "Leave `lanes` out.");
  }
  if (context.batch > 0) {
    report("batch", "functions of several states are vectors, which `profile: misra` does not use",
           "Leave `batch` out.");
  }
}

}  // namespace treeline::misra
