#include "emission/print_lanes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "passes/lane_operands.hpp"

namespace treeline {
namespace {

constexpr std::uint32_t kNone = 0;

std::uint32_t first_node(const LanePack& pack) {
  return *std::min_element(pack.begin(), pack.end(), [](std::uint32_t a, std::uint32_t b) {
    return b == kNone || (a != kNone && a < b);
  });
}

}  // namespace

LanePrinter::LanePrinter(const Program& program, std::vector<std::string>& names)
    : program_(program), pack_of_(names.size(), -1), lane_of_(names.size(), -1) {
  for (std::size_t p = 0; p < program.packs.size(); ++p) {
    const LanePack& pack = program.packs[p];
    pack_names_.push_back(names[first_node(pack)] + "_lanes");
    for (std::size_t lane = 0; lane < pack.size(); ++lane) {
      if (pack[lane] != kNone) {
        pack_of_[pack[lane]] = static_cast<int>(p);
        lane_of_[pack[lane]] = static_cast<int>(lane);
        names[pack[lane]] = fmt::format("{}[{}]", pack_names_.back(), lane);
      }
    }
  }
}

bool LanePrinter::is_first(std::uint32_t node) const {
  return is_packed(node) && first_node(pack_of(node)) == node;
}

/// One value for all lanes is a scalar, which C++ spreads; another pack in place is its name.
std::string LanePrinter::operand(const LanePack& nodes,
                                 const ExpressionPrinter& expressions) const {
  const auto some = std::find_if(nodes.begin(), nodes.end(), [](auto n) { return n != kNone; });
  const bool same =
      std::all_of(nodes.begin(), nodes.end(), [&](auto n) { return n == kNone || n == *some; });
  if (same) {
    return expressions.atom(*some);
  }
  bool in_place = pack_of_[*some] >= 0;
  std::string list;
  for (std::size_t lane = 0; lane < nodes.size(); ++lane) {
    const std::uint32_t node = nodes[lane];
    if (node != kNone) {
      in_place =
          in_place && pack_of_[node] == pack_of_[*some] && lane_of_[node] == static_cast<int>(lane);
    }
    // An empty lane repeats a value: whatever it computes is not read.
    list += (lane == 0 ? "" : ", ") + expressions.reference(node != kNone ? node : *some);
  }
  return in_place ? pack_names_[static_cast<std::size_t>(pack_of_[*some])]
                  : fmt::format("detail::make_lanes<Real>({})", list);
}

std::string LanePrinter::statement(std::uint32_t node, const ExpressionPrinter& expressions) const {
  const LanePack& pack = pack_of(node);
  const Op op = program_.graph.nodes()[node].op;
  const LaneOperands operands = lane_operands(program_.graph, pack);
  return fmt::format("const Lanes<{}> {} = {} {} {};", pack.size(),
                     pack_names_[static_cast<std::size_t>(pack_of_[node])],
                     operand(operands.a, expressions), operation(op).symbol,
                     operand(operands.b, expressions));
}

}  // namespace treeline
