// The step of an emitted controller in `check`. Would catch: a controller that is passed without
// being compiled, run or compared; dynamics, laws, limits, faults and brakes that are not those of
// the laws; motions that stay in one mode or never meet a fault; and figures that are not told.
#include <nlohmann/json.hpp>

#include "emission/controller_faults.hpp"
#include "fixture.hpp"

namespace treeline::tests {
namespace {

namespace fs = std::filesystem;

Subjects load_arm(const std::string& robot, const std::string& scene_file,
                  Real real = Real::float64) {
  Diagnostics diagnostics;
  const auto urdf = read_urdf(
      std::string(TREELINE_ROBOTS_DIR) + "/" + robot + "/" + robot + ".urdf", diagnostics);
  auto scene =
      read_scene(std::string(TREELINE_CONTROLLER_DIR) + "/" + scene_file, *urdf, diagnostics);
  if (!scene) throw std::runtime_error(scene_file + " cannot be read");
  scene->functions = {Function::gravity};
  scene->real = real;
  return {*urdf, *scene, generate(*urdf, *scene)};
}

const Subjects& puma() {
  static const Subjects made = load_arm("puma560", "puma.yaml");
  return made;
}

TEST(CheckStep, RunsAndComparesEveryLaw) {
  const CheckReport report = check_or_throw(puma(), quick_options(20));
  EXPECT_TRUE(report.passed()) << print_text(report);
  ASSERT_TRUE(report.step);
  EXPECT_GT(report.step->compared, 200);
  EXPECT_LT(report.step->ties, report.step->compared / 20);
  for (const int steps : report.step->modes) EXPECT_GT(steps, 50);
  for (const std::uint32_t fault :
       {kFaultMeasurement, kFaultSpeed, kFaultEmergency, kFaultJump, kFaultConfig}) {
    EXPECT_NE(report.step->faults & fault, 0U) << fault;
  }
  EXPECT_GE(report.step->refused, 4 * report.step->motions);
  EXPECT_GT(report.step->code_bytes.value_or(0), 1000);
  EXPECT_GT(report.step->stack_bytes.value_or(0), 100);
  const std::string text = print_text(report);
  EXPECT_NE(text.find("\n  puma_arm_step "), std::string::npos) << text;
  EXPECT_NE(text.find("mode idle "), std::string::npos) << text;
  const auto json = nlohmann::json::parse(print_json(report));
  EXPECT_EQ(json.at("step").at("name"), "puma_arm_step");
  EXPECT_EQ(json.at("step").at("passed"), true);
  EXPECT_GT(json.at("step").at("modes").at("faulted"), 0);
}

TEST(CheckStep, PassesCodeByRulesForSafeCode) {
  Subjects subjects = puma();
  subjects.scene.profile = Profile::misra;
  subjects.scene.lanes = 1;
  subjects.generation = generate(subjects.robot, subjects.scene);
  const CheckReport report = check_or_throw(subjects, quick_options(20));
  EXPECT_TRUE(report.passed()) << print_text(report);
}

TEST(CheckStep, PassesFloatsLocalAxesAndPayloads) {
  Subjects subjects = load_arm("samm", "samm.yaml", Real::float32);
  for (const Language language : {Language::cpp, Language::c}) {
    subjects.scene.language = language;
    subjects.generation = generate(subjects.robot, subjects.scene);
    const CheckReport report = check_or_throw(subjects, quick_options(20));
    EXPECT_TRUE(report.passed()) << print_text(report);
  }
}

// Would catch besides: a controller alone that has no functions, and one that cannot do without.
TEST(CheckStep, PassesAControllerAloneInC) {
  Subjects subjects = puma();
  subjects.scene.language = Language::c;
  subjects.scene.functions = {};
  subjects.generation = generate(subjects.robot, subjects.scene);
  const CheckReport report = check_or_throw(subjects, quick_options(20));
  EXPECT_TRUE(report.passed()) << print_text(report);
  EXPECT_TRUE(report.functions.empty());
}

struct Change {
  const char* what;
  const char* file;
  const char* old_text;
  const char* new_text;
};

void change(const Change& change, std::string& text) {
  const std::size_t at = text.find(change.old_text);
  ASSERT_NE(at, std::string::npos) << change.file << " has changed: name another place";
  text.replace(at, std::string(change.old_text).size(), change.new_text);
}

void expect_seen(const Subjects& subjects, const CheckOptions& options) {
  const CheckReport report = check_or_throw(subjects, options);
  ASSERT_TRUE(report.step);
  EXPECT_FALSE(report.step->passed()) << print_text(report);
}

class ChangedStep : public ::testing::TestWithParam<Change> {};

// In code that is compiled, not in the laws of the reference.
TEST_P(ChangedStep, IsSeen) {
  Diagnostics diagnostics;
  const auto folder = make_temporary_folder(diagnostics);
  ASSERT_TRUE(folder);
  const fs::path code = folder->path() / "puma_arm";
  write_folder(code, puma().generation);
  std::string text = read_file(code / GetParam().file);
  change(GetParam(), text);
  write_file(code / GetParam().file, text);
  CheckOptions options = quick_options(20);
  options.folder = code;
  expect_seen(puma(), options);
}

class SharedFault : public ::testing::TestWithParam<Change> {};

// In the reference too, as a fault of the laws themselves: then only the rules see it.
TEST_P(SharedFault, IsSeen) {
  Subjects subjects = puma();
  for (auto* files : {&subjects.generation.files, &subjects.generation.laws}) {
    for (GeneratedFile& file : *files) {
      if (file.name == GetParam().file) change(GetParam(), file.text);
    }
  }
  expect_seen(subjects, quick_options(20));
}

const Change kChanges[] = {
    {"Dynamics", "controller_robot.hpp",
     "controller_joint_torque(at->q, at->sin_q, at->cos_q, at->qd,",
     "controller_joint_torque(at->q, at->cos_q, at->sin_q, at->qd,"},
    {"Gravity", "controller_step.hpp", "within(sound,", "within(1.000001 * sound,"},
    {"JointGain", "controller_laws.hpp", "qdd[i] += w *", "qdd[i] += 1.000001 * w *"},
    {"TaskGain", "controller_laws.hpp", "xdd[i] = wanted.acceleration[i] +",
     "xdd[i] = 0.999999 * wanted.acceleration[i] +"}};

constexpr const char* kCall = "controller_step(config, state, input, output);";

const Change kShared[] = {
    {"LostFault", "controller.cpp", kCall,
     "controller_step(config, state, input, output);\n"
     "  state->faults &= ~1U;\n  output->faults &= ~1U;"},
    {"Brakes", "controller.cpp", kCall,
     "controller_step(config, state, input, output);\n  output->brakes = 0;"},
    {"Limit", "controller.cpp", kCall,
     "controller_step(config, state, input, output);\n  output->tau[1] *= 9;"},
    {"NaN", "controller.cpp", kCall,
     "controller_step(config, state, input, output);\n"
     "  if (state->brakes != 0) output->tau[1] /= 0 * output->tau[1];"}};

std::string name_of(const ::testing::TestParamInfo<Change>& row) {
  return row.param.what;
}
INSTANTIATE_TEST_SUITE_P(Check, ChangedStep, ::testing::ValuesIn(kChanges), name_of);
INSTANTIATE_TEST_SUITE_P(Check, SharedFault, ::testing::ValuesIn(kShared), name_of);

}  // namespace
}  // namespace treeline::tests
