#include "certify/turned_set.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

namespace treeline {
namespace {

void add_term(std::string& sum, int factor, const std::string& value) {
  const char* sign = factor < 0 ? (sum.empty() ? "-" : " - ") : sum.empty() ? "" : " + ";
  const int times = std::abs(factor);
  sum += sign + (times == 1 ? "" : fmt::format("{} * ", times)) + value;
}

/// `v0 * t0 + v1 * t1` for n pairs.
std::string print_products(std::size_t n, char left, char right) {
  std::string text;
  for (std::size_t i = 0; i < n; ++i) {
    text += fmt::format("{}{}{} * {}{}", i == 0 ? "" : " + ", left, i, right, i);
  }
  return text;
}

}  // namespace

TurnedSet::TurnedSet(StepBounds& proof, const std::vector<LinearRow>& rows, Values values,
                     std::size_t pair)
    : proof_(proof), values_(values), pair_(pair) {
  for (const LinearRow& row : rows) {
    TurnedRow turned = proof.pairs_.expand(row, pair);
    if (!turned.is_turned()) {
      others_.push_back(row);
      continue;
    }
    for (LinearRow* part : {&turned.cosine, &turned.sine, &turned.rest}) {
      *part = proof.keep_inexact(std::move(*part), values);
    }
    const GappaNumber added = bound_added(row, turned);
    turned_.push_back({std::move(turned), added});
  }
  pair_rows();
}

/// Bounds what is added to a turned row: the rest of the sum, and of errors the roundings.
GappaNumber TurnedSet::bound_added(const LinearRow& row, const TurnedRow& turned) const {
  std::vector<std::string> hypotheses;
  std::string sum;
  if (!turned.rest.empty()) {
    sum = proof_.print(turned.rest, values_);
    proof_.add_values(turned.rest, values_, hypotheses);
  }
  if (values_ == Values::errors) {
    hypotheses.push_back(fmt::format("|l| <= {}", bound_roundings(row).text));
    add_term(sum, 1, "l");
  }
  if (sum.empty()) return {};
  return proof_.bound("what is added to a turned value", hypotheses, fmt::format("|{}|", sum));
}

/// Bounds l, the error that the operations of a turned row add: each rounds by r7, and a product
/// with a cosine brings the error of that cosine.
GappaNumber TurnedSet::bound_roundings(const LinearRow& row) const {
  std::vector<std::string> hypotheses;
  std::string sum;
  for (const auto& [node, factor] : row) add_roundings(node, factor, sum, hypotheses);
  return proof_.bound("l: what the operations of a turned value add to its error", hypotheses,
                      fmt::format("|{}|", sum));
}

void TurnedSet::add_roundings(std::uint32_t node, int factor, std::string& sum,
                              std::vector<std::string>& hypotheses) const {
  const Node& n = proof_.nodes_[node];
  const auto product = proof_.pairs_.as_product(node, pair_);
  if (!product && !((is_sum(n.op) || n.op == Op::neg) && proof_.pairs_.turns(node, pair_))) {
    return;
  }
  if (n.op != Op::neg) {
    hypotheses.push_back(fmt::format("|r{}| <= {}", node, proof_.bounds_[node].rounding.text));
    add_term(sum, factor, fmt::format("r{}", node));
  }
  if (product) {
    if (proof_.is_exact(product->by)) return;
    proof_.add_values({{product->by, 1}}, Values::errors, hypotheses);
    proof_.add_size(product->of, hypotheses);
    proof_.add_error(product->of, hypotheses);
    add_term(sum, factor, fmt::format("e{} * {}", product->by, proof_.computed(product->of)));
    return;
  }
  add_roundings(n.a, n.op == Op::neg ? -factor : factor, sum, hypotheses);
  if (n.op != Op::neg) add_roundings(n.b, n.op == Op::sub ? -factor : factor, sum, hypotheses);
}

/// Finds pairs of rows that are the coordinates of one turned vector.
void TurnedSet::pair_rows() {
  std::vector<TurnedRow> left;
  for (const Turned& each : turned_) {
    if (each.row.is_turned()) left.push_back(each.row);
  }
  while (!left.empty()) {
    const TurnedRow row = left.front();
    left.erase(left.begin());
    const auto mate = std::find_if(
        left.begin(), left.end(), [&row](const TurnedRow& other) { return are_mates(row, other); });
    if (mate == left.end()) {
      alone_.push_back(row);
    } else {
      left.erase(mate);
    }
    for (const LinearRow& part : {row.cosine, row.sine}) {
      if (!part.empty()) below_.push_back(without_sign(part));
    }
  }
}

/// `(P * x + Q * y)`.
std::string TurnedSet::print(const LinearRow& at_cosine, const LinearRow& at_sine) const {
  const UnitPair& pair = proof_.pairs_.all()[pair_];
  std::string text;
  if (!at_cosine.empty()) {
    text = fmt::format("{} * {}", proof_.exact(pair.cosine), proof_.print(at_cosine, values_));
  }
  if (!at_sine.empty()) {
    text += fmt::format("{}{} * {}", text.empty() ? "" : " + ", proof_.exact(pair.sine),
                        proof_.print(at_sine, values_));
  }
  return "(" + text + ")";
}

/// Sum of squares of all rows without what is added to them.
std::string TurnedSet::print_turned() const {
  std::string sum;
  for (const Turned& each : turned_) {
    if (!each.row.is_turned()) continue;
    const std::string row = print(each.row.cosine, each.row.sine);
    sum += fmt::format("{0}{1} * {1}", sum.empty() ? "" : " + ", row);
  }
  if (!others_.empty()) {
    sum += (sum.empty() ? "" : " + ") + proof_.print_squares(others_, values_);
  }
  return sum;
}

/// Bound of the squares without what is added: that of all x, y and the rows not turned.
GappaNumber TurnedSet::bound_turned() const {
  std::vector<LinearRow> set = others_;
  set.insert(set.end(), below_.begin(), below_.end());
  for (LinearRow& row : set) row = without_sign(std::move(row));
  std::sort(set.begin(), set.end());
  const GappaNumber squares = proof_.bound_squares(set, values_);
  if (below_.empty()) return squares;
  const UnitPair& pair = proof_.pairs_.all()[pair_];
  const std::string P = proof_.exact(pair.cosine), Q = proof_.exact(pair.sine);
  const std::string one = fmt::format("{0} * {0} + {1} * {1}", P, Q);
  const std::string all = proof_.print_squares(set, values_);
  std::vector<std::string> hypotheses{fmt::format("{} in [1,1]", one)};
  for (const LinearRow& row : set) proof_.add_values(row, values_, hypotheses);
  hypotheses.push_back(fmt::format("|{}| <= 1", P));
  hypotheses.push_back(fmt::format("|{}| <= 1", Q));
  if (all != one) hypotheses.push_back(fmt::format("{} in [0,{}]", all, squares.text));
  std::string by =
      fmt::format("({}) + ({} - 1) * ({})", all, one, proof_.print_squares(below_, values_));
  for (const TurnedRow& row : alone_)
    by += fmt::format(" - {0} * {0}", print(-row.sine, row.cosine));
  const std::string turned = print_turned();
  return proof_.bound("squares of turned values are those of the values", hypotheses, turned,
                      {fmt::format("{} -> {}", turned, by)});
}

/// Bound of the squares of v + t from that of the v: |v + t| <= |v| + |t|. The rows that are not
/// turned are w.
GappaNumber TurnedSet::bound_sum(const GappaNumber& turned) const {
  const std::size_t n = turned_.size();
  const std::string rest = others_.empty() ? "" : " + w";
  const std::string vv = print_products(n, 'v', 'v'), tt = print_products(n, 't', 't');
  const std::string vt = "(" + print_products(n, 'v', 't') + ")";
  std::vector<std::string> hypotheses{fmt::format("{}{} in [0,{}]", vv, rest, turned.text)};
  const GappaNumber root = proof_.prove_root("v", turned);
  std::string goal;
  std::vector<std::string> rewritings(1);
  std::string less;  // than the product of both norms, in squares
  for (std::size_t i = 0; i < n; ++i) {
    hypotheses.push_back(fmt::format("|t{}| <= {}", i, turned_[i].added.text));
    hypotheses.push_back(fmt::format("|v{}| <= {}", i, root.text));
    goal += fmt::format("{0}(v{1} + t{1}) * (v{1} + t{1})", i == 0 ? "" : " + ", i);
    for (std::size_t j = 0; j < i; ++j) {
      less += fmt::format(" - (v{0} * t{1} - v{1} * t{0}) * (v{0} * t{1} - v{1} * t{0})", j, i);
    }
  }
  if (!rest.empty()) hypotheses.push_back(fmt::format("w in [0,{}]", turned.text));
  rewritings[0] = fmt::format("{0}{1} -> ({2}{1}) + 2 * {3} + ({4})", goal, rest, vv, vt, tt);
  if (n > 1) {
    if (!rest.empty()) hypotheses.push_back(fmt::format("{} in [0,{}]", vv, turned.text));
    rewritings.push_back(fmt::format("|{0}| -> sqrt({0} * {0})", vt));
    rewritings.push_back(fmt::format("{0} * {0} -> ({1}) * ({2}){3}", vt, vv, tt, less));
  }
  return proof_.bound("norm of a sum of two vectors, v and t", hypotheses, goal + rest, rewritings);
}

GappaNumber TurnedSet::bound() {
  const GappaNumber turned = bound_turned();
  const bool adds = std::any_of(turned_.begin(), turned_.end(),
                                [](const Turned& each) { return each.added.value != 0; });
  return adds ? bound_sum(turned) : turned;
}

}  // namespace treeline
