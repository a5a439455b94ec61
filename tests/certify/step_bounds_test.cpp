// Would catch: a proof of bounds that are too small, or of other operations than those of the
// code; steps that Gappa would prove with any number; hypotheses that nothing justifies.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <regex>
#include <set>
#include <string>

#include "bounds/rng.hpp"
#include "certify/bound_in_steps.hpp"
#include "check/fixture.hpp"
#include "compilation/temporary_folder.hpp"
#include "digits/digits50.hpp"
#include "program/evaluate.hpp"

namespace treeline::tests {
namespace {

constexpr auto kHour = std::chrono::hours(1);

bool has_gappa() {
  Diagnostics diagnostics;
  const TemporaryFolder folder;
  return find_gappa(folder.path(), diagnostics).has_value();
}

/// The gravity of the PUMA and the steps of its proof, which Gappa has proven once.
class StepBoundsOfGravity : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_gappa()) GTEST_SKIP() << "the program gappa is not installed";
    bounds_.emplace(program_, subjects_.generation.domain, gappa_,
                    StepBounds::Clock::now() + kHour);
    bounds_->prove();
  }

  static Subjects generate_gravity() {
    Subjects made = load("puma560");
    made.scene.functions = {Function::gravity};
    made.generation = generate(made.robot, made.scene);
    return made;
  }

  /// Values of all nodes at these joint angles.
  template <class Scalar>
  std::vector<Scalar> run(const std::vector<double>& q) const {
    std::vector<Scalar> inputs, values;
    for (const InputPlace& place : locate_inputs(program_)) {
      inputs.emplace_back(q.at(place.element));
    }
    for (const Node& node : program_.graph.nodes()) {
      values.push_back(evaluate_node(node, values, inputs));
    }
    return values;
  }

  std::vector<double> draw(treeline::Rng& rng) const {
    std::vector<double> q;
    for (const double size : subjects_.generation.domain.sizes.at("q")) {
      q.push_back(rng.within(size));
    }
    return q;
  }

  Subjects subjects_ = generate_gravity();
  const Program& program_ = subjects_.generation.functions.at(0).program;
  TemporaryFolder folder_;
  Gappa gappa_{folder_.path(), Precision::binary64};
  std::optional<StepBounds> bounds_;
};

TEST_F(StepBoundsOfGravity, HoldInStatesOfTheDomain) {
  treeline::Rng rng(7);
  const std::vector<Node>& nodes = program_.graph.nodes();
  double closest = 0;
  for (int state = 0; state < 200; ++state) {
    const std::vector<double> q = draw(rng);
    const auto rounded = run<double>(q);
    const auto exact = run<Digits50>(q);
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
      if (operation(nodes[i].op).operands == 0) continue;
      const double error = std::abs(static_cast<double>(Digits50(rounded[i]) - exact[i]));
      EXPECT_LE(error, bounds_->of(i).error.value) << i;
      EXPECT_LE(std::abs(static_cast<double>(exact[i])), bounds_->of(i).size.value * (1 + 1e-15));
      closest = std::max(closest, error / bounds_->of(i).error.value);
    }
  }
  EXPECT_GT(closest, 0.5);  // the bounds are about these errors
}

/// Reads `0x1.8p+3`, `X7` or `x7`.
double value_of(const std::string& operand, const std::vector<double>& values) {
  const bool is_node = operand[0] == 'X' || operand[0] == 'x';
  return is_node ? values.at(std::stoul(operand.substr(1))) : std::strtod(operand.c_str(), nullptr);
}

