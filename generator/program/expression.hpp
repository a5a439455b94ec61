#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace treeline {

enum class Op : std::uint8_t { constant, input, add, sub, mul, div, neg, sin, cos };

/// What there is to know about an operation; `kOperations` is indexed by Op.
struct Operation {
  std::string_view name;
  std::string_view symbol;  ///< as C++ prints it: infix of two operands, function of one
  int operands;
  bool commutes;
};
inline constexpr std::array<Operation, 9> kOperations = {{
    {"constant", "", 0, false},
    {"input", "", 0, false},
    {"add", "+", 2, true},
    {"sub", "-", 2, false},
    {"mul", "*", 2, true},
    {"div", "/", 2, false},
    {"neg", "-", 1, false},
    {"sin", "sin", 1, false},
    {"cos", "cos", 1, false},
}};
constexpr const Operation& operation(Op op) {
  return kOperations[static_cast<std::size_t>(op)];
}

constexpr bool is_sum(Op op) {
  return op == Op::add || op == Op::sub;
}
constexpr bool is_trigonometric(Op op) {
  return op == Op::sin || op == Op::cos;
}

/// One operation. Operands are indices of earlier nodes, so the list is topologically ordered.
/// Operands carry no sign: the constructors of `Expression` move every minus outward; `neg` stands
/// only where `Graph::align_lanes` asked for a value without sign.
struct Node {
  Op op = Op::constant;
  std::uint32_t a = 0;  ///< left operand; for `input` its index into Graph::inputs
  std::uint32_t b = 0;  ///< right operand of add, sub, mul, div
  double value = 0;     ///< of `constant`; positive or zero, but for a limb's constant of any sign
};

/// The constant 0, which every graph begins with; in lists of operands and lanes: none.
inline constexpr std::uint32_t kNoNode = 0;

/// Limbs of one build differ in their constants. Where they do, the constant of each limb is a
/// node of its own kind: it does not vanish, not even where it is 0 or 1, so that all limbs trace
/// to the same operations and may share lanes. Kept in the node of a constant: `a` is `slot`, 0
/// for ordinary constants, `b` is `limb` and `limbs`.
struct LimbConstant {
  std::uint32_t slot = 0;  ///< the same for corresponding constants of all limbs
  std::uint32_t limb = 0;
  std::uint32_t limbs = 0;  ///< how many there are
};
LimbConstant limb_constant(const Node& node);
Node make_limb_constant(LimbConstant what, double value);

/// A value while a recursion is traced: a node and a sign. `double` converts to a constant;
/// + - * / sin cos build nodes in the graph that is open in this thread (see `Graph::Scope`).
/// The constructors simplify: 0, 1, -1, constants and signs vanish; equal nodes are one node.
class Expression {
 public:
  Expression() = default;    // zero
  Expression(double value);  // NOLINT: implicit on purpose, it is a Scalar
  Expression(std::uint32_t node, bool negative) : node_(node), negative_(negative && node != 0) {}

  [[nodiscard]] std::uint32_t node() const { return node_; }
  [[nodiscard]] bool negative() const { return negative_; }
  [[nodiscard]] bool is_zero() const { return node_ == 0; }
  [[nodiscard]] bool is_constant() const;
  /// A constant of one of several limbs, see LimbConstant.
  [[nodiscard]] bool is_limb_constant() const;
  /// Value of a constant, with its sign.
  [[nodiscard]] double constant() const;

  Expression operator-() const { return is_zero() ? *this : Expression(node_, !negative_); }
  Expression& operator+=(Expression other) { return *this = *this + other; }
  Expression& operator-=(Expression other) { return *this = *this - other; }
  Expression& operator*=(Expression other) { return *this = *this * other; }

  friend Expression operator+(Expression a, Expression b);
  friend Expression operator-(Expression a, Expression b) { return a + (-b); }
  friend Expression operator*(Expression a, Expression b);
  friend Expression operator/(Expression a, Expression b);
  friend Expression sin(Expression a);
  friend Expression cos(Expression a);
  friend bool operator==(Expression a, Expression b) = default;

 private:
  std::uint32_t node_ = 0;  // node 0 of every graph is the constant zero
  bool negative_ = false;
};

/// Where each node of a list is, nodes of equal bits are one: chained behind its later operand.
class NodeIndex {
 public:
  static constexpr std::uint32_t kNone = 0xffffffffU;

  /// Makes room for so many nodes, of which `nodes` are there.
  void reserve(const std::vector<Node>& nodes, std::size_t count);
  /// The index of `node` in `nodes`, or kNone.
  [[nodiscard]] std::uint32_t find(const std::vector<Node>& nodes, const Node& node) const {
    return places_.empty() ? kNone : places_[slot_of(nodes, node)];
  }
  /// The same, after `node` was added to `nodes` where it was missing.
  std::uint32_t find_or_add(std::vector<Node>& nodes, const Node& node);

