#include "program/expression.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

// Would catch: a rule of the constructors that is missing (an operation is emitted without need) or
// changes the value (a lost sign, a wrong merge).
namespace treeline {
namespace {

class ExpressionTest : public testing::Test {
 protected:
  /// Number of nodes that are operations.
  [[nodiscard]] int operations() const {
    int count = 0;
    for (const Node& node : graph_.nodes()) {
      count += operation(node.op).operands > 0 ? 1 : 0;
    }
    return count;
  }

  Graph graph_;
  Graph::Scope scope_{graph_};
  Expression x_ = graph_.input("x[0]");
  Expression y_ = graph_.input("x[1]");
  Expression z_ = graph_.input("x[2]");
};

TEST_F(ExpressionTest, ZerosAndOnesVanish) {
  EXPECT_EQ(x_ + 0, x_);
  EXPECT_EQ(0 + x_, x_);
  EXPECT_EQ(x_ - 0, x_);
  EXPECT_EQ(0 - x_, -x_);
  EXPECT_EQ(x_ * 0, Expression());
  EXPECT_EQ(x_ * 1, x_);
  EXPECT_EQ(-1 * x_, -x_);
  EXPECT_EQ(Expression(0) / x_, Expression());
  EXPECT_EQ(x_ / 1, x_);
  EXPECT_EQ(x_ / -1, -x_);
  EXPECT_EQ(operations(), 0);
}

TEST_F(ExpressionTest, ZeroHasNoSign) {
  EXPECT_EQ(Expression(-0.0), Expression());
  EXPECT_EQ(-Expression(), Expression());
  EXPECT_EQ(Expression(0, true), Expression());
  EXPECT_FALSE((x_ * -0.0).negative());
}

TEST_F(ExpressionTest, ConstantsFold) {
  EXPECT_EQ(Expression(2) + 3, Expression(5));
  EXPECT_EQ(Expression(2) - 3, Expression(-1));
  EXPECT_EQ(Expression(-2) * 3, Expression(-6));
  EXPECT_EQ(Expression(3) / -2, Expression(-1.5));
  EXPECT_EQ(sin(Expression(-0.5)), Expression(std::sin(-0.5)));
  EXPECT_EQ(cos(Expression()), Expression(1));
  EXPECT_EQ(operations(), 0);
}

TEST_F(ExpressionTest, EqualNodesAreOneNodeWhateverTheirSigns) {
  EXPECT_EQ(x_ + y_, y_ + x_);
  EXPECT_EQ(x_ * y_, y_ * x_);
  EXPECT_EQ(x_ - y_, -(y_ - x_));
  EXPECT_EQ(-x_ + y_, y_ - x_);
  EXPECT_EQ(-x_ - y_, -(x_ + y_));
  EXPECT_EQ(-x_ * y_, -(x_ * y_));
  EXPECT_EQ(-x_ * -y_, x_ * y_);
  EXPECT_EQ(-x_ / y_, x_ / -y_);
  EXPECT_EQ(sin(-x_), -sin(x_));
  EXPECT_EQ(cos(-x_), cos(x_));
  EXPECT_EQ(operations(), 6);  // + * - / sin cos
}

TEST_F(ExpressionTest, OperandsCarryNoSignAndComeFirst) {
  const Expression value = -x_ * (y_ - z_ * -3) / (-y_ - x_) + sin(-x_ + z_);
  EXPECT_NE(value.node(), 0u);
  for (std::uint32_t i = 0; i < graph_.nodes().size(); ++i) {
    const Node& node = graph_.nodes()[i];
    EXPECT_FALSE(std::signbit(node.value));
    if (operation(node.op).operands > 0) {
      EXPECT_LT(node.a, i);
      EXPECT_LT(node.b, i);
    }
  }
}

TEST_F(ExpressionTest, MultiplesMerge) {
  EXPECT_EQ(x_ - x_, Expression());
  EXPECT_EQ(x_ + x_, 2 * x_);
  EXPECT_EQ(2 * (3 * x_), 6 * x_);
  EXPECT_EQ(2 * x_ + 3 * x_, 5 * x_);
  EXPECT_EQ(3 * x_ - 2 * x_, x_);
  EXPECT_EQ(0.5 * (2 * x_), x_);
  EXPECT_EQ(x_ * 4, x_ / 0.25);
  EXPECT_EQ(2 * (3 / x_), 6 / x_);
}

TEST_F(ExpressionTest, SumsMergeWhereItIsFree) {
  EXPECT_EQ((x_ + 2) + 3, x_ + 5);
  EXPECT_EQ((x_ - 2) + 2, x_);
  EXPECT_EQ((x_ + y_) - y_, x_);
  EXPECT_EQ(x_ - (x_ + y_), -y_);
  EXPECT_EQ((x_ + 2 * y_) - y_, x_ + y_);
  EXPECT_EQ((x_ + y_) + (z_ - y_), x_ + z_);
}

TEST_F(ExpressionTest, QuotientsCancel) {
  EXPECT_EQ(x_ / x_, Expression(1));
  EXPECT_EQ(2 * x_ / x_, Expression(2));
  EXPECT_EQ(x_ * y_ / y_, x_);
  EXPECT_EQ(x_ / y_ * -y_, -x_);
  EXPECT_EQ(6 / (2 * x_), 3 / x_);
  EXPECT_EQ(6 / (2 / x_), 3 * x_);
  EXPECT_EQ(1 / (x_ / y_), y_ / x_);
}

TEST_F(ExpressionTest, SquaresOfSineAndCosineSumToOne) {
  const Expression s = sin(x_);
  const Expression c = cos(x_);
  EXPECT_EQ(s * s + c * c, Expression(1));
  EXPECT_EQ(-3 * (c * c) - 3 * (s * s), Expression(-3));
  EXPECT_NE(sin(y_) * sin(y_) + c * c, Expression(1));
  EXPECT_NE(c * c - s * s, Expression(1));
}

TEST_F(ExpressionTest, DivisionByStructuralZeroStaysVisible) {
  const Expression fault = x_ / Expression();
  EXPECT_EQ(graph_.nodes()[fault.node()].op, Op::div);
  EXPECT_EQ(graph_.nodes()[fault.node()].b, 0u);
}

TEST_F(ExpressionTest, InputsByNameAreOne) {
  EXPECT_EQ(graph_.input("x[1]"), y_);
}

TEST_F(ExpressionTest, NamesTellTheSign) {
  graph_.name(x_ * y_, "product");
  graph_.name(x_ * y_, "late");
  graph_.name(-x_ * z_, "w");
  graph_.name(2, "two");
  EXPECT_EQ(graph_.names().size(), 2u);
  EXPECT_EQ(graph_.names().of((x_ * y_).node()), "product");
  EXPECT_EQ(graph_.names().of((x_ * z_).node()), "minus_w");
}

Expression limb_constant_of(std::uint32_t slot, std::uint32_t limb, double value) {
  return {Graph::current().intern(make_limb_constant({slot, limb, 2}, value)), false};
}

TEST_F(ExpressionTest, LimbConstantsDoNotVanish) {
  for (const double value : {0.0, 1.0, -1.0}) {
    const Expression c = limb_constant_of(1, 0, value);
    EXPECT_EQ(graph_.nodes()[(c * x_).node()].op, Op::mul);
    EXPECT_EQ(graph_.nodes()[(x_ + c).node()].op, Op::add);
    EXPECT_NE(x_ + c * y_, x_);
  }
}

/// Operations on constants of a limb give constants of that limb, with corresponding slots.
TEST_F(ExpressionTest, LimbConstantsFoldAlikeInAllLimbs) {
  const auto fold = [](std::uint32_t limb, double a, double b) {
    const Expression p = limb_constant_of(1, limb, a);
    const Expression r = limb_constant_of(2, limb, b);
    return std::vector<Expression>{p * r, r * p, p + r, r - p, p - 3, 2 / r, p * (r * 4), p + p};
  };
  const auto left = fold(0, 2, 5);
  const auto right = fold(1, 0, -0.5);
  const std::vector<double> left_values{10, 10, 7, 3, -1, 0.4, 40, 4};
  const std::vector<double> right_values{0, 0, -0.5, -0.5, -3, -4, 0, 0};
  for (std::size_t i = 0; i < left.size(); ++i) {
    const LimbConstant l = limb_constant(graph_.nodes()[left[i].node()]);
    const LimbConstant r = limb_constant(graph_.nodes()[right[i].node()]);
    EXPECT_NE(l.slot, 0u) << i;
    EXPECT_EQ(l.slot, r.slot) << i;
    EXPECT_EQ(l.limb, 0u);
    EXPECT_EQ(r.limb, 1u);
    EXPECT_EQ(left[i].negative(), right[i].negative()) << i;
    EXPECT_EQ(left[i].constant(), left_values[i]) << i;
    EXPECT_EQ(right[i].constant(), right_values[i]) << i;
  }
}

TEST_F(ExpressionTest, LimbConstantsTimesOneAndMinusThemselves) {
  const Expression c = limb_constant_of(1, 0, 0.25);
  EXPECT_EQ(c * -1, -c);
  EXPECT_EQ(c - c, Expression());
  EXPECT_EQ(c * limb_constant_of(2, 1, 2), Expression(0.5));  // of two limbs: of none
}

TEST(Graph, WithoutScopeIsAnError) {
  EXPECT_THROW(Graph::current(), std::logic_error);
}

TEST(Graph, ScopesNest) {
  Graph outer;
  const Graph::Scope outer_scope(outer);
  {
    Graph inner;
    const Graph::Scope inner_scope(inner);
    EXPECT_EQ(&Graph::current(), &inner);
  }
  EXPECT_EQ(&Graph::current(), &outer);
}

}  // namespace
}  // namespace treeline
