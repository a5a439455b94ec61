#include "emission/print_lanes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "passes/lanes.hpp"
#include "passes/rebuild.hpp"

namespace treeline {
namespace {

/// Operations in one statement.
constexpr int kLargestStatement = 6;

std::uint32_t first_node(const LanePack& pack) {
  return *std::min_element(pack.begin(), pack.end(), [](std::uint32_t a, std::uint32_t b) {
    return b == kNoNode || (a != kNoNode && a < b);
  });
}

}  // namespace

LanePrinter::LanePrinter(const Program& program, const Syntax& syntax,
                         std::vector<std::string>& names)
    : program_(program), pack_of_(names.size(), -1) {
  for (std::size_t p = 0; p < program.packs.size(); ++p) {
    const LanePack& pack = program.packs[p];
    pack_names_.push_back(names[first_node(pack)] + "_lanes");
    operands_.push_back(lane_operands(program.graph, pack));
    for (std::size_t lane = 0; lane < pack.size(); ++lane) {
      if (pack[lane] != kNoNode) {
        pack_of_[pack[lane]] = static_cast<int>(p);
        names[pack[lane]] = syntax.lane(syntax, pack.size(), pack_names_.back(), lane);
      }
    }
  }
  find_inner_packs();
}

int LanePrinter::pack_in_place(const LanePack& nodes) const {
  const auto some = std::find_if(nodes.begin(), nodes.end(), [](auto n) { return n != kNoNode; });
  const int pack = some == nodes.end() ? -1 : pack_of_[*some];
  const bool in_place =
      pack >= 0 && stands_in_place(nodes, program_.packs[static_cast<std::size_t>(pack)]);
  return in_place ? pack : -1;
}

void LanePrinter::find_inner_packs() {
  const std::vector<int> uses = count_uses(program_);
  const auto used_once = [&](const LanePack& pack) {
    return std::all_of(pack.begin(), pack.end(), [&](std::uint32_t node) {
      return node == kNoNode || (uses[node] == 1 && !program_.graph.names().contains(node));
    });
  };
  is_inner_.assign(program_.packs.size(), false);
  std::vector<int> size(program_.packs.size(), 1);
  std::vector<std::size_t> by_place(program_.packs.size());
  for (std::size_t p = 0; p < by_place.size(); ++p) by_place[p] = p;
  std::sort(by_place.begin(), by_place.end(), [&](std::size_t p, std::size_t q) {
    return first_node(program_.packs[p]) < first_node(program_.packs[q]);
  });
  for (const std::size_t user : by_place) {
    for (const LanePack& nodes : {operands_[user].a, operands_[user].b}) {
      const int pack = pack_in_place(nodes);
      const auto p = static_cast<std::size_t>(pack);
      // Every use of a lane of the pack has to be in `nodes`, so none may be left out there.
      if (pack >= 0 && program_.packs[p] == nodes && used_once(nodes) &&
          size[user] + size[p] <= kLargestStatement) {
        is_inner_[p] = true;
        size[user] += size[p];
      }
    }
  }
}

bool LanePrinter::has_statement(std::uint32_t node) const {
  return is_packed(node) && !is_inner_[index_of(node)] &&
         first_node(program_.packs[index_of(node)]) == node;
}

LanePack LanePrinter::beside(std::uint32_t node) const {
  if (!is_packed(node)) return {node};
  LanePack nodes = program_.packs[index_of(node)];
  std::erase(nodes, kNoNode);
  return nodes;
}

Op LanePrinter::op_of(std::size_t pack) const {
  return program_.graph.nodes()[first_node(program_.packs[pack])].op;
}

/// One value for all lanes is a scalar, which the language spreads; another pack in place is its
/// name.
LanePrinter::Operand LanePrinter::operand(const LanePack& nodes, Op user, bool is_right,
                                          const ExpressionPrinter& expressions) const {
  const auto some = std::find_if(nodes.begin(), nodes.end(), [](auto n) { return n != kNoNode; });
  const bool same =
      std::all_of(nodes.begin(), nodes.end(), [&](auto n) { return n == kNoNode || n == *some; });
  if (same) {
    return {expressions.atom(*some), kSpread};
  }
  if (const int pack = pack_in_place(nodes); pack >= 0) {
    const auto p = static_cast<std::size_t>(pack);
    const std::size_t width = program_.packs[p].size();
    if (!is_inner_[p]) {
      return {pack_names_[p], width};
    }
    const bool own_is_sum = is_sum(op_of(p));
    const bool loose =
        is_sum(user) && !own_is_sum && expressions.syntax().parentheses == Parentheses::needed;
    const bool binds = expressions.syntax().combine_lanes != nullptr || loose ||
                       (is_sum(user) == own_is_sum && !is_right);
    const std::string inner = formula(p, expressions);
    return {binds ? inner : fmt::format("({})", inner), width};
  }
  std::string list;
  for (const std::uint32_t node : nodes) {
    // An empty lane repeats a value: whatever it computes is not read.
    list += (list.empty() ? "" : ", ") + expressions.reference(node != kNoNode ? node : *some);
  }
  const Syntax& syntax = expressions.syntax();
  return {syntax.make_lanes(syntax, nodes.size(), list), nodes.size()};
}

/// No language has operations between lanes of different numbers: rather no code than such code.
void LanePrinter::expect_equal_widths(std::size_t pack, const Operand& a, const Operand& b) const {
  const std::size_t width = program_.packs[pack].size();
  const auto fits = [&](const Operand& each) {
    return each.width == kSpread || each.width == width;
  };
  const bool is_width = width == 2 || width == 4 || width == 8;
  const bool in_lanes = a.width != kSpread || b.width != kSpread;
  if (is_width && in_lanes && fits(a) && fits(b)) return;
  throw std::logic_error(fmt::format("{}: `{}` of {} lanes reads {} and {} lanes", program_.name,
                                     pack_names_[pack], width, a.width, b.width));
}

std::string LanePrinter::in_lanes(const Operand& operand, std::size_t pack,
                                  const Syntax& syntax) const {
  if (operand.width != kSpread) return operand.text;
  return syntax.spread(syntax, program_.packs[pack].size(), operand.text);
}

std::string LanePrinter::formula(std::size_t pack, const ExpressionPrinter& expressions) const {
  const Op op = op_of(pack);
  const Syntax& syntax = expressions.syntax();
  const std::string_view sign = syntax.sign(op);
  const std::size_t width = program_.packs[pack].size();
  if (operation(op).operands == 1) {
    const Operand only = operand(operands_[pack].a, Op::div, true, expressions);
    expect_equal_widths(pack, only, only);
    if (syntax.combine_lanes == nullptr) return fmt::format("{}{}", sign, only.text);
    return syntax.combine_lanes(syntax, width, op, in_lanes(only, pack, syntax), "");
  }
  const Operand a = operand(operands_[pack].a, op, false, expressions);
  const Operand b = operand(operands_[pack].b, op, true, expressions);
  expect_equal_widths(pack, a, b);
  if (syntax.combine_lanes == nullptr) return fmt::format("{} {} {}", a.text, sign, b.text);
  return syntax.combine_lanes(syntax, width, op, in_lanes(a, pack, syntax),
                              in_lanes(b, pack, syntax));
}

std::string LanePrinter::statement(std::uint32_t node, const ExpressionPrinter& expressions) const {
  const std::size_t pack = index_of(node);
  const Syntax& syntax = expressions.syntax();
  const std::string type = syntax.lanes(syntax, program_.packs[pack].size());
  return syntax.keep(type, pack_names_[pack], formula(pack, expressions));
}

}  // namespace treeline
