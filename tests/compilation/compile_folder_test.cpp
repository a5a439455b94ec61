#include "compilation/compile_folder.hpp"

#include "check/fixture.hpp"
#include "compilation/run_commands.hpp"
#include "own_environment.hpp"

// Faults between a folder of sources and a loaded library must be reported. Would catch: a stale
// folder that passes, a compiler's message that is lost, and sizes read from the wrong column.

namespace treeline::tests {
namespace {

/// A folder with planar3r's gravity and Jacobian that a test may damage.
class FolderTest : public testing::Test {
 protected:
  FolderTest() : subjects_(load("planar3r")), options_(quick_options(10)) {
    subjects_.scene.functions = {Function::jacobian, Function::gravity};
    subjects_.generation = generate(subjects_.robot, subjects_.scene);
    options_.folder = temporary_.path() / "generated";
    write_folder(options_.folder, subjects_.generation);
  }

  void replace(const std::string& file, const std::string& from, const std::string& to) {
    std::string text = read_file(options_.folder / file);
    const auto at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    write_file(options_.folder / file, text.replace(at, from.size(), to));
  }

  std::optional<CheckReport> run() {
    return check(subjects_.robot, subjects_.scene, subjects_.generation, options_, diagnostics_);
  }

  void expect_error(const std::string& words) {
    EXPECT_FALSE(run());
    ASSERT_FALSE(diagnostics_.list().empty());
    const std::string text = to_string(diagnostics_.list().front());
    EXPECT_NE(text.find(words), std::string::npos) << text;
    EXPECT_FALSE(diagnostics_.list().front().remedy.empty());
  }

