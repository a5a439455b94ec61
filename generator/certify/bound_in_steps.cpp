#include "certify/bound_in_steps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bounds/exact_operation.hpp"
#include "certify/turned_set.hpp"

namespace treeline {
namespace {

/// Sign of an operation in a formula.
const char* sign_of(Op op) {
  return op == Op::add ? "+" : op == Op::mul ? "*" : "-";
}

std::vector<bool> find_needed(const Program& program) {
  const std::vector<Node>& nodes = program.graph.nodes();
  std::vector<bool> needed(nodes.size());
  for (const Result& result : program.results) {
    for (const Expression& value : result.values) needed[value.node()] = true;
  }
  for (std::size_t i = nodes.size(); i-- > 0;) {
    if (!needed[i]) continue;
    const int operands = operation(nodes[i].op).operands;
    if (operands > 0) needed[nodes[i].a] = true;
    if (operands > 1) needed[nodes[i].b] = true;
  }
  return needed;
}

std::string print_constant(double value) {
  const std::string digits = fmt::format("{:a}", value);
  return value < 0 ? "(" + digits + ")" : digits;
}

const GappaNumber& less(const GappaNumber& a, const GappaNumber& b) {
  return b.value < a.value ? b : a;
}

void make_unique(std::vector<std::string>& list) {
  std::vector<std::string> kept;
  for (std::string& each : list) {
    if (std::find(kept.begin(), kept.end(), each) == kept.end()) kept.push_back(std::move(each));
  }
  list = std::move(kept);
}

}  // namespace

StepBounds::StepBounds(const Program& program, const Domain& domain, const Gappa& gappa,
                       Clock::time_point end)
    : program_(program),
      nodes_(program.graph.nodes()),
      domain_(domain),
      gappa_(gappa),
      end_(end),
      pairs_(program.graph),
      bounds_(nodes_.size()) {}

void StepBounds::prove() {
  for (const UnitPair& pair : pairs_.all()) {
    if (pair.by) prove_unit(pair);
  }
  const std::vector<bool> needed = find_needed(program_);
  for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
    if (needed[i]) bound_node(i);
  }
}

/// A pair turned by another is one, too.
void StepBounds::prove_unit(const UnitPair& pair) {
  const UnitPair &by = pairs_.all()[*pair.by], &of = pairs_.all()[*pair.of];
  const auto one = [this](const UnitPair& each) {
    return fmt::format("{0} * {0} + {1} * {1}", exact(each.cosine), exact(each.sine));
  };
  std::vector<std::string> hypotheses;
  for (const UnitPair* each : {&by, &of}) {
    hypotheses.push_back(one(*each) + " in [1,1]");
    for (const std::uint32_t node : {each->cosine, each->sine}) {
      hypotheses.push_back(fmt::format("|{}| <= 1", exact(node)));
    }
  }
  std::string squares;
  for (const std::uint32_t node : {pair.cosine, pair.sine}) {
    const TurnedRow row = pairs_.expand({{node, 1}}, *pair.by);
    squares += fmt::format("{0}({1} * {2} + {3} * {4}) * ({1} * {2} + {3} * {4})",
                           squares.empty() ? "" : " + ", exact(by.cosine),
                           print(row.cosine, Values::exact), exact(by.sine),
                           print(row.sine, Values::exact));
  }
  bound(fmt::format("{} = 1", one(pair)), hypotheses, squares + " - 1",
        {fmt::format("{} - 1 -> ({}) * ({}) - 1", squares, one(by), one(of))});
}

void StepBounds::bound_node(std::uint32_t node) {
  const Node& n = nodes_[node];
  NodeBound& of = bounds_[node];
  switch (n.op) {
    case Op::constant:
      of.size = exact_number(std::abs(n.value));
      if (gappa_.precision() == Precision::binary32 && !bounds::is_float(n.value)) {
        of.error =
            exact_number(std::abs(n.value - static_cast<double>(static_cast<float>(n.value))));
      }
      break;
    case Op::input:
      of.size = exact_number(*domain_.find(program_.graph.inputs()[n.a]));
      break;
    case Op::sin:
    case Op::cos:
      bound_sine(node);
      break;
    case Op::neg:
      of = {bounds_[n.a].size, bounds_[n.a].error, {}};
      break;
    case Op::div:
      throw ProofEnded("it divides");
    default:
      bound_operation(node);
  }
}

