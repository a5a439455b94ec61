#include "program/print.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>

#include "program/format_literal.hpp"

namespace treeline {
namespace {

Program small_program() {
  Program program;
  program.name = "small";
  program.equation = "y = -2 sin(q) q";
  program.arguments = {{"q", 1, 1, ""}};
  const Graph::Scope scope(program.graph);
  const Expression q = program.graph.input("q[0]");
  program.graph.begin_section({1, "arm", "pose"});
  const Expression s = sin(q);
  program.graph.name(s, "s1");
  program.results = {{{"y", 1, 1, ""}, {-2 * s * q}}};
  return program;
}

// Would catch: a dump that loses operands, names, sections or signs.
TEST(Print, TextShowsEveryNode) {
  EXPECT_EQ(print_text(small_program()),
            "; small: y = -2 sin(q) q\n"
            "%0 = 0.0\n"
            "%1 = q[0]\n"
            "; link 1 (arm), pose\n"
            "%2 = sin %1  ; s1\n"
            "%3 = 2.0\n"
            "%4 = %3 * %2\n"
            "%5 = %4 * %1\n"
            "y[0] = -%5\n");
}

TEST(Print, DotHasAnEdgeForEveryOperand) {
  const std::string dot = print_dot(small_program());
  for (const char* edge : {"n1 -> n2;", "n3 -> n4;", "n2 -> n4;", "n1 -> n5;", "n4 -> n5;",
                           "n5 -> \"y[0]\" [label=\"-\"];", "sin\\ns1"}) {
    EXPECT_NE(dot.find(edge), std::string::npos) << edge << "\n" << dot;
  }
}

// Would catch: digits lost on the way into source text.
TEST(FormatLiteral, ReadsBackExactly) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> exponent(-300, 300);
  for (int i = 0; i < 10000; ++i) {
    const double value = std::pow(10.0, exponent(random));
    EXPECT_EQ(std::strtod(format_literal(value).c_str(), nullptr), value);
    const auto narrow = static_cast<float>(std::pow(10.0, exponent(random) / 10));
    EXPECT_EQ(std::strtof(format_literal(narrow).c_str(), nullptr), narrow);
  }
}

TEST(FormatLiteral, IsAlwaysAFloatingLiteral) {
  EXPECT_EQ(format_literal(2.0), "2.0");
  EXPECT_EQ(format_literal(0.1), "0.1");
  EXPECT_EQ(format_literal(1e-5), "1e-05");
  EXPECT_EQ(format_literal(1e30), "1e+30");
  EXPECT_EQ(format_literal(3.0F), "3.0f");
  EXPECT_EQ(format_literal(0.1F), "0.1f");
}

}  // namespace
}  // namespace treeline