  Subjects subjects_;
  CheckOptions options_;
  TemporaryFolder temporary_;
  Diagnostics diagnostics_;
};

TEST_F(FolderTest, UpToDatePasses) {
  const auto report = run();
  ASSERT_TRUE(report);
  EXPECT_TRUE(report->passed()) << print_text(*report);
}

// Correct figures from a file that differs from what would be generated now.
TEST_F(FolderTest, StaleFileIsNamed) {
  replace("gravity.cpp", "// gravity", "// Gravity");
  const auto report = run();
  ASSERT_TRUE(report);
  ASSERT_EQ(report->stale.size(), 1U);
  EXPECT_EQ(report->stale.front().name, "gravity.cpp");
  EXPECT_FALSE(report->passed());
  for (const FunctionReport& function : report->functions) EXPECT_TRUE(function.passed());
  EXPECT_NE(print_text(*report).find("gravity.cpp: stale"), std::string::npos);
}

// The fault is in a header that check includes, not in a function's source.
TEST_F(FolderTest, FaultInSineIsSeen) {
  replace("sin_cos.hpp", "kS1 = -0x1.5555555555548p-3", "kS1 = -0x1.5555555555748p-3");
  const auto report = run();
  ASSERT_TRUE(report);
  EXPECT_GT(report->functions[0].bits_differ, 0);
}

TEST_F(FolderTest, WriteBeyondAnOutputIsSeen) {
  replace("gravity.cpp", "g[0] =", "(&g[0])[3] = 1.0; g[0] =");
  const auto report = run();
  ASSERT_TRUE(report);
  EXPECT_GT(report->functions[1].out_of_bounds, 0);
  EXPECT_FALSE(report->functions[1].passed());
}

TEST_F(FolderTest, MissingFolder) {
  options_.folder = temporary_.path() / "nowhere";
  expect_error("there is no such file");
}

TEST_F(FolderTest, MissingSource) {
  std::filesystem::remove(options_.folder / "gravity.cpp");
  expect_error("gravity.cpp");
}

TEST_F(FolderTest, CompileErrorSaysWhere) {
  replace("gravity.cpp", "g[0] =", "g[0] = nonsense *");
  expect_error("nonsense");
}

TEST_F(FolderTest, OtherShapeDoesNotCompile) {
  replace("planar3r.hpp", "Real (&g)[3]", "Real (&g)[4]");
  expect_error("does not compile");
}

TEST_F(FolderTest, FunctionWithoutBodyDoesNotLoad) {
  write_file(options_.folder / "gravity.cpp", "#include \"planar3r.hpp\"\n");
  expect_error("gravity");
}

TEST_F(FolderTest, OtherRealDoesNotLoad) {
  Scene single = subjects_.scene;
  single.real = Real::float32;
  write_folder(options_.folder, generate(subjects_.robot, single));
  expect_error("another Real");
}

TEST_F(FolderTest, FastMathIsRefused) {
  options_.compile.flags = "-O2 -ffast-math";
  expect_error("order of its operations");
}

TEST_F(FolderTest, UnknownFlagIsTheCompilersError) {
  options_.compile.flags = "-fno-such-flag-at-all";
  expect_error("no-such-flag-at-all");
}

TEST_F(FolderTest, NoCompiler) {
  test::OwnEnvironment environment;
  environment.set("CXX", "/no/such/compiler");
  expect_error("/no/such/compiler");
}

/// A folder of the same functions in C.
class CFolderTest : public FolderTest {
 protected:
  CFolderTest() {
    subjects_.scene.language = Language::c;
    subjects_.generation = generate(subjects_.robot, subjects_.scene);
    options_.folder = temporary_.path() / "generated_in_c";
    write_folder(options_.folder, subjects_.generation);
  }
};

TEST_F(CFolderTest, UpToDatePasses) {
  const auto report = run();
  ASSERT_TRUE(report);
  EXPECT_TRUE(report->passed()) << print_text(*report);
  EXPECT_NE(report->compile_command.find("-std=c99"), std::string::npos);
}

TEST_F(CFolderTest, FaultInSineIsSeen) {
  for (int of_angles : {1, 4, 8}) {  // taken together
    SCOPED_TRACE(of_angles);
    replace("sin_cos.h", "kS1 = -0x1.5555555555548p-3", "kS1 = -0x1.5555555555748p-3");
  }
  const auto report = run();
  ASSERT_TRUE(report);
  EXPECT_GT(report->functions[0].bits_differ, 0);
}

TEST_F(CFolderTest, WriteBeyondAnOutputIsSeen) {
  replace("gravity.c", "g[0] =", "g[3] = 1.0; g[0] =");
  const auto report = run();
  ASSERT_TRUE(report);
  EXPECT_GT(report->functions[1].out_of_bounds, 0);
}

// Would catch: C++ output that is taken for C because it has a header for C.
TEST_F(CFolderTest, IsNotOfCpp) {
  options_.folder = temporary_.path() / "generated";
  expect_error("its code is C++");
  std::filesystem::remove(options_.folder / "planar3r.hpp");
  std::filesystem::remove(options_.folder / "planar3r.h");
  diagnostics_ = {};
  expect_error("planar3r.h");
}

// Would catch: code in C that is compiled by another vendor's compiler than the user named.
TEST(CompilerOfC, StandsBesideThatOfCpp) {
  EXPECT_EQ(c_compiler_beside("/usr/bin/clang++-14"), "/usr/bin/clang-14");
  EXPECT_EQ(c_compiler_beside("ccache arm-none-eabi-g++"), "ccache arm-none-eabi-gcc");
  EXPECT_EQ(c_compiler_beside("c++"), "cc");
  EXPECT_EQ(c_compiler_beside("icpx"), "");
}

TEST(CodeBytes, AreThoseOfTextSymbols) {
  EXPECT_EQ(add_code_bytes("0000000000000000 r .LC0\n"
                           "0000000000000008 0000000000000010 R kTable\n"
                           "0000000000000000 00000000000000ff T _ZN1a1fEv\n"
                           "0000000000000000 0000000000000001 W _ZN1a1gEv\n"),
            256);
  EXPECT_FALSE(add_code_bytes(""));
}

TEST(ConstantBytes, OfWhatIsOnlyRead) {
  EXPECT_EQ(
      add_constant_bytes("gravity.o  :\nsection       size   addr\n.text          511      0\n"
                         ".data            8      0\n.rodata.cst8    48      0\n"
                         ".data.rel.ro    16      0\n.rodata          3      0\nTotal 586\n"),
      67);
  EXPECT_EQ(add_constant_bytes("section size addr\n.text 5 0\n"), 0);
  EXPECT_FALSE(add_constant_bytes(""));
}

TEST(StackBytes, OfBothCompilersForms) {
  EXPECT_EQ(add_stack_bytes("sin_cos.hpp:305:13:void detail::sin_cos(int)\t168\tstatic\n"
                            "a.cpp:16:6:void a::f(const Real (&)[24])\t3136\tstatic\n"),
            3304);
  EXPECT_EQ(add_stack_bytes("gravity.cpp:16:_ZN10gravity\t1224\tstatic\n"), 1224);
  EXPECT_FALSE(add_stack_bytes(""));
}

TEST(Commands, TellHowTheyEnded) {
  const TemporaryFolder folder;
  const auto outcomes = run_commands({{"sh", "-c", "echo out; echo err >&2; exit 3"},
                                      {"no-such-program"},
                                      {"sh", "-c", "kill $$"}},
                                     2, folder.path());
  EXPECT_EQ(outcomes[0].exit_code, 3);
  EXPECT_EQ(outcomes[0].output, "out\nerr\n");
  EXPECT_GT(outcomes[0].peak_kib, 0);
  EXPECT_FALSE(outcomes[1].started);
  EXPECT_TRUE(outcomes[2].started);
  EXPECT_EQ(outcomes[2].exit_code, -1);
}

}  // namespace
}  // namespace treeline::tests
