#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "program/double_double.hpp"
#include "program/node_names.hpp"
#include "program/section_title.hpp"

namespace treeline {

enum class Op : std::uint8_t { constant, input, add, sub, mul, div, neg, sin, cos };

/// Properties of an operation. `kOperations` is indexed by Op.
struct Operation {
  std::string_view name;
  int operands;
  bool commutes;
};
inline constexpr std::array<Operation, 9> kOperations = {{
    {"constant", 0, false},
    {"input", 0, false},
    {"add", 2, true},
    {"sub", 2, false},
    {"mul", 2, true},
    {"div", 2, false},
    {"neg", 1, false},
    {"sin", 1, false},
    {"cos", 1, false},
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
/// Operands have no sign: the constructors of `Expression` move every minus outward. `neg` occurs
/// only where `Graph::align_lanes` needs a value without sign.
struct Node {
  Op op = Op::constant;
  std::uint32_t a = 0;  ///< left operand; for `input` its index into Graph::inputs
  std::uint32_t b = 0;  ///< right operand of add, sub, mul, div
  double value = 0;     ///< of `constant`; not negative, except for constants of limbs
};

/// Node 0: the constant 0, with which every graph begins. In lists of operands and lanes it means
/// that there is none.
inline constexpr std::uint32_t kNoNode = 0;

/// A constant that differs between limbs of one shape. The constant of each limb is a node of its
/// own kind: it is never simplified away, even if it is 0 or 1. So all limbs trace to the same
/// operations and may share lanes. The node of a constant stores it: `a` is `slot` (0 for ordinary
/// constants), `b` combines `limb` and `limbs`.
struct LimbConstant {
  std::uint32_t slot = 0;  ///< equal for corresponding constants of all limbs
  std::uint32_t limb = 0;
  std::uint32_t limbs = 0;  ///< number of limbs
};
LimbConstant limb_constant(const Node& node);
Node make_limb_constant(LimbConstant what, double value);

/// A value while a recursion is traced: a node and a sign. `double` converts to a constant. The
/// operators + - * / and sin, cos build nodes in the graph that is open in this thread (see
/// `Graph::Scope`). The constructors simplify: 0, 1, -1, constants and signs vanish, and equal
/// nodes are one node.
class Expression {
 public:
  Expression() = default;    // the constant 0
  Expression(double value);  // NOLINT: implicit on purpose, because Expression is a Scalar
  Expression(const DoubleDouble& value);  // NOLINT: as above
  Expression(std::uint32_t node, bool negative) : node_(node), negative_(negative && node != 0) {}

  [[nodiscard]] std::uint32_t node() const { return node_; }
  [[nodiscard]] bool negative() const { return negative_; }
  [[nodiscard]] bool is_zero() const { return node_ == 0; }
  [[nodiscard]] bool is_constant() const;
  /// Whether this is a constant that differs between limbs, see LimbConstant.
  [[nodiscard]] bool is_limb_constant() const;
  /// Value of a constant, including its sign.
  [[nodiscard]] double constant() const;
  /// Value of a constant before it was rounded, including its sign.
  [[nodiscard]] DoubleDouble exact_constant() const;

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
  std::uint32_t node_ = 0;  // node 0 of every graph is the constant 0
  bool negative_ = false;
};

/// Finds the index of a node in a list of nodes. Nodes with equal bits count as one. Nodes are
/// chained by their later operand.
class NodeIndex {
 public:
  static constexpr std::uint32_t kNone = 0xffffffffU;

  /// Reserves memory for `count` nodes; `nodes` are the present ones.
  void reserve(const std::vector<Node>& nodes, std::size_t count);
  /// Index of `node` in `nodes`, or kNone.
  [[nodiscard]] std::uint32_t find(const std::vector<Node>& nodes, const Node& node) const {
    return places_.empty() ? kNone : places_[slot_of(nodes, node)];
  }
  /// Index of `node` in `nodes`. Adds the node if it is missing.
  std::uint32_t find_or_add(std::vector<Node>& nodes, const Node& node);

 private:
  [[nodiscard]] std::size_t slot_of(const std::vector<Node>& nodes, const Node& node) const;
  void grow(const std::vector<Node>& nodes, std::size_t slots);

  std::vector<std::uint32_t> places_;  // heads of chains; by node: first user, next in its chain
};

/// The expression graph while it is built: nodes in order of creation, equal nodes only once. Node
/// 0 is the constant 0.
class Graph {
 public:
  Graph();

  /// Makes `graph` the one that operators of Expression build into, until this object is destroyed.
  class Scope {
   public:
    explicit Scope(Graph& graph);
    ~Scope();
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

   private:
    Graph* previous_;
  };
  /// The graph that is open in this thread. Throws std::logic_error if there is none, which is a
  /// fault of the program.
  static Graph& current();

  /// A scalar input. `name` is how emitted code reads it, for instance `q[3]`. Equal names are the
  /// same input.
  Expression input(std::string name);
  /// Reserves memory for `nodes` nodes.
  void reserve(std::size_t nodes) {
    nodes_.reserve(nodes);
    index_.reserve(nodes_, nodes);
  }
  /// Index of the node, which is added if it is new. Its operands must be in canonical order.
  /// `rest`: what rounding left of a constant. Constants that are equal once rounded are one node,
  /// with the rest of the first.
  std::uint32_t intern(Node node, double rest = 0);
  /// What rounding left of the constant at this node.
  [[nodiscard]] double rest_of(std::uint32_t node) const;
  [[nodiscard]] bool contains(const Node& node) const {
    return index_.find(nodes_, node) != NodeIndex::kNone;
  }
  /// Index of the node, or 0 if it does not exist.
  [[nodiscard]] std::uint32_t find(const Node& node) const {
    const std::uint32_t found = index_.find(nodes_, node);
    return found == NodeIndex::kNone ? 0 : found;
  }
  /// Whether x y and y x, and x - y and y - x, are one node; the one built first stays. A trace
  /// turns this off: C++ does not specify which operand of an operator is evaluated first, so the
  /// order of building would depend on the compiler. The pass `canonicalize` merges such nodes
  /// later, in a fixed order.
  [[nodiscard]] bool merges_commuted() const { return merges_commuted_; }
  /// An empty graph to trace into, for code with `lanes` lanes.
  static Graph for_trace(int lanes);
  /// Drops names and sections from now on. For callers that only count operations.
  void forget_names() { keeps_names_ = false; }
  [[nodiscard]] bool keeps_names() const { return keeps_names_; }
  /// Suggests a readable identifier for the node's value (`w4_x`). The first suggestion wins. If
  /// the value is the negative of its node, the node is called `minus_w4_x`. Constants have no
  /// name.
  void name(Expression value, std::string_view identifier);
  /// Nodes created from now on belong to the section of this title.
  void begin_section(SectionTitle title);
  void begin_section(std::shared_ptr<const SectionTitle> title);

  /// Sets the number of lanes that the emitted code may use. With 1, lanes are not recorded.
  void set_lane_width(int width) { lane_width_ = width; }
  [[nodiscard]] int lane_width() const { return lane_width_; }
  /// Returns the value without sign: a minus becomes an operation of its own.
  Expression without_sign(Expression value);
  /// Declares that these values come from one computation on different data and may share the lanes
  /// of one register, each at the place of its index. Constants leave their place empty. Signs
  /// become operations, because they would otherwise distinguish the lanes from now on.
  void align_lanes(std::span<Expression> values);
  /// Values that may share a register, by place. Node 0 is an empty place.
  using LaneGroup = std::span<const std::uint32_t>;
  [[nodiscard]] std::size_t lane_group_count() const { return lane_group_ends_.size(); }
  [[nodiscard]] LaneGroup lane_group(std::size_t index) const {
    const std::size_t begin = index == 0 ? 0 : lane_group_ends_[index - 1];
    return LaneGroup(lane_group_nodes_).subspan(begin, lane_group_ends_[index] - begin);
  }
  /// Adds a group of the nodes that `node_of` gives for those of `group`.
  template <class NodeOf>
  void add_lane_group(LaneGroup group, NodeOf node_of) {
    for (const std::uint32_t node : group) append_lane(node_of(node));
    lane_group_ends_.push_back(lane_group_nodes_.size());
  }
  /// Index of the first lane group that holds the node; -1 if there is none.
  [[nodiscard]] int lane_group_of(std::uint32_t node) const {
    return node < lane_group_of_.size() ? lane_group_of_[node] : -1;
  }

  /// Names of corresponding inputs (`qd[3]`), one per limb, in the order of the limbs.
  using LimbInputs = std::vector<std::string>;
  [[nodiscard]] const std::vector<LimbInputs>& limb_inputs() const { return limb_inputs_; }
  void add_limb_inputs(LimbInputs inputs) { limb_inputs_.push_back(std::move(inputs)); }
  /// Copies from `other` what concerns lanes as a whole: their number, and the inputs of limbs.
  void keep_lanes_of(const Graph& other) {
    lane_width_ = other.lane_width_;
    limb_inputs_ = other.limb_inputs_;
  }

  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
  [[nodiscard]] const std::vector<std::string>& inputs() const { return inputs_; }
  [[nodiscard]] const NodeNames& names() const { return names_; }
  struct Section {
    std::uint32_t first_node;
    std::shared_ptr<const SectionTitle> shared_title;  ///< by the copies that passes make
    [[nodiscard]] const SectionTitle& title() const { return *shared_title; }
  };
  [[nodiscard]] const std::vector<Section>& sections() const { return sections_; }

 private:
  void append_lane(std::uint32_t node);

  std::vector<Node> nodes_;
  std::vector<std::pair<std::uint32_t, double>> rests_;  // of constants that have one, by node
  std::vector<std::string> inputs_;
  NodeIndex index_;
  NodeNames names_;
  std::vector<Section> sections_;
  std::vector<std::uint32_t> lane_group_nodes_;  // of all groups, one after the other
  std::vector<std::size_t> lane_group_ends_;     // by group
  std::vector<int> lane_group_of_;               // by node: the first group that holds it
  std::vector<LimbInputs> limb_inputs_;
  int lane_width_ = 1;
  bool merges_commuted_ = true;
  bool keeps_names_ = true;
};

}  // namespace treeline
