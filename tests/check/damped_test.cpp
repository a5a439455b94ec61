#include <algorithm>
#include <string>

#include "choice/evaluate_damped.hpp"
#include "fixture.hpp"

// damped_control_torque is checked like other functions: compiled and compared with 50 digits,
// mainly near singularities. Would catch: a law that differs from that of damped_solve.hpp, a check
// that leaves out the states that matter, bounds so wide that faults pass, and a header that is not
// read.

namespace treeline::tests {
namespace {

const FunctionReport& damped_of(const CheckReport& report) {
  const auto found = std::find_if(
      report.functions.begin(), report.functions.end(),
      [](const FunctionReport& function) { return function.name == "damped_control_torque"; });
  if (found == report.functions.end()) throw std::runtime_error("damped is not checked");
  return *found;
}

/// The robot with only the functions that the law needs.
Subjects load_damped(const std::string& name) {
  Subjects made = load(name);
  made.scene.functions = {kDampedFunctions.begin(), kDampedFunctions.end()};
  made.generation = generate(made.robot, made.scene);
  return made;
}

/// A random robot whose scene asks for damping and for the functions that it needs.
Subjects draw_damped(std::uint64_t seed, RandomOptions options, Real real, Sines sines) {
  options.mimic = seed % 2 == 0 ? 0.3 : 0;
  options.external_forces = static_cast<int>(seed % 3);
  RandomMechanism drawn = random_mechanism(seed, options);
  Subjects made{drawn.robot, drawn.scene, {}};
  made.scene.real = real;
  made.scene.sin_cos = sines;
  made.scene.damped = EffectiveMassLimit{20, 0.5};
  made.scene.functions = {kDampedFunctions.begin(), kDampedFunctions.end()};
  made.generation = generate(made.robot, made.scene);
  return made;
}

// No state is left out. A quarter of the states are near singularities, for which the law is made.
TEST(CheckDamped, Ur10eThroughItsSingularities) {
  const Subjects subjects = load_damped("ur10e");
  const CheckOptions options = quick_options(100);
  const auto report = check_or_throw(subjects, options);
  EXPECT_TRUE(report.passed()) << print_text(report);
  const FunctionReport& damped = damped_of(report);
  EXPECT_EQ(damped.singular, 0);
  EXPECT_TRUE(damped.bits_known);
  EXPECT_GT(digits_left(report, damped.worst.error), 13.5);
  int relaxed = 0, singular = 0;
  for (const StateReference& reference :
       make_references(subjects.robot, subjects.scene, subjects.generation, options.references)) {
    const double least_eigenvalue = reference.functions.back().high.back();
    relaxed += least_eigenvalue < 1 ? 1 : 0;
    singular += least_eigenvalue < 1e-6 ? 1 : 0;
  }
  EXPECT_GT(relaxed, 30);
  EXPECT_GT(singular, 20);
  EXPECT_NE(print_text(report).find("damped_control_torque"), std::string::npos);
  EXPECT_NE(print_json(report).find("Lambda^-1 + Delta"), std::string::npos);
}

TEST(CheckDamped, RandomRobots) {
  for (std::uint64_t seed = 71; seed <= 76; ++seed) {
    RandomOptions options;
    options.joints = 5;
    options.floating_base = seed % 2 == 0;
    options.all_rows = seed % 3 == 0;
    const Subjects subjects =
        draw_damped(seed, options, seed % 4 == 1 ? Real::float32 : Real::float64,
                    seed == 72 ? Sines::given : Sines::computed);
    const auto report = check_or_throw(subjects, quick_options(60));
    EXPECT_TRUE(report.passed()) << "seed " << seed << "\n" << print_text(report);
    EXPECT_EQ(damped_of(report).singular, 0) << "seed " << seed;
  }
}

// Code for safety has loops of its own, without templates and bits of numbers.
TEST(CheckDamped, InCodeForSafety) {
  for (const Language language : {Language::cpp, Language::c}) {
    Subjects subjects = load("ur10e");
    subjects.scene.profile = Profile::misra;
    subjects.scene.language = language;
    subjects.scene.lanes = 1;
    subjects.scene.functions = {kDampedFunctions.begin(), kDampedFunctions.end()};
    subjects.generation = generate(subjects.robot, subjects.scene);
    const auto report = check_or_throw(subjects, quick_options(60));
    EXPECT_TRUE(report.passed()) << print_text(report);
    EXPECT_EQ(damped_of(report).bits_differ, 0);
  }
}

// Four rows with three joints: Lambda^-1 has no inverse in any state, and the law is checked in all
// of them.
TEST(CheckDamped, WhereNoStateHasLambda) {
  Subjects subjects = load("planar3r");
  ScenePoint elbow = subjects.scene.operational_points.front();
  elbow.name = "elbow";
  elbow.link = "link2";
  subjects.scene.operational_points.push_back(elbow);
  subjects.scene.damped = EffectiveMassLimit{10, 1};
  subjects.scene.functions = {kDampedFunctions.begin(), kDampedFunctions.end()};
  subjects.generation = generate(subjects.robot, subjects.scene);
  const auto report = check_or_throw(subjects, quick_options(60));
  EXPECT_TRUE(report.passed()) << print_text(report);
  EXPECT_EQ(damped_of(report).singular, 0);
}

struct Fault {
  const char* file;
  const char* from;
  const char* to;
  bool beyond_bound;  ///< else only the bits tell
};

// Faults in the headers of which the function consists. The bound detects all of them except those
// in rounding.
TEST(CheckDamped, FaultsInItsHeadersAreSeen) {
  const Subjects subjects = load_damped("ur10e");
  const TemporaryFolder temporary;
  CheckOptions options = quick_options(60);
  options.folder = temporary.path() / "ur10e";
  const auto references =
      make_references(subjects.robot, subjects.scene, subjects.generation, options.references);
  for (const Fault& fault : {
           Fault{"ur10e_damped.hpp", "{200.0, ", "{200.00001, ", true},
           Fault{"ur10e_damped.hpp", "qdd_0, tau);", "xdd_cmd, tau);", true},
           Fault{"damped_solve.hpp", "border * lack * lack * lack", "border * lack * lack", true},
           Fault{"damped_solve.hpp", "F[row] -= J[", "F[row] += J[", true},
           Fault{"damped_solve.hpp", "return least;", "return most;", true},
           Fault{"damped_sizes.hpp", "kSweeps = 20", "kSweeps = 5", true},
           Fault{"ldlt.hpp", "entry -= A[(i", "entry += A[(i", true},
           Fault{"square_root.hpp", "_DOUBLE(root, x);",
                 "_DOUBLE(root, x); root += root * 0x1p-52;", false},
       }) {
    write_folder(options.folder, subjects.generation);
    std::string text = read_file(options.folder / fault.file);
    const auto at = text.find(fault.from);
    ASSERT_NE(at, std::string::npos) << fault.from;
    write_file(options.folder / fault.file,
               text.replace(at, std::string(fault.from).size(), fault.to));
    Diagnostics diagnostics;
    const auto report =
        check(subjects.scene, subjects.generation, references, options, diagnostics);
    ASSERT_TRUE(report) << fault.to;
    const FunctionReport& damped = damped_of(*report);
    EXPECT_GT(damped.bits_differ, 0) << fault.to;
    EXPECT_EQ(damped.beyond_bound > 0, fault.beyond_bound) << fault.to;
    EXPECT_FALSE(damped.passed()) << fault.to;
  }
}

TEST(CheckDamped, MissingHeaderIsAnError) {
  const Subjects subjects = load("ur10e");
  const TemporaryFolder temporary;
  CheckOptions options = quick_options(2);
  options.folder = temporary.path() / "ur10e";
  write_folder(options.folder, subjects.generation);
  std::filesystem::remove(options.folder / "ur10e_damped.hpp");
  Diagnostics diagnostics;
  EXPECT_FALSE(check(subjects.robot, subjects.scene, subjects.generation, options, diagnostics));
  EXPECT_TRUE(diagnostics.has_errors());
}

// More rows than are supported: the report says that the bits are unknown, not that they differ.
TEST(CheckDamped, ManyRowsHaveNoKnownBits) {
  DampedInputs inputs;
  inputs.mass_limits.assign(37, 1);
  inputs.tau.assign(1, 0);
  EXPECT_TRUE(evaluate_damped(Real::float64, inputs).empty());
}

}  // namespace
}  // namespace treeline::tests
