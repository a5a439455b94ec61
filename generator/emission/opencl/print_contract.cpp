#include "emission/c/print_files.hpp"
#include "emission/c_family_syntax.hpp"
#include "emission/descriptions.hpp"
#include "emission/emitted_text.hpp"
#include "emission/opencl/print_files.hpp"
#include "emission/opencl/templates.hpp"

namespace treeline::opencl {
namespace {

/// Asks for numbers of double, which devices need not have.
constexpr const char* kExtension =
    "#if !defined(cl_khr_fp64)\n"
    "#error \"this device does not compute in double: write `real: float` in the scene\"\n"
    "#endif\n"
    "#pragma OPENCL EXTENSION cl_khr_fp64 : enable\n";

}  // namespace

std::string print_contract(const EmissionContext& context, std::span<const Program> programs) {
  const bool single = context.single_precision;
  auto values = describe_contract(context);
  for (const char* const of_host : {"digits", "format", "id_size", "target"}) values.erase(of_host);
  values.insert(
      {{"NAME", name_in_capitals(context)},
       {"needs", single ? "" : " with cl_khr_fp64"},
       {"options", kBuildOptions + (single ? std::string(" ") + kBuildOptionsOfFloat : "")},
       {"exact", single ? "round to nearest, keep subnormal numbers and divide correctly:\n"
                          "// CL_DEVICE_SINGLE_FP_CONFIG has CL_FP_ROUND_TO_NEAREST, CL_FP_DENORM "
                          "and\n// CL_FP_CORRECTLY_ROUNDED_DIVIDE_SQRT"
                        : "have double, which is IEC 60559 in OpenCL"},
       {"extension", single ? "" : kExtension},
       {"declarations", c::print_declarations(context, programs)}});
  return fill_template(templates::kContract, values);
}

}  // namespace treeline::opencl
