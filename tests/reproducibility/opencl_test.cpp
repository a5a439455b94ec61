// Kernels in OpenCL C against the same functions in C, to the bit. Would catch: a product and a sum
// that the driver fuses, a quotient or a sine of fewer digits, an element of another state, a
// kernel that does not compile. Skipped where no OpenCL driver is: Debian has pocl-opencl-icd.
#include <gtest/gtest.h>

#include <cctype>

#include "data/list_data.hpp"
#include "opencl_device.hpp"
#include "reproducibility/compare_languages.hpp"

namespace treeline::tests {
namespace {

const std::string kRobots = TREELINE_ROBOTS_DIR;
const Compilers kDevice{"gcc", "g++", Language::c, Language::opencl};

class OpenClBits : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_opencl()) GTEST_SKIP() << "skipped: there is no OpenCL driver";
  }
};

void expect_bits_of_c(const std::string& urdf, const std::string& scene,
                      const std::vector<Function>& functions, Real real, int states,
                      std::size_t at_least) {
  const auto rows = compare_languages_of(urdf, scene, functions, real, 1, kDevice, states);
  EXPECT_GE(rows.size(), at_least);
  for (const LanguageRow& row : rows) {
    EXPECT_EQ(row.bits_differ, 0) << row.robot << ' ' << row.function;
    EXPECT_GT(row.states, 0);
  }
}

// Quotients are in float where the option of clBuildProgram matters.
TEST_F(OpenClBits, PumaHasThoseOfC) {
  const std::string puma = kRobots + "/puma560/";
  for (const Real real : {Real::float64, Real::float32}) {
    expect_bits_of_c(puma + "puma560.urdf", puma + "scene.yaml", {}, real, 400, 11);
  }
}

class OpenClBitsOf : public OpenClBits, public testing::WithParamInterface<DataRobot> {};

TEST_P(OpenClBitsOf, PublishedRobot) {
  expect_bits_of_c(GetParam().path, "",
                   {Function::forward_dynamics, Function::inverse_dynamics, Function::mass_matrix},
                   Real::float32, 40, 3);
}

INSTANTIATE_TEST_SUITE_P(Robots, OpenClBitsOf, testing::ValuesIn(data_robots("published")),
                         [](const auto& robot) {
                           std::string name = robot.param.name;
                           for (char& c : name) {
                             if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
                           }
                           return name;
                         });

}  // namespace
}  // namespace treeline::tests
