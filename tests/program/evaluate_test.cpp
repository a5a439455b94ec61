#include "program/evaluate.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <random>

// Would catch: a simplification that changes a value, an operation that is evaluated wrongly, and
// inputs that are bound to the wrong elements.
namespace treeline {
namespace {

using Wide = boost::multiprecision::cpp_bin_float_50;

/// A random formula of three values, the same for every Scalar and equal seeds. Small integer
/// constants and repeated operands make the rules of the constructors apply often.
template <class Scalar>
std::vector<Scalar> random_formulas(std::vector<Scalar> values, unsigned seed) {
  using std::cos;
  using std::sin;
  std::mt19937 random(seed);
  const auto pick = [&](unsigned bound) { return random() % bound; };
  for (int i = 0; i < 40; ++i) {
    const std::size_t index = pick(static_cast<unsigned>(values.size()));
    const bool constant = pick(4) == 0;
    const int number = static_cast<int>(pick(5)) - 2;
    const std::size_t other = pick(static_cast<unsigned>(values.size()));
    const Scalar a = values[index];
    const Scalar b = constant ? Scalar(static_cast<double>(number)) : values[other];
    switch (pick(6)) {
      case 0:
        values.push_back(a + b);
        break;
      case 1:
        values.push_back(a - b);
        break;
      case 2:
        values.push_back(sin(a) * b);
        break;
      case 3:
        values.push_back(cos(a) - sin(b));
        break;
      case 4:
        values.push_back(a / (Scalar(3.0) + cos(b)));
        break;
      default:
        values.push_back(Scalar(-0.5) * a);
        break;
    }
  }
  return values;
}

/// The simplified graph in 50 digits equals the formulas computed directly in 50 digits. Constants
/// are folded in double (sin 2, 1/3.5...), so they agree up to about 1e-16 times the growth of the
/// formulas. A wrong rule causes far more than the permitted 1e-10.
TEST(Evaluate, SimplificationKeepsValues) {
  for (unsigned seed = 1; seed <= 300; ++seed) {
    Program program;
    program.name = "formulas";
    program.arguments = {{"x", 3, 1, ""}};
    {
      const Graph::Scope scope(program.graph);
      std::vector<Expression> inputs;
      for (int i = 0; i < 3; ++i) {
        inputs.push_back(program.graph.input("x[" + std::to_string(i) + "]"));
      }
      const std::vector<Expression> values = random_formulas(inputs, seed);
      program.results = {{{"y", static_cast<int>(values.size()), 1, ""}, values}};
    }
    const std::vector<Wide> x = {Wide(0.7), Wide(-1.3), Wide(0.4)};
    const std::vector<Wide> expected = random_formulas(x, seed);
    const std::vector<Wide> actual = evaluate<Wide>(program, {x})[0];
    ASSERT_EQ(actual.size(), expected.size());
    for (std::size_t i = 0; i < actual.size(); ++i) {
      const Wide scale = 1 + abs(expected[i]);
      ASSERT_LT(abs(actual[i] - expected[i]) / scale, Wide(1e-10))
          << "seed " << seed << " at " << i;
    }
  }
}

TEST(Evaluate, BindsInputsByName) {
  Program program;
  program.arguments = {{"q", 2, 1, ""}, {"A", 2, 2, ""}};
  {
    const Graph::Scope scope(program.graph);
    const Expression a = program.graph.input("A[3]");
    const Expression q = program.graph.input("q[1]");
    program.results = {{{"y", 2, 1, ""}, {a - q, -(a * q)}}};
  }
  const auto y = evaluate<double>(program, {{1, 2}, {3, 4, 5, 6}})[0];
  EXPECT_EQ(y[0], 4);
  EXPECT_EQ(y[1], -12);
}

TEST(Evaluate, RejectsInputsOutsideTheArguments) {
  for (const char* name : {"q[2]", "r[0]", "q", "q[x]", "q[1"}) {
    Program program;
    program.arguments = {{"q", 2, 1, ""}};
    program.graph.input(name);
    EXPECT_THROW(locate_inputs(program), std::logic_error) << name;
  }
}

TEST(Evaluate, RoundsConstantsToTheScalar) {
  Program program;
  program.arguments = {{"q", 1, 1, ""}};
  {
    const Graph::Scope scope(program.graph);
    program.results = {{{"y", 1, 1, ""}, {0.1 * program.graph.input("q[0]")}}};
  }
  EXPECT_EQ(evaluate<float>(program, {{1.0F}})[0][0], 0.1F);
}

}  // namespace
}  // namespace treeline
