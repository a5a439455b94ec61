#include <gtest/gtest.h>
#include <tinyxml2.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "package_fixture.hpp"

// Would catch: a package that does another thing than its scene asks for, and does not say so.
namespace treeline {
namespace {

using test::kArm, test::PackageTest;

// Would catch: a package for Python that drops in silence what the scene asks for, or whose
// manifest names a command that makes something else. What pip makes of it: tests/packaging.
TEST_F(PackageTest, PythonSaysWhatItLeavesOut) {
  EXPECT_EQ(generate("--package python --language c++").exit_code, 1);
  EXPECT_EQ(generate("--package python").err.find("Python"), std::string::npos);
  write("scene.yaml",
        "name: arm\nlanguage: c++\nbatch: 4\nselftest: 1\ncontroller: {laws: joint_impedance}\n"
        "functions: [gravity, inverse_dynamics]\n");
  const auto made =
      test::run_program(root_, "generate " + kArm + " scene.yaml --output python --package python");
  ASSERT_EQ(made.exit_code, 0) << made.err;
  for (const char* says : {"language: a package for Python is compiled from C",
                           "batch: Python does not call", "selftest: Python does not call"}) {
    EXPECT_NE(made.err.find(says), std::string::npos) << says << "\n" << made.err;
  }
  EXPECT_EQ(made.err.find("controller: "), std::string::npos) << made.err;  // it calls that
  EXPECT_NE(read("python/README.md").find("Python does not call the functions of several states"),
            std::string::npos);
  const auto manifest = nlohmann::json::parse(read("python/src/manifest.json"));
  EXPECT_EQ(manifest["language"], "c");
  EXPECT_EQ(manifest["command"],
            "treeline generate puma560.urdf scene.yaml --output arm --package python");
  EXPECT_NE(read("python/pyproject.toml")
                .find("+" + manifest["digest"].get<std::string>().substr(0, 12) + "\""),
            std::string::npos);
}

// Would catch: a project or notes for a compiler that does not know OpenCL C.
TEST_F(PackageTest, OfOpenClThereIsNone) {
  for (const char* kind : {"cmake", "platformio", "arduino", "python"}) {
    const auto refused = generate(std::string("--language opencl --package ") + kind);
    EXPECT_EQ(refused.exit_code, 1) << kind;
    EXPECT_NE(refused.err.find("--package: packages are compiled, and OpenCL C is by the driver"),
              std::string::npos)
        << refused.err;
  }
  for (const char* option : {"--safety SAFETY.md", "--tune"}) {
    const auto refused = generate(std::string("--language opencl ") + option);
    EXPECT_EQ(refused.exit_code, 1) << option;
    EXPECT_NE(refused.err.find("this is for C++ and C, not for OpenCL C"), std::string::npos)
        << refused.err;
  }
}

// Would catch: a package that calls its first function where there is none.
TEST_F(PackageTest, IsRefusedWithoutAFunctionThatItCalls) {
  std::ofstream(root_ / "alone.yaml") << "{functions: [], controller: {laws: [joint_impedance]}}";
  for (const char* kind : {"rust", "wasm", "arduino"}) {
    const auto refused =
        test::run_program(root_, "generate " + kArm + " alone.yaml --output out --package " + kind);
    EXPECT_EQ(refused.exit_code, 1) << kind << "\n" << refused.err;
    EXPECT_NE(refused.err.find("calls functions, and the scene has none"), std::string::npos)
        << refused.err;
  }
}

// Would catch: one fault told twice, and faults of a package that there cannot be in any case.
TEST_F(PackageTest, OneFaultIsToldOnce) {
  std::ofstream(root_ / "alone.yaml") << "{functions: [], controller: {laws: [joint_impedance]}}";
  for (const char* options : {"firmware --target cortex-m4f", "firmware --language opencl",
                              "rust --language opencl", "arduino --language opencl"}) {
    const auto refused = test::run_program(
        root_, "generate " + kArm + " alone.yaml --warnings none --package " + options);
    EXPECT_EQ(refused.exit_code, 1) << options;
    const std::size_t first = refused.err.find("error: ");
    EXPECT_NE(first, std::string::npos) << options;
    EXPECT_EQ(refused.err.find("error: ", first + 1), std::string::npos) << refused.err;
  }
}

// Would catch: a unit of FMI that moves otherwise than its scene says, or whose manifest names a
// command that makes something else. What CMake makes of it and FMPy runs: tests/packaging.
TEST_F(PackageTest, FmuRefusesWhatItCannotMove) {
  std::string kind = "fmu3";
  const auto made = [&](const std::string& scene, const std::string& options = "") {
    write("scene.yaml", "name: arm\n" + scene);
    return test::run_program(
        root_, "generate " + kArm + " scene.yaml --output unit --package " + kind + " " + options);
  };
  EXPECT_EQ(made("functions: [gravity]").exit_code, 1);
  EXPECT_NE(made("controller: {laws: joint_impedance}").err.find("without --package fmu3."),
            std::string::npos);
  const auto third = nlohmann::json::parse(read("unit/src/manifest.json"));
  EXPECT_EQ(third["command"],
            "treeline generate puma560.urdf scene.yaml --output arm --package fmu3");
  EXPECT_NE(read("unit/modelDescription.xml")
                .find("instantiationToken=\"" + third["digest"].get<std::string>() + "\""),
            std::string::npos);
  const std::string alone = "functions: []\ncontroller: {laws: joint_impedance}\n";
  EXPECT_EQ(made(alone).exit_code, 0);
  EXPECT_EQ(read("unit/modelDescription.xml").find("ModelExchange"), std::string::npos);
  EXPECT_NE(made(alone + "inputs: [gravity]").err.find("error: inputs: an FMU has its model fixed"),
            std::string::npos);
  EXPECT_NE(made(alone + "external_forces: [{name: push, link: link6}]")
                .err.find("error: external_forces: an FMU of a controller"),
            std::string::npos);
  kind = "fmu";
  EXPECT_EQ(made("").exit_code, 0);
  const auto manifest = nlohmann::json::parse(read("unit/src/manifest.json"));
  EXPECT_EQ(manifest["command"],
            "treeline generate puma560.urdf scene.yaml --output arm --package fmu");
  tinyxml2::XMLDocument document;
  ASSERT_EQ(document.Parse(read("unit/modelDescription.xml").c_str()), tinyxml2::XML_SUCCESS);
  EXPECT_STREQ(document.FirstChildElement("fmiModelDescription")->Attribute("guid"),
               manifest["digest"].get<std::string>().c_str());
  const std::vector<std::pair<std::string, std::string>> refused = {
      {"functions: [gravity]", "error: functions: an FMU integrates forward_dynamics"},
      {"sin_cos: given", "error: sin_cos: an FMU computes"},
      {"inputs: [gravity]", "error: inputs: an FMU has its model fixed"},
      {"constraints: [{name: hold, between: [link6, world], rows: [x]}]",
       "error: constraints: an FMU"},
      {"joint_friction: {model: viscous, implicit: true, joints: {joint1: {damping: 1}}}",
       "error: joint_friction: implicit friction"}};
  for (const auto& [scene, says] : refused) {
    const auto outcome = made(scene);
    EXPECT_EQ(outcome.exit_code, 1) << scene;
    EXPECT_NE(outcome.err.find(says), std::string::npos) << scene << "\n" << outcome.err;
  }
  EXPECT_EQ(made("", "--language c++").exit_code, 1);
  EXPECT_NE(made("language: c++").err.find("an FMU is compiled from C"), std::string::npos);
}

// Would catch: a plugin of ros2_control that drives otherwise than its scene says, and one that is
// named by what ROS does not take. What CMake makes of it: tests/packaging/ros2_control.
TEST_F(PackageTest, Ros2ControlRefusesWhatItCannotDrive) {
  const auto made = [&](const std::string& scene) {
    write("scene.yaml", "name: Arm\n" + scene);
    return test::run_program(
        root_, "generate " + kArm + " scene.yaml --output plugin --package ros2_control");
  };
  const std::string law = "controller: {laws: joint_impedance}\n";
  EXPECT_EQ(made(law + "functions: []").exit_code, 0);
  EXPECT_NE(read("plugin/package.xml").find("<name>arm_controller</name>"), std::string::npos);
  EXPECT_EQ(read("plugin/law.hpp").find("pose"), std::string::npos);
  EXPECT_NE(read("plugin/law.hpp").find("#include \"Arm_controller.h\""), std::string::npos);
  EXPECT_EQ(made("functions: [gravity]").exit_code, 0);
  const std::vector<std::pair<std::string, std::string>> refused = {
      {"functions: [mass_matrix]", "error: functions: without a controller the law is gravity"},
      {"functions: [gravity]\nsin_cos: given", "error: sin_cos: the law computes"},
      {"functions: [gravity]\ninputs: [gravity]", "error: inputs: ros2_control has no"},
      {"functions: [gravity]\nbase: floating", "error: base: no motor moves a floating base"},
      {law + "external_forces: [{name: push, link: link6}]",
       "error: external_forces: ros2_control"},
      {"operational_points: [{name: tool, link: link6}]\ncontroller: {laws: force}",
       "error: controller.laws: a package for ros2_control reads no sensor"}};
  for (const auto& [scene, says] : refused) {
    const auto outcome = made(scene);
    EXPECT_EQ(outcome.exit_code, 1) << scene;
    EXPECT_NE(outcome.err.find(says), std::string::npos) << scene << "\n" << outcome.err;
  }
}

}  // namespace
}  // namespace treeline
