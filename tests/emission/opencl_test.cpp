// Code in OpenCL C. Would catch: an include or a type that it does not have, a product and a sum
// that may be fused, a kernel that works on states which are not there, and what a scene asks for
// and is left out in silence. `reproducibility` runs the kernels and compares their bits.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "emission/backend.hpp"
#include "emission/controller_unit.hpp"
#include "emission/emit.hpp"
#include "emission/ground_unit.hpp"
#include "emission/sample.hpp"
#include "emission/selftest_facts.hpp"

namespace treeline {
namespace {

std::vector<GeneratedFile> emit_for_device(bool single_precision) {
  Diagnostics diagnostics;
  const EmissionContext context = test::sample_context("arm", single_precision, Language::opencl);
  std::vector<Program> programs = test::sample_programs();
  for (Program& program : programs) program.packs.clear();
  auto files = emit(context, programs, diagnostics);
  EXPECT_TRUE(diagnostics.list().empty());
  return files;
}

std::string text_of_file(const std::vector<GeneratedFile>& files, const std::string& name) {
  const auto file = std::find_if(files.begin(), files.end(),
                                 [&](const GeneratedFile& each) { return each.name == name; });
  return file == files.end() ? "" : file->text;
}

TEST(OpenCl, FolderHasNoProjectAndNoHeaderOfC) {
  std::vector<std::string> names;
  for (const GeneratedFile& file : emit_for_device(false)) {
    names.push_back(file.name);
    EXPECT_EQ(file.text.find("#include <"), std::string::npos) << file.name;
    EXPECT_EQ(file.text.find("int32_t"), std::string::npos) << file.name;
    EXPECT_EQ(file.text.find("int64_t"), std::string::npos) << file.name;
  }
  EXPECT_EQ(names,
            (std::vector<std::string>{"arm.cl", "arm.h", "arm_joints.h", "corner_cases.cl", "id.cl",
                                      "inverse_dynamics.cl", "manifest.json", "sin_cos.h"}));
}

TEST(OpenCl, ContractKeepsProductsAndSumsApart) {
  const std::string in_double = text_of_file(emit_for_device(false), "arm.h");
  EXPECT_NE(in_double.find("#pragma OPENCL FP_CONTRACT OFF\n"), std::string::npos);
  EXPECT_NE(in_double.find("#pragma OPENCL EXTENSION cl_khr_fp64 : enable\n"), std::string::npos);
  EXPECT_NE(in_double.find("//   -cl-std=CL1.2 -I FOLDER\n"), std::string::npos);
  const std::string in_float = text_of_file(emit_for_device(true), "arm.h");
  EXPECT_NE(in_float.find("#pragma OPENCL FP_CONTRACT OFF\n"), std::string::npos);
  EXPECT_EQ(in_float.find("cl_khr_fp64"), std::string::npos);
  EXPECT_NE(in_float.find("//   -cl-std=CL1.2 -cl-fp32-correctly-rounded-divide-sqrt "),
            std::string::npos);
}

TEST(OpenCl, KernelTakesOneStatePerWorkItem) {
  const std::string source = text_of_file(emit_for_device(true), "inverse_dynamics.cl");
  const std::string kernel = source.substr(source.find("/// arm_inverse_dynamics of `count`"));
  EXPECT_EQ(kernel, R"(/// arm_inverse_dynamics of `count` states, one per work item.
__kernel void arm_inverse_dynamics_kernel(
    const ulong count,
    __global const float* restrict q_states,
    __global const float* restrict qd_states,
    __global const float* restrict qdd_states,
    __global float* restrict tau_states) {
  const size_t k = get_global_id(0);
  if (k < count) {
    float q[2];
    float qd[2];
    float qdd[2];
    float tau[2];
    for (uint i = 0; i < 2; ++i) {
      q[i] = q_states[(i * count) + k];
    }
    for (uint i = 0; i < 2; ++i) {
      qd[i] = qd_states[(i * count) + k];
    }
    for (uint i = 0; i < 2; ++i) {
      qdd[i] = qdd_states[(i * count) + k];
    }
    arm_inverse_dynamics(q, qd, qdd, tau);
    for (uint i = 0; i < 2; ++i) {
      tau_states[(i * count) + k] = tau[i];
    }
  }
}
)");
}

/// A wish of the scene, and the key by which it is refused.
struct Wish {
  const char* key;
  std::function<void(EmissionContext&)> ask;
};

TEST(OpenCl, RefusesByNameWhatItDoesNotHave) {
  const std::vector<Wish> wishes = {
      {"lanes", [](EmissionContext& each) { each.lanes = 4; }},
      {"batch", [](EmissionContext& each) { each.batch = 4; }},
      {"optimize", [](EmissionContext& each) { each.optimize = Optimize::size; }},
      {"profile", [](EmissionContext& each) { each.misra = true; }},
      {"target", [](EmissionContext& each) { each.target = "cortex-m7"; }},
      {"damped", [](EmissionContext& each) { each.effective_mass_limits = {1}; }},
      {"limits", [](EmissionContext& each) { each.limits.emplace(); }},
      {"controller",
       [](EmissionContext& each) { each.controller = std::make_shared<ControllerUnit>(); }},
      {"ground", [](EmissionContext& each) { each.ground = std::make_shared<GroundUnit>(); }},
      {"selftest",
       [](EmissionContext& each) { each.selftest = std::make_shared<SelftestFacts>(); }},
      {"name", [](EmissionContext& each) { each.name = "math"; }}};
  for (const Wish& wish : wishes) {
    SCOPED_TRACE(wish.key);
    EmissionContext context = test::sample_context("arm", false, Language::opencl);
    Diagnostics diagnostics;
    backend_of(Language::opencl).refuse(context, diagnostics);
    EXPECT_TRUE(diagnostics.list().empty());
    wish.ask(context);
    backend_of(Language::opencl).refuse(context, diagnostics);
    ASSERT_EQ(diagnostics.list().size(), 1U);
    EXPECT_EQ(diagnostics.list().front().element, wish.key);
    EXPECT_FALSE(diagnostics.list().front().remedy.empty());
  }
}

}  // namespace
}  // namespace treeline
