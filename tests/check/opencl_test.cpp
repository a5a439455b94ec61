// `check` of code in OpenCL C, by whatever device there is. Would catch: a kernel that is not run,
// or is compared with itself. Skipped where no OpenCL driver is.
#include "fixture.hpp"
#include "opencl_device.hpp"

namespace treeline::tests {
namespace {

class OpenClCheck : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_opencl()) GTEST_SKIP() << "skipped: there is no OpenCL driver";
    puma_ = load_unmade("puma560", "scene.yaml");
    puma_.scene.language = Language::opencl;
    puma_.scene.lanes = 1;
    puma_.scene.functions = {Function::inverse_dynamics, Function::forward_dynamics};
    puma_.generation = generate(puma_.robot, puma_.scene);
    options_.folder = temporary_.path() / "puma560";
    write_folder(options_.folder, puma_.generation);
  }

  void change(const std::string& file, const std::string& from, const std::string& to) {
    std::string text = read_file(options_.folder / file);
    const std::size_t at = text.rfind(from);
    ASSERT_NE(at, std::string::npos) << file;
    write_file(options_.folder / file, text.replace(at, from.size(), to));
  }

  Subjects puma_;
  TemporaryFolder temporary_;
  CheckOptions options_ = quick_options(40);
};

TEST_F(OpenClCheck, PassesWhatIsEmitted) {
  EXPECT_TRUE(check_or_throw(puma_, options_).passed());
}

TEST_F(OpenClCheck, FindsAFaultOfTheFunction) {
  change("inverse_dynamics.cl", "tau[5] = ", "tau[5] = 1e-9 + ");
  EXPECT_FALSE(check_or_throw(puma_, options_).passed());
}

// Of the kernel alone: the states of other work items stand one beside the other.
TEST_F(OpenClCheck, FindsAnElementOfAnotherState) {
  change("inverse_dynamics.cl", "qd_states[(i * count) + k]", "qd_states[(i * count)]");
  EXPECT_FALSE(check_or_throw(puma_, options_).passed());
}

TEST_F(OpenClCheck, FindsThatAKernelIsMissing) {
  change("inverse_dynamics.cl", "puma560_inverse_dynamics_kernel", "puma560_other_kernel");
  EXPECT_FALSE(check_or_throw(puma_, options_).passed());
}

TEST_F(OpenClCheck, TellsWhatTheDriverSays) {
  change("inverse_dynamics.cl", "tau[5] = ", "no_such_name = ");
  Diagnostics diagnostics;
  EXPECT_FALSE(check(puma_.robot, puma_.scene, puma_.generation, options_, diagnostics));
  ASSERT_FALSE(diagnostics.list().empty());
  EXPECT_NE(diagnostics.list().front().fault.find("no_such_name"), std::string::npos)
      << diagnostics.list().front().fault;
}

}  // namespace
}  // namespace treeline::tests
