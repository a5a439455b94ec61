#include "emission/print_body.hpp"

#include <gtest/gtest.h>

#include <array>

#include "emission/cpp/print_files.hpp"
#include "passes/two_link_arm.hpp"

// Would catch: any change of the appearance or wording of generated code.
namespace treeline {
namespace {

TEST(PrintBody, ReadsLikeCodeWrittenByHand) {
  Program program;
  const Graph::Scope scope(program.graph);
  const auto q = test::input_vector("q", 2);
  program.graph.begin_section({1, "upper_arm", "pose"});
  const Expression s1 = sin(q[0]);
  const Expression c1 = cos(q[0]);
  program.graph.name(s1, "s1");
  program.graph.name(c1, "c1");
  program.graph.begin_section({2, "forearm", "pose"});
  const Expression w = s1 * (q[1] - 0.5) + c1;
  program.graph.name(w, "w2_x");
  program.results = {{{"y", 3, 1, ""}, {w * (c1 * 2), -(w - q[1]), 0}}};
  EXPECT_EQ(print_body(program, cpp::make_syntax(false), {}),
            "  y[2] = 0.0;\n"
            "\n"
            "  // sines and cosines; link 2 (forearm), pose\n"
            "  const Real angles[1] = {q[0]};\n"
            "  Real sines[1];\n"
            "  Real cosines[1];\n"
            "  detail::sin_cos(angles, sines, cosines);\n"
            "  const Real s1 = sines[0];\n"
            "  const Real c1 = cosines[0];\n"
            "  const Real w2_x = s1 * (q[1] - 0.5) + c1;\n"
            "  y[0] = w2_x * (2.0 * c1);\n"
            "  y[1] = -(w2_x - q[1]);\n");
}

TEST(PrintBody, KeepsTheGraphsOrderOfOperations) {
  Program program;
  const Graph::Scope scope(program.graph);
  const auto x = test::input_vector("x", 4);
  program.results = {{{"y", 6, 1, ""},
                      {(x[0] + x[1]) + x[2], x[0] + (x[1] + x[2]), x[0] - (x[1] - x[2]),
                       x[0] * (x[1] * x[3]), x[0] / (x[1] / x[3]), (x[0] / x[2]) / x[3]}}};
  EXPECT_EQ(print_body(program, cpp::make_syntax(false), {}),
            "  y[0] = x[0] + x[1] + x[2];\n"
            "  y[1] = x[0] + (x[1] + x[2]);\n"
            "  y[2] = x[0] - (x[1] - x[2]);\n"
            "  y[3] = x[0] * (x[1] * x[3]);\n"
            "  y[4] = x[0] / (x[1] / x[3]);\n"
            "  y[5] = x[0] / x[2] / x[3];\n");
}

/// Two lanes: a product that only the sum reads is part of its statement; a product with another
/// use or a name is not.
TEST(PrintBody, LanesAreWrittenInStatementsOfSeveralOperations) {
  Program program;
  const Graph::Scope scope(program.graph);
  const auto x = test::input_vector("x", 6);
  std::array<Expression, 2> product, named, difference;
  const std::size_t first_pack = program.graph.nodes().size();
  for (std::size_t limb = 0; limb < 2; ++limb) {
    product[limb] = x[limb] * x[4];
    named[limb] = (product[limb] + x[limb + 2]) * x[5];
    program.graph.name(named[limb], limb == 0 ? "w1_x" : "w2_x");
    difference[limb] = x[limb + 2] - (x[4] - named[limb]);
  }
  const std::size_t count = (program.graph.nodes().size() - first_pack) / 2;
  for (std::size_t i = first_pack; i < first_pack + count; ++i) {
    program.packs.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(i + count)});
  }
  program.results = {{{"y", 3, 1, ""}, {difference[0], difference[1], product[0]}}};
  EXPECT_EQ(print_body(program, cpp::make_syntax(false), {}),
            "  const Lanes<2> t1_lanes = detail::make_pack<Real>(x[0], x[1]) * x[4];\n"
            "  y[2] = t1_lanes[0];\n"
            "  const Lanes<2> w1_2_x_lanes = (t1_lanes + detail::make_pack<Real>(x[2], x[3])) * "
            "x[5];\n"
            "  const Lanes<2> y_0_1_lanes = detail::make_pack<Real>(x[2], x[3]) - (x[4] - "
            "w1_2_x_lanes);\n"
            "  y[0] = y_0_1_lanes[0];\n"
            "  y[1] = y_0_1_lanes[1];\n");
}

TEST(PrintBody, LinesStayWithinTheWidth) {
  Program program;
  const Graph::Scope scope(program.graph);
  const auto x = test::input_vector("a_rather_long_name_of_an_input", 6);
  program.results = {{{"y", 1, 1, ""}, {x[0] * x[1] + x[2] * x[3] + x[4] * x[5]}}};
  const std::string body = print_body(program, cpp::make_syntax(true), {});
  std::size_t begin = 0;
  for (std::size_t end = 0; (end = body.find('\n', begin)) != std::string::npos; begin = end + 1) {
    EXPECT_LE(end - begin, 100u);
  }
}

}  // namespace
}  // namespace treeline