/// The sine of a computed angle has an error of one rounding unit, and the sine of two angles
/// differs by no more than the angles.
void StepBounds::bound_sine(std::uint32_t node) {
  NodeBound& of = bounds_[node];
  of.size = {"1", 1};
  const GappaNumber unit =
      read_gappa_number(gappa_.precision() == Precision::binary64 ? "1b-53" : "1b-24");
  const GappaNumber& angle = bounds_[nodes_[node].a].error;
  of.error = unit;
  if (angle.value == 0) return;
  of.error = bound(fmt::format("error of the sine or cosine {} of a rounded angle, Y{} exactly",
                               computed(node), node),
                   {fmt::format("|x{} - Y{}| <= {}", node, node, unit.text),
                    fmt::format("|Y{} - X{}| <= {}", node, node, angle.text)},
                   fmt::format("|x{} - X{}|", node, node));
}

void StepBounds::bound_operation(std::uint32_t node) {
  const Node& n = nodes_[node];
  NodeBound& of = bounds_[node];
  const std::string exactly = fmt::format("{} {} {}", exact(n.a), sign_of(n.op), exact(n.b));
  const std::string rounded = fmt::format("{} {} {}", computed(n.a), sign_of(n.op), computed(n.b));
  ProofStep step;
  step.meaning = fmt::format("X{} = {}, x{} = rnd({})", node, exactly, node, rounded);
  if (program_.graph.names().contains(node)) {
    step.meaning += fmt::format(": {}", program_.graph.names().of(node));
  }
  for (const std::uint32_t operand : {n.a, n.b}) {
    add_size(operand, step.hypotheses);
    add_error(operand, step.hypotheses);
    // Computed values are rounded ones: multiplying such a one by a power of two is exact.
    const bool scaled =
        n.op == Op::mul && nodes_[operand].op != Op::constant &&
        (bounds::is_power_of_two(nodes_[n.a]) || bounds::is_power_of_two(nodes_[n.b]));
    if (scaled) {
      const std::string value = computed(operand);
      step.definitions.push_back(fmt::format("{} = rnd(y{})", value, value.substr(1)));
    }
  }
  make_unique(step.hypotheses);
  make_unique(step.definitions);
  step.goals.push_back({fmt::format("|{}|", exactly), {}});
  step.goals.push_back({fmt::format("|rnd({}) - ({})|", rounded, exactly), {}});
  if (rounded != exactly) step.goals.push_back({fmt::format("|rnd({0}) - ({0})|", rounded), {}});
  solve(step);
  of = {step.goals[0].bound, step.goals[1].bound, step.goals.back().bound};
  if (is_sum(n.op) && pairs_.turn(node)) {
    of.size = less(of.size, bound_by_square({{node, 1}}, Values::exact));
    of.error = less(of.error, bound_by_square({{node, 1}}, Values::errors));
  }
  if (n.op == Op::mul && n.a != n.b && pairs_.turn(n.a) && pairs_.turn(n.b)) {
    bound_turned_product(node);
  }
}

/// |a b| is at most half of a^2 + b^2.
void StepBounds::bound_turned_product(std::uint32_t node) {
  const Node& n = nodes_[node];
  const Rows rows{{{n.a, 1}}, {{n.b, 1}}};
  const GappaNumber squares = bound_squares(rows, Values::exact);
  if (squares.value / 2 >= bounds_[node].size.value) return;
  const std::string a = exact(n.a), b = exact(n.b);
  const std::string sum = fmt::format("{0} * {0} + {1} * {1}", a, b);
  std::vector<std::string> hypotheses{fmt::format("{} in [0,{}]", sum, squares.text)};
  add_size(n.a, hypotheses);
  add_size(n.b, hypotheses);
  const GappaNumber found =
      bound(fmt::format("X{} = {} * {} by the sum of their squares", node, a, b), hypotheses,
            fmt::format("|{} * {}|", a, b),
            {fmt::format("{0} * {1} -> (({2}) - ({0} - {1}) * ({0} - {1})) / 2", a, b, sum),
             fmt::format("{0} * {1} -> (({0} + {1}) * ({0} + {1}) - ({2})) / 2", a, b, sum)});
  bounds_[node].size = less(bounds_[node].size, found);
}

GappaNumber StepBounds::bound_by_square(const LinearRow& row, Values values) {
  return prove_root(print(row, values), bound_squares({row}, values));
}

GappaNumber StepBounds::prove_root(const std::string& of, const GappaNumber& square) {
  if (square.value == 0) return {};
  return bound(fmt::format("{} by its square", of),
               {fmt::format("{0} * {0} in [0,{1}]", of, square.text)}, fmt::format("|{}|", of),
               {fmt::format("|{0}| -> sqrt({0} * {0})", of)});
}

