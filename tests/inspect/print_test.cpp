// Would catch: output that programs cannot read, columns that do not line up, sections that vanish.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "inspect/align_columns.hpp"
#include "sample.hpp"

namespace treeline {
namespace {

TEST(AlignColumns, LinesUpAndLeavesOutEmptyOnes) {
  EXPECT_EQ(align_columns({{"name"}, {"kg", true}, {"empty"}, {"x"}},
                          {{"a", "1.25", "", "p"}, {"l\xC3\xA4nger", "3", "", ""}}),
            "  name      kg  x\n"
            "  a       1.25  p\n"
            "  l\xC3\xA4nger     3\n");
}

TEST(PrintText, HasEverySection) {
  const std::string text = print_text(inspect_sample());
  for (const char* part :
       {"two \"hands\" (sample.urdf)", "base     fixed, gravity 0 0 -9.81 m/s^2",
        "5 links, 3 moving joints, 2 coordinates, 2 velocities", "14 kg, of which 12 kg move",
        "\ntree\n", "    upper", "not physical", "joints, in the order of q", "rad/s", "N m",
        "= -0.5 * slide + 0.1", "inertias that are not physical", "what was reduced", "mass matrix",
        "condition    2.2222"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  }
}

TEST(PrintJson, CanBeReadBack) {
  const auto json = nlohmann::json::parse(print_json(inspect_sample()));
  EXPECT_EQ(json["robot"], "two \"hands\"");
  EXPECT_EQ(json["scene"], nullptr);
  EXPECT_EQ(json["links"].size(), 5U);
  EXPECT_EQ(json["links"][2]["lumped_with"], "upper");
  EXPECT_EQ(json["links"][1]["inertial"]["mass"], 3);
  EXPECT_EQ(json["joints"][0]["upper"], 2);
  EXPECT_EQ(json["joints"][1]["upper"], nullptr);
  EXPECT_EQ(json["mass_matrix"]["diagonal"].size(), 2U);
}

TEST(PrintDot, EscapesNamesAndMarksEdges) {
  const std::string dot = print_dot(inspect_sample());
  for (const char* part :
       {"digraph \"two \\\"hands\\\"\" {", "link1 [label=\"upper\\n3 kg\", color=red];",
        "link1 -> link2 [label=\"mount\\nfixed\", style=dashed];", "style=dotted",
        "link0 -> link1 [label=\"arm\\nrevolute\", style=solid];"}) {
    EXPECT_NE(dot.find(part), std::string::npos) << part << "\n" << dot;
  }
}

}  // namespace
}  // namespace treeline
