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
  BodyPrinter(const Program& program, const Syntax& syntax, const std::set<std::string>& taken)
      : syntax_(syntax),
        graph_(program.graph),
        selected_(select_statements(program)),
        names_(choose_names(program, selected_, taken)),
        lanes_(program, names_),
        expressions_(graph_, names_, syntax),
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
      text_ += fmt::format("{}  {} {}\n", text_.empty() ? "" : "\n", syntax_.comment, title_);
      printed_title_ = title_;
    }
    text_ += wrap_line(statement, 2);
  }

  void print_node(std::uint32_t node) {
    if (lanes_.has_statement(node)) {
      print_statement(lanes_.statement(node, expressions_));
    } else if (selected_[node] && !lanes_.is_packed(node)) {
      print_statement(syntax_.keep(syntax_.number, names_[node], expressions_.formula(node)));
    }
    print_stores(node);
  }

  void print_stores(std::uint32_t node) {
    for (const Store& store : stores_[node]) {
      print_statement(syntax_.store(store.target, expressions_.signed_reference(store.value)));
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
      const std::string element =
          fmt::format("{}{}[{}]", node.op == Op::sin ? "sines" : "cosines", suffix, lane);
      text_ += wrap_line(syntax_.keep(syntax_.number, names_[i], syntax_.read(element)), 2);
      print_stores(i);
    }
    return end;
  }

  void print_call(const std::vector<std::uint32_t>& angles, const std::string& suffix) {
    std::string list;
    for (const std::uint32_t angle : angles) {
      list += (list.empty() ? "" : ", ") + syntax_.read(expressions_.reference(angle));
    }
    for (const std::string& statement : syntax_.take_sines(syntax_, suffix, angles.size(), list)) {
      text_ += wrap_line(statement, 2);
    }
  }

  const Syntax& syntax_;
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

std::string print_body(const Program& program, const Syntax& syntax,
                       const std::set<std::string>& taken) {
  return BodyPrinter(program, syntax, taken).print();
}

}  // namespace treeline
