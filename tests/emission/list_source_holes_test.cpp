#include "emission/list_source_holes.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "emission/sample.hpp"
#include "program/link_loops.hpp"

// Would catch: loops that `prefetch` does not load, since they are in no section of the function's,
// and straight lines that take the code of all that they call along.
namespace treeline {
namespace {

std::string section_of(const Program& program, Language language, bool prefetch) {
  EmissionContext context = test::sample_context("arm", false, language);
  context.prefetch = prefetch;
  return list_source_holes(context, program, program.name, "void f()").at("section");
}

TEST(ListSourceHoles, LoopsAreInTheFunctionsSection) {
  Program program = test::safe_programs().front();
  for (const Language language : {Language::cpp, Language::c}) {
    const std::string lines = section_of(program, language, true);
    EXPECT_NE(lines.find("section(\"treeline_arm_" + program.name + "\")"), std::string::npos);
    EXPECT_EQ(lines.find("flatten"), std::string::npos) << lines;
  }
  program.loops = std::make_shared<const LinkLoops>();
  for (const Language language : {Language::cpp, Language::c}) {
    EXPECT_NE(section_of(program, language, true).find(", flatten"), std::string::npos);
    EXPECT_EQ(section_of(program, language, false), "");
  }
}

}  // namespace
}  // namespace treeline
