#include <gtest/gtest.h>
#include <tinyxml2.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "package_fixture.hpp"

// Would catch: a package that names files which are not there, that its tool could not build, or
// that breaks when a robot's name has quotes in it. Tools that Debian does not have are played: the
// sources are compiled as they compile them.
namespace treeline {
namespace {

namespace fs = std::filesystem;
using test::kArm, test::PackageTest;

TEST_F(PackageTest, CMakeFindsAndLinksIt) {
  ASSERT_EQ(generate("--package cmake").exit_code, 0);
  fs::create_directories(root_ / "use");
  write("use/CMakeLists.txt",
        "cmake_minimum_required(VERSION 3.13)\nproject(use LANGUAGES CXX)\n"
        "find_package(arm REQUIRED)\nadd_executable(use main.cpp)\n"
        "target_link_libraries(use PRIVATE arm::arm)\n");
  write("use/main.cpp",
        "#include <arm.hpp>\nint main() {\n  double q[6] = {}, g[6];\n  arm::gravity(q, g);\n"
        "  return g[1] != 0 ? 0 : 1;\n}\n");
  const std::string compiler = " -DCMAKE_CXX_COMPILER=" + cxx_;
  EXPECT_TRUE(run("cmake -S lib -B build" + compiler +
                  " && cmake --build build && cmake --install build --prefix \"$PWD/prefix\""));
  EXPECT_TRUE(run("cmake -S use -B use/build -DCMAKE_PREFIX_PATH=\"$PWD/prefix\"" + compiler +
                  " && cmake --build use/build && use/build/use"));
}

// The functions of Zephyr's build, as far as a module calls them.
const char* const kZephyrApplication = R"(cmake_minimum_required(VERSION 3.20)
project(app LANGUAGES CXX)
function(zephyr_library_named name)
  add_library(${name} STATIC)
  set(library ${name} PARENT_SCOPE)
endfunction()
macro(zephyr_library_sources)
  target_sources(${library} PRIVATE ${ARGN})
endmacro()
macro(zephyr_include_directories)
  target_include_directories(${library} PUBLIC ${ARGN})
endmacro()
macro(zephyr_library_compile_options)
  target_compile_options(${library} PRIVATE ${ARGN})
endmacro()
set(CONFIG_TREELINE_ARM y)
add_subdirectory(lib/zephyr)
)";

TEST_F(PackageTest, ZephyrCompilesItsModule) {
  ASSERT_EQ(generate("--package zephyr --target cortex-m4f --real float").exit_code, 0);
  EXPECT_NE(read("lib/zephyr/module.yml").find("cmake: zephyr\n"), std::string::npos);
  EXPECT_NE(read("lib/zephyr/Kconfig").find("config TREELINE_ARM\n\tbool"), std::string::npos);
  EXPECT_NE(read("lib/zephyr/Kconfig").find("\tdepends on CPP\n"), std::string::npos);
  write("CMakeLists.txt", kZephyrApplication);
  EXPECT_TRUE(run("cmake -S . -B build -DCMAKE_CXX_COMPILER=" + cxx_ +
                  " && cmake --build build --verbose"));
  EXPECT_NE(read("log").find("-ffp-contract=off"), std::string::npos);
}

// Would catch: code in eight lanes for a core that has none, without a word.
TEST_F(PackageTest, SmallCoresWithoutATargetWarn) {
  constexpr const char* kSays = "target: none is named";
  for (const char* tool : {"platformio", "zephyr", "arduino", "cmsis"}) {
    const std::string package = std::string("--package ") + tool;
    EXPECT_NE(generate(package).err.find(kSays), std::string::npos) << tool;
    EXPECT_EQ(generate(package + " --target cortex-m7").err.find(kSays), std::string::npos) << tool;
    EXPECT_NE(generate(package + " --language c").err.find(kSays), std::string::npos) << tool;
  }
  EXPECT_EQ(generate("--package cmake").err.find(kSays), std::string::npos);
}

TEST_F(PackageTest, PlatformioHasItsManifest) {
  ASSERT_EQ(generate("--package platformio").exit_code, 0);
  const auto library = nlohmann::json::parse(read("lib/library.json"));
  EXPECT_EQ(library["name"], "arm");
  EXPECT_EQ(library["version"], TREELINE_PROJECT_VERSION);
  std::string flags;
  for (const auto& flag : library["build"]["flags"])
    flags.append(" ").append(flag.get<std::string>());
  const auto source = library["build"]["srcDir"].get<std::string>();
  const auto include = library["build"]["includeDir"].get<std::string>();
  EXPECT_TRUE(fs::exists(root_ / "lib" / include / library["headers"].get<std::string>()));
  EXPECT_TRUE(run("cd lib && for file in " + source + "/*.cpp; do " + cxx_ + flags + " -O1 -I" +
                  include + " -c $file -o /dev/null || exit 1; done"));
}

TEST_F(PackageTest, ArduinoBuildsLibraryAndExample) {
  ASSERT_EQ(generate("--package arduino --language c --real float").exit_code, 0);
  std::map<std::string, std::string> properties;
  std::istringstream lines(read("lib/library.properties"));
  for (std::string line; std::getline(lines, line);) {
    const auto equals = line.find('=');
    ASSERT_NE(equals, std::string::npos) << line;
    properties[line.substr(0, equals)] = line.substr(equals + 1);
  }
  for (const char* needed : {"name", "version", "author", "maintainer", "sentence", "paragraph",
                             "category", "url", "architectures", "includes"}) {
    EXPECT_FALSE(properties[needed].empty()) << needed;
  }
  EXPECT_EQ(properties["includes"], "arm.h");
  EXPECT_EQ(read("lib/keywords.txt"), "arm_inverse_dynamics\tKEYWORD2\narm_gravity\tKEYWORD2\n");
  write("Arduino.h",
        "struct Port {\n  void begin(long) {}\n  template <class T> void print(T) {}\n"
        "  template <class T> void println(T) {}\n};\nextern Port Serial;\n"
        "unsigned long micros();\nvoid delay(int);\n");
  EXPECT_TRUE(run("gcc -std=gnu11 -O1 -c lib/src/*.c && " + cxx_ +
                  " -std=gnu++11 -include Arduino.h -I lib/src -x c++ -c "
                  "lib/examples/arm_time/arm_time.ino -o /dev/null"));
}

TEST_F(PackageTest, CmsisPackListsItsFiles) {
  ASSERT_EQ(generate("--package cmsis").exit_code, 0);
  tinyxml2::XMLDocument document;
  ASSERT_EQ(document.LoadFile((root_ / "lib/Treeline.arm.pdsc").c_str()), tinyxml2::XML_SUCCESS);
  const auto* package = document.FirstChildElement("package");
  ASSERT_NE(package, nullptr);
  for (const char* needed : {"vendor", "name", "description", "releases", "components"}) {
    EXPECT_NE(package->FirstChildElement(needed), nullptr) << needed;
  }
  const auto* component = package->FirstChildElement("components")->FirstChildElement("component");
  int sources = 0;
  for (const auto* file = component->FirstChildElement("files")->FirstChildElement("file");
       file != nullptr; file = file->NextSiblingElement("file")) {
    EXPECT_TRUE(fs::exists(root_ / "lib" / file->Attribute("name"))) << file->Attribute("name");
    sources += file->Attribute("category") == std::string("source") ? 1 : 0;
  }
  EXPECT_EQ(sources, 3);  // two functions, the digest
}

// Would catch: sources of C that have the loops once each, or twice where a tool compiles them
// alone too.
TEST_F(PackageTest, LoopsOfCAreCompiledAsOneSource) {
  const std::string humanoid = std::string(TREELINE_ROBOTS) + "/humanoid24/humanoid24.urdf";
  const auto generate_with = [&](const std::string& tool) {
    return test::run_program(root_,
                             "generate " + humanoid +
                                 " --functions mass_matrix,inverse_dynamics,center_of_mass --name "
                                 "arm --optimize size --language c --output lib --package " +
                                 tool);
  };
  ASSERT_EQ(generate_with("zephyr").exit_code, 0);
  write(
      "CMakeLists.txt",
      std::string(kZephyrApplication).replace(std::string(kZephyrApplication).find("CXX"), 3, "C"));
  ASSERT_TRUE(run("cmake -S . -B build && cmake --build build && nm build/lib/zephyr/*.a"));
  std::string defined;
  std::istringstream lines(read("log"));
  for (std::string line; std::getline(lines, line);) {
    if (line.find(" T ") != line.npos) defined += line.substr(line.find(" T ") + 3) + " ";
    EXPECT_EQ(line.find("mass_matrix.c.o:"), line.npos) << line;
  }
  for (const char* function :
       {"arm_mass_matrix ", "arm_inverse_dynamics ", "arm_center_of_mass "}) {
    EXPECT_NE(defined.find(function), defined.npos) << function << defined;
  }

  ASSERT_EQ(generate_with("platformio").exit_code, 0);
  EXPECT_EQ(nlohmann::json::parse(read("lib/library.json"))["build"]["srcFilter"],
            nlohmann::json({"+<*>", "-<inverse_dynamics.c>", "-<mass_matrix.c>"}));
  EXPECT_TRUE(fs::exists(root_ / "lib/src/arm_loops.c"));

  fs::remove_all(root_ / "lib");
  ASSERT_EQ(generate_with("cmsis").exit_code, 0);
  const std::string pack = read("lib/Treeline.arm.pdsc");
  for (const char* file : {"<file category=\"source\" name=\"src/arm_loops.c\"/>",
                           "<file category=\"other\" name=\"src/mass_matrix.c\"/>",
                           "<file category=\"source\" name=\"src/center_of_mass.c\"/>"}) {
    EXPECT_NE(pack.find(file), pack.npos) << file;
  }

  fs::remove_all(root_ / "lib");
  ASSERT_EQ(generate_with("arduino").exit_code, 0);
  EXPECT_FALSE(fs::exists(root_ / "lib/src/arm_loops.c"));  // it would compile both
}

TEST_F(PackageTest, CompareKnowsThePackage) {
  EXPECT_EQ(generate("--package cmsis --compare").exit_code, 3);
  ASSERT_EQ(generate("--package cmsis").exit_code, 0);
  EXPECT_EQ(generate("--package cmsis --compare").exit_code, 0);
  write("lib/src/gravity.cpp", "");
  const auto changed = generate("--package cmsis --compare");
  EXPECT_EQ(changed.exit_code, 3);
  EXPECT_NE(changed.out.find("src/gravity.cpp: changed"), std::string::npos) << changed.out;
  EXPECT_EQ(generate("--package pip").exit_code, 2);
}

// A name that ends strings, tags and comments of XML, in which tinyxml2 takes two hyphens.
TEST_F(PackageTest, StrangeNamesBreakNoFile) {
  const std::string urdf = test::read_file(kArm);
  write("odd.urdf", std::string(urdf).replace(urdf.find("name=\"puma560\""), 14,
                                              "name=\"a &quot;&lt;/name&gt; --&gt; b=c\""));
  for (const char* package : {"platformio", "cmsis", "arduino", "fmu", "fmu3"}) {
    const auto outcome = test::run_program(
        root_, std::string("generate odd.urdf --functions forward_dynamics --name odd "
                           "--output ") +
                   package + " --package " + package);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  }
  EXPECT_FALSE(
      nlohmann::json::parse(read("platformio/library.json"), nullptr, false).is_discarded());
  tinyxml2::XMLDocument document;
  EXPECT_EQ(document.Parse(read("cmsis/Treeline.odd.pdsc").c_str()), tinyxml2::XML_SUCCESS);
  EXPECT_EQ(read("arduino/library.properties").find("<"), std::string::npos);
  for (const char* unit : {"fmu/modelDescription.xml", "fmu3/modelDescription.xml",
                           "fmu3/buildDescription.xml", "cmsis/Treeline.odd.pdsc"}) {
    const std::string text = read(unit);
    const std::size_t inside = text.find("<!--") + 4;
    EXPECT_EQ(text.find("--", inside), text.find("-->", inside)) << unit;
  }
}

// Names of joints that neither XML nor FMI takes as they are, and that differ in such bytes alone.
TEST_F(PackageTest, StrangeJointsAreVariables) {
  std::string urdf = test::read_file(kArm);
  const auto rename = [&](const std::string& from, const std::string& to) {
    const std::string quoted = "\"" + from + "\"";
    urdf.replace(urdf.find(quoted), quoted.size(), "\"" + to + "\"");
  };
  rename("joint1", "left/hip &lt;1&gt;");
  rename("joint2", "left/hip 'é%'");
  rename("joint3", "3");
  write("odd.urdf", urdf);
  const auto made = test::run_program(root_, "generate odd.urdf --output unit --package fmu");
  ASSERT_EQ(made.exit_code, 0) << made.err;
  tinyxml2::XMLDocument document;
  ASSERT_EQ(document.Parse(read("unit/modelDescription.xml").c_str()), tinyxml2::XML_SUCCESS);
  const auto* variable = document.FirstChildElement("fmiModelDescription")
                             ->FirstChildElement("ModelVariables")
                             ->FirstChildElement();
  for (const char* name :
       {"'left/hip %3C1%3E'.q", "'left/hip %27%C3%A9%25%27'.q", "'3'.q", "joint4.q"}) {
    EXPECT_STREQ(variable->Attribute("name"), name);
    variable = variable->NextSiblingElement();
  }
}

}  // namespace
}  // namespace treeline
