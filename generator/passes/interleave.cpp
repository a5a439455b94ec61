#include <algorithm>
#include <optional>
#include <utility>

#include "passes/passes.hpp"
#include "passes/rebuild.hpp"

namespace treeline {
namespace {

/// Number of operations to look ahead. Measured: a longer window is faster (control torque of a
/// quadruped: 16 % less time) until the code is so long that fetching it takes the time, about 16
/// bytes per cycle from the second-level cache. There, longer live ranges cost spills, and spills
/// are bytes. Choosing the operation that frees most registers, instead of the one that can begin
/// first, saves 2 to 10 % of the bytes but costs 5 to 15 % of the time if the code is shorter.
constexpr int kWindow = 128;
constexpr int kWindowOfLongCode = 40;
constexpr int kLongCode = 44 * 1024;  // bytes
constexpr int kIssue = 4;             ///< operations that begin in one cycle

int issue_latency(Op op) {
  switch (op) {
    case Op::add:
    case Op::sub:
      return 3;
    case Op::mul:
      return 4;
    case Op::div:
      return 13;
    default:
      return 0;
  }
}

/// Estimates the size of the program's machine code in bytes.
int estimate_code_bytes(const Program& program) {
  constexpr int kBytes = 9;  // measured: 7 to 8 per instruction, some of which only move
  Marks is_counted = find_live(program);
  int instructions = program.lane_moves + static_cast<int>(program.packs.size());
  for (const LanePack& pack : program.packs) {
    for (const std::uint32_t node : pack) {
      is_counted[node] = false;
    }
  }
  for (std::size_t i = 0; i < is_counted.size(); ++i) {
    const bool is_operation = issue_latency(program.graph.nodes()[i].op) > 0;
    instructions += is_counted[i] && is_operation ? 1 : 0;
  }
  return kBytes * instructions;
}

/// A single node, or all nodes of a pack.
struct Unit {
  std::size_t first_node = 0, nodes = 0;        ///< in the order that is given
  std::size_t first_operand = 0, operands = 0;  ///< in `Units::operands`
  int height = 0;                               ///< cycles until the last result that needs it
  int end = 0;  ///< cycle in which its value is ready, once it is placed
  bool done = false;
};

struct Units {
  std::vector<Unit> list;
  std::vector<std::size_t> operands;  ///< indices of units, of one unit after the other
};

Units make_units(const Program& program, std::span<const std::uint32_t> order) {
  const std::vector<Node>& nodes = program.graph.nodes();
  constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  std::vector<std::size_t> pack_of(nodes.size(), kNone);
  for (std::size_t p = 0; p < program.packs.size(); ++p) {
    for (const std::uint32_t node : program.packs[p]) {
      pack_of[node] = p;
    }
  }
  Units units;
  std::vector<std::size_t> unit_of(nodes.size(), kNone);
  std::size_t last_pack = kNone;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::uint32_t node = order[i];
    const std::size_t pack = node == 0 ? kNone : pack_of[node];
    if (pack == kNone || pack != last_pack) {
      units.list.push_back({i, 0, units.operands.size(), 0});
    }
    last_pack = pack;
    Unit& unit = units.list.back();
    ++unit.nodes;
    unit_of[node] = units.list.size() - 1;
    const int operands = operation(nodes[node].op).operands;
    if (operands >= 1) units.operands.push_back(unit_of[nodes[node].a]);
    if (operands == 2) units.operands.push_back(unit_of[nodes[node].b]);
    unit.operands = units.operands.size() - unit.first_operand;
  }
  for (std::size_t u = units.list.size(); u-- > 0;) {
    Unit& unit = units.list[u];
    unit.height += issue_latency(nodes[order[unit.first_node]].op);
    for (std::size_t i = 0; i < unit.operands; ++i) {
      int& height = units.list[units.operands[unit.first_operand + i]].height;
      height = std::max(height, unit.height);
    }
  }
  return units;
}

class Interleaver {
 public:
  Interleaver(const std::vector<Node>& nodes, std::span<const std::uint32_t> given, Units units,
              int window)
      : nodes_(nodes),
        given_(given),
        units_(std::move(units.list)),
        operands_(std::move(units.operands)),
        window_(window) {
    order_.reserve(given.size());
  }

  std::vector<std::uint32_t> run(std::size_t head) {
    while (order_.size() < head) {
      place(units_[first_]);
    }
    while (first_ < units_.size()) {
      place(units_[choose()]);
    }
    return std::move(order_);
  }

 private:
  /// Cycle in which the unit can begin. Nothing if an operand is not placed yet.
  [[nodiscard]] std::optional<int> find_begin(const Unit& unit) const {
    int begin = cycle_;
    for (std::size_t i = 0; i < unit.operands; ++i) {
      const Unit& operand = units_[operands_[unit.first_operand + i]];
      if (!operand.done) {
        return std::nullopt;
      }
      begin = std::max(begin, operand.end);
    }
    return begin;
  }

  /// Index of the unit within the window that can begin first; among several, of the one with the
  /// longest way to a result.
  [[nodiscard]] std::size_t choose() const {
    std::size_t best = first_;
    int best_begin = *find_begin(units_[first_]);
    int looked = 0;
    for (std::size_t u = first_ + 1; u < units_.size() && looked < window_; ++u) {
      const Unit& unit = units_[u];
      if (unit.done) {
        continue;
      }
      ++looked;
      const std::optional<int> begin = find_begin(unit);
      if (begin &&
          (*begin < best_begin || (*begin == best_begin && unit.height > units_[best].height))) {
        best = u;
        best_begin = *begin;
      }
    }
    return best;
  }

  void place(Unit& unit) {
    const int begin = *find_begin(unit);
    if (begin > cycle_) {
      cycle_ = begin;
      begun_ = 0;
    }
    const std::span<const std::uint32_t> nodes = given_.subspan(unit.first_node, unit.nodes);
    const int cost = issue_latency(nodes_[nodes.front()].op);
    unit.done = true;
    unit.end = begin + cost;
    order_.insert(order_.end(), nodes.begin(), nodes.end());
    if (cost > 0 && ++begun_ == kIssue) {
      ++cycle_;
      begun_ = 0;
    }
    while (first_ < units_.size() && units_[first_].done) {
      ++first_;
    }
  }

  const std::vector<Node>& nodes_;
  std::span<const std::uint32_t> given_;
  std::vector<Unit> units_;
  std::vector<std::size_t> operands_;
  int window_;
  std::vector<std::uint32_t> order_;
  std::size_t first_ = 0;  ///< first unit that is not placed yet
  int cycle_ = 0, begun_ = 0;
};

}  // namespace

std::vector<std::uint32_t> interleave(const Program& program, std::span<const std::uint32_t> order,
                                      std::size_t head) {
  const bool is_long = estimate_code_bytes(program) > kLongCode;
  return Interleaver(program.graph.nodes(), order, make_units(program, order),
                     is_long ? kWindowOfLongCode : kWindow)
      .run(head);
}

}  // namespace treeline
