#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string_view>

#include "emission/body_steps.hpp"

namespace treeline {
namespace {

/// The angle of a link's joint in a sum.
struct Angle {
  int link = 0;
  bool is_minus = false;
  friend bool operator==(const Angle&, const Angle&) = default;
};

/// Sine or cosine of a sum of angles, by ascending links; the first one is not subtracted.
struct Turn {
  bool is_cosine = false;
  bool is_minus = false;
  std::vector<Angle> angles;
};

/// The sine or cosine that the trace named `s3` or `c3`.
std::optional<Turn> find_named_turn(const Graph& graph, std::uint32_t node) {
  const Op op = graph.nodes()[node].op;
  const std::string_view name = graph.names().of(node);
  if (!is_trigonometric(op) || name.size() < 2 || name[0] != (op == Op::sin ? 's' : 'c')) return {};
  int link = 0;
  const char* const end = name.data() + name.size();
  if (std::from_chars(name.data() + 1, end, link).ptr != end) return {};
  return Turn{op == Op::cos, false, {{link, false}}};
}

/// A turn by a plus b, or by a minus b; nothing where a link is in both.
std::optional<Turn> add_angles(bool is_cosine, const Turn& a, const Turn& b, bool subtracts) {
  Turn sum{is_cosine, false, a.angles};
  for (const Angle& angle : b.angles) {
    sum.angles.push_back({angle.link, angle.is_minus != subtracts});
  }
  std::sort(sum.angles.begin(), sum.angles.end(),
            [](const Angle& x, const Angle& y) { return x.link < y.link; });
  const auto twice = std::adjacent_find(sum.angles.begin(), sum.angles.end(),
                                        [](auto& x, auto& y) { return x.link == y.link; });
  if (twice != sum.angles.end()) return {};
  if (sum.angles.front().is_minus) {  // sin(-x) = -sin x, cos(-x) = cos x
    for (Angle& angle : sum.angles) angle.is_minus = !angle.is_minus;
    sum.is_minus = !is_cosine;
  }
  return sum;
}

/// A product of two turns, its sign taken out.
struct Product {
  const Turn* a = nullptr;
  const Turn* b = nullptr;
  bool is_minus = false;
};

class AngleSums {
 public:
  explicit AngleSums(const Graph& graph) : graph_(graph), turns_(graph.nodes().size()) {
    for (std::uint32_t i = 0; i < turns_.size(); ++i) {
      turns_[i] = is_sum(graph.nodes()[i].op) ? add_products(i) : find_named_turn(graph, i);
    }
  }

  [[nodiscard]] const std::vector<std::optional<Turn>>& turns() const { return turns_; }

 private:
  [[nodiscard]] std::optional<Product> find_product(std::uint32_t node) const {
    const Node& what = graph_.nodes()[node];
    if (what.op != Op::mul || !turns_[what.a] || !turns_[what.b]) return {};
    const Turn &a = *turns_[what.a], &b = *turns_[what.b];
    return Product{&a, &b, a.is_minus != b.is_minus};
  }

  /// The turn that a sum or difference of two products is, by the theorems of addition.
  [[nodiscard]] std::optional<Turn> add_products(std::uint32_t node) const {
    const Node& what = graph_.nodes()[node];
    std::optional<Product> x = find_product(what.a), y = find_product(what.b);
    if (!x || !y) return {};
    y->is_minus = y->is_minus != (what.op == Op::sub);
    const bool is_sine = x->a->is_cosine != x->b->is_cosine;
    return is_sine ? add_to_sine(*x, *y) : add_to_cosine(*x, *y);
  }

  /// sin a cos b + cos a sin b = sin(a + b).
  static std::optional<Turn> add_to_sine(Product x, Product y) {
    if (x.a->is_cosine) std::swap(x.a, x.b);
    if (y.b->is_cosine) std::swap(y.a, y.b);  // y.a the cosine, y.b the sine
    const bool crosses = !y.b->is_cosine && y.a->is_cosine && x.a->angles == y.a->angles &&
                         x.b->angles == y.b->angles;
    if (!crosses) return {};
    std::optional<Turn> sum = add_angles(false, *x.a, *x.b, x.is_minus != y.is_minus);
    if (sum) sum->is_minus = sum->is_minus != x.is_minus;
    return sum;
  }

  /// cos a cos b - sin a sin b = cos(a + b).
  static std::optional<Turn> add_to_cosine(Product x, Product y) {
    if (!x.a->is_cosine) std::swap(x, y);
    if (y.a->angles != x.a->angles) std::swap(y.a, y.b);
    const bool fits = x.a->is_cosine && x.b->is_cosine && !y.a->is_cosine && !y.b->is_cosine &&
                      x.a->angles == y.a->angles && x.b->angles == y.b->angles;
    if (!fits) return {};
    std::optional<Turn> sum = add_angles(true, *x.a, *x.b, x.is_minus == y.is_minus);
    if (sum) sum->is_minus = x.is_minus;
    return sum;
  }

  const Graph& graph_;
  std::vector<std::optional<Turn>> turns_;
};

std::string name_turn(const Turn& turn, bool has_short_numbers) {
  std::string name = fmt::format("{}{}", turn.is_minus ? "minus_" : "", turn.is_cosine ? 'c' : 's');
  const bool is_plain =
      has_short_numbers && std::none_of(turn.angles.begin(), turn.angles.end(),
                                        [](const Angle& angle) { return angle.is_minus; });
  for (const Angle& angle : turn.angles) {
    const bool is_first = &angle == &turn.angles.front();
    name += fmt::format("{}{}",
                        is_first || is_plain ? ""
                        : angle.is_minus     ? "_minus_"
                                             : "_plus_",
                        angle.link);
  }
  return name;
}

}  // namespace

std::vector<std::string> find_angle_sums(const Program& program) {
  const AngleSums sums(program.graph);
  const bool has_short_numbers =
      std::none_of(sums.turns().begin(), sums.turns().end(),
                   [](const auto& turn) { return turn && turn->angles.back().link > 9; });
  std::vector<std::string> names(sums.turns().size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::optional<Turn>& turn = sums.turns()[i];
    if (turn && turn->angles.size() > 1) names[i] = name_turn(*turn, has_short_numbers);
  }
  return names;
}

}  // namespace treeline