GappaNumber StepBounds::bound_squares(const Rows& rows, Values values) {
  Rows set;
  for (const LinearRow& row : rows) {
    const LinearRow kept = without_sign(keep_inexact(row, values));
    if (!kept.empty()) set.push_back(kept);
  }
  std::sort(set.begin(), set.end());
  if (set.empty()) return {};
  if (values == Values::exact && pairs_.is_pair(set)) return {"1", 1};
  const auto known = squares_.find({values, set});
  if (known != squares_.end()) return known->second;
  GappaNumber bound = bound_squares_alone(set, values);
  if (const auto turn = pairs_.last_turn(set)) {
    bound = less(bound, TurnedSet(*this, set, values, *turn).bound());
  }
  squares_.emplace(std::pair(values, set), bound);
  return bound;
}

GappaNumber StepBounds::bound_squares_alone(const Rows& rows, Values values) {
  std::vector<std::string> hypotheses;
  for (const LinearRow& row : rows) add_values(row, values, hypotheses);
  const std::string sum = print_squares(rows, values);
  return bound(fmt::format("{} one by one", sum), hypotheses, sum);
}

GappaNumber StepBounds::bound(std::string meaning, std::vector<std::string> hypotheses,
                              std::string expression, std::vector<std::string> rewritings) {
  ProofStep step{std::move(meaning), {}, std::move(hypotheses), {}, std::move(rewritings)};
  make_unique(step.hypotheses);
  step.goals.push_back({std::move(expression), {}});
  solve(step);
  return step.goals.front().bound;
}

void StepBounds::solve(ProofStep& step) {
  if (Clock::now() > end_) throw ProofEnded("the time is over");
  if (!gappa_.solve(step)) throw ProofEnded("Gappa does not prove the step: " + step.meaning);
  steps_.push_back(step);
}

std::string StepBounds::exact(std::uint32_t node) const {
  const Node& n = nodes_[node];
  if (n.op == Op::neg) return fmt::format("(-{})", exact(n.a));
  return n.op == Op::constant ? print_constant(n.value) : fmt::format("X{}", node);
}

std::string StepBounds::computed(std::uint32_t node) const {
  const Node& n = nodes_[node];
  if (n.op == Op::neg) return fmt::format("(-{})", computed(n.a));
  if (n.op == Op::input) return exact(node);
  if (n.op != Op::constant) return fmt::format("x{}", node);
  return print_constant(gappa_.precision() == Precision::binary32
                            ? static_cast<double>(static_cast<float>(n.value))
                            : n.value);
}

std::string StepBounds::print(const LinearRow& row, Values values) const {
  std::string text;
  for (const auto& [node, factor] : row) {
    const char* sign = factor < 0 ? (text.empty() ? "-" : " - ") : text.empty() ? "" : " + ";
    const int times = std::abs(factor);
    text += sign + (times == 1 ? "" : fmt::format("{} * ", times)) +
            (values == Values::exact ? exact(node) : fmt::format("e{}", node));
  }
  return row.size() > 1 || text.starts_with('-') || text.find('*') != std::string::npos
             ? "(" + text + ")"
             : text;
}

std::string StepBounds::print_squares(const Rows& rows, Values values) const {
  std::string text;
  for (const LinearRow& row : rows) {
    text += fmt::format("{0}{1} * {1}", text.empty() ? "" : " + ", print(row, values));
  }
  return text;
}

LinearRow StepBounds::keep_inexact(LinearRow row, Values values) const {
  if (values == Values::errors) {
    std::erase_if(row, [this](const auto& term) { return is_exact(term.first); });
  }
  return row;
}

void StepBounds::add_size(std::uint32_t node, std::vector<std::string>& hypotheses) const {
  const Node& n = nodes_[node];
  if (n.op == Op::neg) return add_size(n.a, hypotheses);
  if (n.op == Op::constant) return;
  hypotheses.push_back(fmt::format("|X{}| <= {}", node, bounds_[node].size.text));
}

void StepBounds::add_error(std::uint32_t node, std::vector<std::string>& hypotheses) const {
  const Node& n = nodes_[node];
  if (n.op == Op::neg) return add_error(n.a, hypotheses);
  if (n.op == Op::constant || n.op == Op::input) return;
  hypotheses.push_back(fmt::format("|x{0} - X{0}| <= {1}", node, bounds_[node].error.text));
}

void StepBounds::add_values(const LinearRow& row, Values values,
                            std::vector<std::string>& hypotheses) const {
  for (const auto& [node, factor] : row) {
    if (values == Values::exact) {
      add_size(node, hypotheses);
    } else {
      hypotheses.push_back(fmt::format("|e{}| <= {}", node, bounds_[node].error.text));
    }
  }
}

}  // namespace treeline