TEST_F(StepBoundsOfGravity, RoundWhatTheCodeComputes) {
  treeline::Rng rng(11);
  const auto values = run<double>(draw(rng));
  const std::regex rounding(R"(\|rnd\((\S+) ([-+*]) (\S+)\) - \(.*\)\|)");
  const std::regex meaning("X[0-9]+ = .*, x([0-9]+) = rnd.*");
  std::set<std::size_t> seen;
  for (const ProofStep& step : bounds_->steps()) {
    std::smatch node, parts;
    if (!std::regex_match(step.meaning, node, meaning)) continue;
    ASSERT_TRUE(std::regex_match(step.goals.at(1).expression, parts, rounding))
        << step.goals[1].expression;
    const double a = value_of(parts[1], values), b = value_of(parts[3], values);
    const char sign = parts[2].str()[0];
    const std::size_t i = std::stoul(node[1]);
    EXPECT_EQ(sign == '+' ? a + b : sign == '-' ? a - b : a * b, values.at(i)) << step.meaning;
    seen.insert(i);
  }
  const std::vector<Node>& nodes = program_.graph.nodes();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const bool rounds = is_sum(nodes[i].op) || nodes[i].op == Op::mul;
    EXPECT_EQ(rounds, seen.contains(i)) << i;
  }
}

TEST_F(StepBoundsOfGravity, AreNotProvenIfTooSmall) {
  int tried = 0;
  for (const ProofStep& step : bounds_->steps()) {
    for (std::size_t i = 0; i < step.goals.size(); ++i) {
      ProofStep wrong = step;
      const double bound = wrong.goals[i].bound.value;
      if (bound == 0 || ++tried % 5 != 0) continue;
      wrong.goals[i].bound = exact_number(bound * 0.99);
      EXPECT_FALSE(gappa_.proves(wrong)) << step.meaning;
    }
  }
  EXPECT_GT(tried, 100);
}

/// `X7 in [0,3b-4]` or `|X7| <= 3b-4` as the expression and its bound.
std::pair<std::string, std::string> split(const std::string& hypothesis) {
  const std::size_t less = hypothesis.find(" <= ");
  if (less != std::string::npos) return {hypothesis.substr(0, less), hypothesis.substr(less + 4)};
  const std::size_t in = hypothesis.find(" in [0,");
  const std::string bound = hypothesis.substr(in + 7);
  return {hypothesis.substr(0, in), bound.substr(0, bound.size() - 1)};
}

/// Every number in a hypothesis is one that an assumption states or that an earlier step proved.
TEST_F(StepBoundsOfGravity, SupposeOnlyWhatIsAssumedOrProven) {
  std::set<std::string> known{"1", "1b-53", "0"};
  for (const double size : subjects_.generation.domain.sizes.at("q")) {
    known.insert(exact_number(size).text);
  }
  int checked = 0;
  for (const ProofStep& step : bounds_->steps()) {
    for (const std::string& hypothesis : step.hypotheses) {
      if (hypothesis.ends_with(" in [1,1]")) continue;
      EXPECT_TRUE(known.contains(split(hypothesis).second)) << step.meaning << ": " << hypothesis;
      ++checked;
    }
    for (const StepGoal& goal : step.goals) known.insert(goal.bound.text);
  }
  EXPECT_GT(checked, 200);
}

TEST(Gappa, RejectsARewritingThatIsNoEquation) {
  if (!has_gappa()) GTEST_SKIP() << "the program gappa is not installed";
  const TemporaryFolder folder;
  const Gappa gappa(folder.path(), Precision::binary64);
  ProofStep step{"", {}, {"|X1| <= 1"}, {{"X1 * X1", exact_number(1)}}, {}};
  EXPECT_TRUE(gappa.proves(step));
  step.goals[0].bound = exact_number(0.5);
  EXPECT_FALSE(gappa.proves(step));
  step.rewritings = {"X1 * X1 -> X1 * X1 / 2"};
  EXPECT_FALSE(gappa.proves(step));
}

TEST(Gappa, ReadsItsNumbers) {
  EXPECT_EQ(read_gappa_number("3b-2").value, 0.75);
  EXPECT_EQ(read_gappa_number("17").value, 17);
  EXPECT_EQ(read_gappa_number("0x1.8p+1").value, 3);
  EXPECT_EQ(read_gappa_number("0x1.bp+1").value, 3.375);  // b is a digit here
}

}  // namespace
}  // namespace treeline::tests