 private:
  [[nodiscard]] std::size_t slot_of(const std::vector<Node>& nodes, const Node& node) const;
  void grow(const std::vector<Node>& nodes, std::size_t slots);

  std::vector<std::uint32_t> places_;  // ends of chains; of each node the first behind it, the next
};

/// The interning arena: nodes in order of creation, each once. Node 0 is the constant 0.
class Graph {
 public:
  Graph();

  /// Makes `graph` the one that Expression operators build into, until destroyed.
  class Scope {
   public:
    explicit Scope(Graph& graph);
    ~Scope();
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

   private:
    Graph* previous_;
  };
  /// The graph that is open; throws std::logic_error when none is (a fault of the program).
  static Graph& current();

  /// A scalar input; `name` is how emitted code reads it, e.g. `q[3]`. The same name is the same
  /// input.
  Expression input(std::string name);
  /// Makes room for so many nodes.
  void reserve(std::size_t nodes) {
    nodes_.reserve(nodes);
    index_.reserve(nodes_, nodes);
  }
  /// Interns; expects canonical operands.
  std::uint32_t intern(Node node);
  [[nodiscard]] bool contains(const Node& node) const {
    return index_.find(nodes_, node) != NodeIndex::kNone;
  }
  /// Where the node is, or 0.
  [[nodiscard]] std::uint32_t find(const Node& node) const {
    const std::uint32_t found = index_.find(nodes_, node);
    return found == NodeIndex::kNone ? 0 : found;
  }
  /// Whether x y and y x, x - y and y - x are one node; the first that is built stays. A trace
  /// turns this off: C++ leaves open which operand of an operator is evaluated first, so the order
  /// of building would depend on the compiler. The pass `settle` merges later, in a fixed order.
  [[nodiscard]] bool merges_commuted() const { return merges_commuted_; }
  /// An empty graph to trace into, for code with so many lanes.
  static Graph for_trace(int lanes);
  /// From here on names and sections are not wanted: for who only counts.
  void forget_names() { keeps_names_ = false; }
  [[nodiscard]] bool keeps_names() const { return keeps_names_; }
  /// Suggests a readable identifier for the node's value (`w4_x`); the first one wins. Of a value
  /// that is the negative of its node the node is called `minus_w4_x`. Constants stay unnamed.
  void name(Expression value, std::string_view identifier);
  /// Nodes created from here on belong to the section `title` ("link 4 outward").
  void begin_section(std::string title);

  /// How many lanes the emitted code may use; 1: lanes are not wanted and not noted.
  void set_lane_width(int width) { lane_width_ = width; }
  [[nodiscard]] int lane_width() const { return lane_width_; }
  /// The value as a node of its own, its sign made an operation.
  Expression without_sign(Expression value);
  /// Tells that these values come out of one computation on different data and may share the
  /// lanes of one register, each in the place of its index; zeros leave their place empty. Signs,
  /// which would tell the lanes apart from here on, are made operations.
  void align_lanes(std::span<Expression> values);
  /// Values that may share a register, by place; node 0 is an empty place.
  using LaneGroup = std::vector<std::uint32_t>;
  [[nodiscard]] const std::vector<LaneGroup>& lane_groups() const { return lane_groups_; }
  void add_lane_group(LaneGroup group);
  /// Index of the first group that holds the node; -1: none does.
  [[nodiscard]] int lane_group_of(std::uint32_t node) const {
    const auto found = lane_group_of_.find(node);
    return found == lane_group_of_.end() ? -1 : found->second;
  }

  /// Inputs that are one for each limb, in the order of limbs: by name, `qd[3]`.
  using LimbInputs = std::vector<std::string>;
  [[nodiscard]] const std::vector<LimbInputs>& limb_inputs() const { return limb_inputs_; }
  void add_limb_inputs(LimbInputs inputs) { limb_inputs_.push_back(std::move(inputs)); }
  /// Takes over what `other` says about lanes as a whole: their number, the limbs' inputs.
  void keep_lanes_of(const Graph& other) {
    lane_width_ = other.lane_width_;
    limb_inputs_ = other.limb_inputs_;
  }

  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
  [[nodiscard]] const std::vector<std::string>& inputs() const { return inputs_; }
  [[nodiscard]] const std::unordered_map<std::uint32_t, std::string>& names() const {
    return names_;
  }
  struct Section {
    std::uint32_t first_node;
    std::string title;
  };
  [[nodiscard]] const std::vector<Section>& sections() const { return sections_; }

 private:
  std::vector<Node> nodes_;
  std::vector<std::string> inputs_;
  NodeIndex index_;
  std::unordered_map<std::uint32_t, std::string> names_;
  std::vector<Section> sections_;
  std::vector<LaneGroup> lane_groups_;
  std::unordered_map<std::uint32_t, int> lane_group_of_;
  std::vector<LimbInputs> limb_inputs_;
  int lane_width_ = 1;
  bool merges_commuted_ = true;
  bool keeps_names_ = true;
};

}  // namespace treeline
