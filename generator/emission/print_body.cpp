#include "emission/print_body.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "emission/choose_names.hpp"
#include "emission/print_expression.hpp"
#include "emission/print_lanes.hpp"
#include "emission/select_statements.hpp"
#include "emission/wrap_line.hpp"

namespace treeline {
namespace {

class BodyPrinter {
 public:
  BodyPrinter(const Program& program, bool single_precision, const std::set<std::string>& taken,
              std::string_view number)
      : number_(number),
        graph_(program.graph),
        selected_(select_statements(program)),
        names_(choose_names(program, selected_, taken)),
        lanes_(program, names_),
        expressions_(graph_, names_, single_precision),
        stores_(graph_.nodes().size()) {
    for (const Result& result : program.results) {
      for (std::size_t i = 0; i < result.values.size(); ++i) {
        stores_[result.values[i].node()].push_back(
            {fmt::format("{}[{}]", result.argument.name, i), result.values[i]});
      }
    }
  }

  std::string print() {
    for (std::uint32_t i = 0; i < graph_.nodes().size();) {
      enter_sections(i);
      if (is_trigonometric(graph_.nodes()[i].op) && selected_[i]) {
        i = print_trigonometry(i);
      } else {
        print_node(i);
        ++i;
      }
    }
    return std::move(text_);
  }

 private:
  struct Store {
    std::string target;
    Expression value;
  };

  void enter_sections(std::uint32_t node) {
    for (; next_section_ < graph_.sections().size() &&
           graph_.sections()[next_section_].first_node <= node;
         ++next_section_) {
      title_ = graph_.sections()[next_section_].title;
    }
  }

  /// Writes one statement, below its section's title when the last statement was of another.
  void print_statement(const std::string& statement) {
    if (title_ != printed_title_ && !title_.empty()) {
      text_ += fmt::format("{}  // {}\n", text_.empty() ? "" : "\n", title_);
      printed_title_ = title_;
    }
    text_ += wrap_line(statement, 2);
  }

  void print_node(std::uint32_t node) {
    if (lanes_.has_statement(node)) {
      print_statement(lanes_.statement(node, expressions_));
    } else if (selected_[node] && !lanes_.is_packed(node)) {
      print_statement(
          fmt::format("const {} {} = {};", number_, names_[node], expressions_.formula(node)));
    }
    print_stores(node);
  }

  void print_stores(std::uint32_t node) {
    for (const Store& store : stores_[node]) {
      print_statement(
          fmt::format("{} = {};", store.target, expressions_.signed_reference(store.value)));
    }
  }

  /// The run of sines and cosines that begins with node `first`, by one call. Returns the node
  /// after the run.
  std::uint32_t print_trigonometry(std::uint32_t first) {
    std::vector<std::uint32_t> angles;
    std::uint32_t end = first;
    for (; end < graph_.nodes().size() && is_trigonometric(graph_.nodes()[end].op) &&
           graph_.nodes()[end].a < first;
         ++end) {
      if (std::find(angles.begin(), angles.end(), graph_.nodes()[end].a) == angles.end()) {
        angles.push_back(graph_.nodes()[end].a);
      }
    }
    const std::string suffix = batches_++ == 0 ? "" : std::to_string(batches_);
    print_call(angles, suffix);
    for (std::uint32_t i = first; i < end; ++i) {
      const Node& node = graph_.nodes()[i];
      const auto lane = std::find(angles.begin(), angles.end(), node.a) - angles.begin();
      enter_sections(i);
      text_ += wrap_line(
          fmt::format("const {} {} = {};", number_, names_[i],
                      copy_of(fmt::format("{}{}[{}]", node.op == Op::sin ? "sines" : "cosines",
                                          suffix, lane))),
          2);
      print_stores(i);
    }
    return end;
  }

  /// States are copied by a function that makes no call of memcpy.
  std::string copy_of(const std::string& number) const {
    return number_ == "Real" ? number : fmt::format("detail::copy_of({})", number);
  }

  void print_call(const std::vector<std::uint32_t>& angles, const std::string& suffix) {
    std::string list;
    for (const std::uint32_t angle : angles) {
      list += (list.empty() ? "" : ", ") + copy_of(expressions_.reference(angle));
    }
    text_ += wrap_line(
        fmt::format("const {} angles{}[{}] = {{{}}};", number_, suffix, angles.size(), list), 2);
    text_ += fmt::format("  {2} sines{0}[{1}];\n  {2} cosines{0}[{1}];\n", suffix, angles.size(),
                         number_);
    text_ += fmt::format("  detail::{1}(angles{0}, sines{0}, cosines{0});\n", suffix,
                         number_ == "Real" ? "sin_cos" : "sin_cos_states<Real, kStates>");
  }

  std::string_view number_;
  const Graph& graph_;
  std::vector<bool> selected_;
  std::vector<std::string> names_;
  LanePrinter lanes_;
  ExpressionPrinter expressions_;
  std::vector<std::vector<Store>> stores_;
  std::string text_;
  std::string title_, printed_title_;
  std::size_t next_section_ = 0;
  int batches_ = 0;
};

}  // namespace

std::string print_body(const Program& program, bool single_precision,
                       const std::set<std::string>& taken, std::string_view number) {
  return BodyPrinter(program, single_precision, taken, number).print();
}

}  // namespace treeline
