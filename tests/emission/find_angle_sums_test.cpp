#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "emission/body_steps.hpp"
#include "passes/two_link_arm.hpp"
#include "program/evaluate.hpp"

namespace treeline {
namespace {

struct Angles {
  explicit Angles(Program& program, int first_link = 1, std::size_t count = 4)
      : q(test::input_vector("q", static_cast<int>(count))) {
    for (std::size_t i = 0; i < count; ++i) {
      s.push_back(sin(q[i]));
      c.push_back(cos(q[i]));
      const std::string link = std::to_string(first_link + static_cast<int>(i));
      program.graph.name(s.back(), "s" + link);
      program.graph.name(c.back(), "c" + link);
    }
  }
  std::vector<Expression> q, s, c;
};

std::string name_of(const Program& program, Expression value) {
  const std::string name = find_angle_sums(program)[value.node()];
  return (value.negative() && !name.empty() ? "-" : "") + name;
}

// Would catch: sums of angles with neutral names, and with a wrong sign in their name.
TEST(FindAngleSums, NamesThemAsRoboticistsDo) {
  Program program;
  const Graph::Scope scope(program.graph);
  const Angles a(program);
  const Expression s23 = a.s[1] * a.c[2] + a.c[1] * a.s[2];
  const Expression c23 = a.c[1] * a.c[2] - a.s[1] * a.s[2];
  const Expression s234 = a.c[3] * s23 + c23 * a.s[3];
  const Expression difference = a.s[1] * a.c[0] - a.c[1] * a.s[0];  // sin(q2 - q1)
  const Expression plus = a.c[0] * a.c[1] + a.s[0] * a.s[1];
  const Expression none = a.s[1] * a.c[2] + a.c[1] * a.s[3];
  const Expression twice = a.s[1] * a.c[1] + a.c[1] * a.s[1];
  EXPECT_EQ(name_of(program, s23), "s23");
  EXPECT_EQ(name_of(program, c23), "c23");
  EXPECT_EQ(name_of(program, s234), "s234");
  EXPECT_EQ(name_of(program, difference), "minus_s1_minus_2");
  EXPECT_EQ(name_of(program, plus), "c1_minus_2");
  EXPECT_EQ(name_of(program, none), "");
  EXPECT_EQ(name_of(program, twice), "");
}

TEST(FindAngleSums, KeepsLinksOfTwoDigitsApart) {
  Program program;
  const Graph::Scope scope(program.graph);
  const Angles a(program, 9);
  EXPECT_EQ(name_of(program, a.s[0] * a.c[1] + a.c[0] * a.s[1]), "s9_plus_10");
}

/// The value that a name claims: `minus_c1_minus_2` of the angles.
double claimed_value(std::string name, const std::vector<double>& angles) {
  const double sign = name.starts_with("minus_") ? -1 : 1;
  if (sign < 0) name = name.substr(6);
  const char function = name[0];
  double sum = 0, next = 1;
  for (std::size_t at = 1; at < name.size();) {
    if (name.compare(at, 7, "_minus_") == 0) {
      next = -1;
      at += 7;
    } else if (name.compare(at, 6, "_plus_") == 0) {
      next = 1;
      at += 6;
    } else {
      sum += next * angles[static_cast<std::size_t>(name[at++] - '1')];
    }
  }
  return sign * (function == 's' ? std::sin(sum) : std::cos(sum));
}

/// Sums and differences of all pairs of products of these.
std::vector<Expression> combine(const std::vector<Expression>& turns) {
  std::vector<Expression> products, sums;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) products.push_back(turns[i] * turns[j]);
  }
  for (const Expression& x : products) {
    for (const Expression& y : products) {
      sums.push_back(x + y);
      sums.push_back(x - y);
    }
  }
  return sums;
}

// Would catch: a name that claims another value than the statement computes, for all signs and
// orders of operands. Each of at most three levels adds three roundings of numbers up to 1.
TEST(FindAngleSums, NamesClaimWhatIsComputed) {
  Program program;
  program.graph = Graph::for_trace(1);  // x y and y x are two nodes
  const Graph::Scope scope(program.graph);
  const Angles a(program);
  std::vector<Expression> turns = {a.s[0], a.c[0], a.s[1], a.c[1]};
  for (const std::size_t joint : {2, 3}) {
    std::set<std::uint32_t> seen;
    const std::vector<Expression> sums = combine(turns);
    const auto names = find_angle_sums(program);
    turns = {a.s[joint], a.c[joint]};
    for (const Expression& sum : sums) {
      if (!names[sum.node()].empty() && seen.insert(sum.node()).second) turns.push_back(sum);
      if (turns.size() == 10) break;  // no more than the last level can combine
    }
    ASSERT_GE(turns.size(), 6u);
  }
  combine(turns);
  const auto names = find_angle_sums(program);
  std::vector<Expression> named;
  std::vector<std::string> claims;
  for (std::uint32_t i = 0; i < names.size(); ++i) {
    if (names[i].empty()) continue;
    named.push_back({i, false});
    claims.push_back(names[i]);
  }
  ASSERT_GE(named.size(), 100u);
  program.arguments = {{"q", 4, 1, ""}};
  program.results = {{{"y", static_cast<int>(named.size()), 1, ""}, named}};
  const std::vector<double> angles = {0.3, -1.1, 2.2, 0.7};
  const auto values = evaluate<double>(program, {angles});
  const double most = 9 * std::numeric_limits<double>::epsilon();
  for (std::size_t i = 0; i < named.size(); ++i) {
    EXPECT_NEAR(values[0][i], claimed_value(claims[i], angles), most) << claims[i];
  }
}

}  // namespace
}  // namespace treeline
