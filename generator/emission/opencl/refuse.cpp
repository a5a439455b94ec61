#include <string>

#include "emission/c/print_files.hpp"
#include "emission/controller_unit.hpp"
#include "emission/ground_unit.hpp"
#include "emission/opencl/print_files.hpp"
#include "emission/selftest_facts.hpp"

namespace treeline::opencl {
namespace {

/// What a scene may ask for, and why OpenCL C has it not.
struct Refusal {
  bool (*is_asked)(const EmissionContext& context);
  const char* key;
  const char* why;
};

constexpr Refusal kRefusals[] = {
    {[](const EmissionContext& each) { return each.lanes > 1; }, "lanes",
     "a work item computes one number at a time, and the device many work items"},
    {[](const EmissionContext& each) { return each.batch > 0; }, "batch",
     "every kernel takes as many states as it is given"},
    {[](const EmissionContext& each) { return each.optimize == Optimize::size; }, "optimize",
     "the loops of small code are not written for it"},
    {[](const EmissionContext& each) { return each.misra; }, "profile",
     "`misra` is about C and C++"},
    {[](const EmissionContext& each) { return each.target != "generic"; }, "target",
     "the driver compiles for its device"},
    {[](const EmissionContext& each) { return !each.effective_mass_limits.empty(); }, "damped",
     "laws that loop are not written for it"},
    {[](const EmissionContext& each) { return each.limits.has_value(); }, "limits",
     "laws that loop are not written for it"},
    {[](const EmissionContext& each) { return each.controller != nullptr; }, "controller",
     "a controller keeps its state from step to step"},
    {[](const EmissionContext& each) { return each.ground != nullptr; }, "ground",
     "steps on the ground loop over contacts"},
    {[](const EmissionContext& each) { return each.selftest != nullptr; }, "selftest",
     "a self-test runs where the program starts"}};

}  // namespace

void refuse(const EmissionContext& context, Diagnostics& diagnostics) {
  for (const Refusal& refusal : kRefusals) {
    if (!refusal.is_asked(context)) continue;
    diagnostics.add({Severity::error, "", 0, refusal.key,
                     std::string("OpenCL C does not have this: ") + refusal.why,
                     std::string("Leave `") + refusal.key + "` out, or take `language: c`."});
  }
  c::refuse_hidden_header(context, diagnostics);
}

}  // namespace treeline::opencl
