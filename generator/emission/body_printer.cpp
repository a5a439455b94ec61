#include "emission/body_printer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "emission/body_steps.hpp"
#include "emission/comment.hpp"
#include "emission/emitted_text.hpp"
#include "program/find_sections.hpp"

namespace treeline {
namespace {

constexpr std::size_t kHeadingColumns = 94;  // behind blanks and the mark of a comment

const std::set<SectionTitle> kConstants = {{0, "", "constants"}};
const std::set<SectionTitle> kTrigonometry = {{0, "", "sines and cosines"}};

}  // namespace

BodyPrinter::BodyPrinter(const Program& program, const Syntax& syntax, std::set<std::string> taken,
                         std::size_t most_angles)
    : syntax_(syntax),
      graph_(program.graph),
      most_angles_(most_angles),
      selected_(select_statements(program)),
      known_constants_(name_constants(program, taken)),
      names_(choose_names(program, selected_, std::move(taken))),
      kept_elsewhere_(selected_.size(), false),
      lanes_(program, syntax, names_),
      expressions_(graph_, names_, syntax),
      stores_(graph_.nodes().size()),
      sections_(find_sections(graph_)) {
  for (const Result& result : program.results) {
    for (std::size_t i = 0; i < result.values.size(); ++i) {
      stores_[result.values[i].node()].push_back(
          {result.argument.name, fmt::format("{}[{}]", result.argument.name, i), result.values[i]});
    }
  }
}

std::uint32_t BodyPrinter::count() const {
  return static_cast<std::uint32_t>(graph_.nodes().size());
}

void BodyPrinter::keep_in(std::uint32_t node, const std::string& place) {
  names_[node] = place;
  kept_elsewhere_[node] = true;
}

std::string BodyPrinter::print(std::uint32_t first, std::uint32_t end,
                               const NamedConstants& constants) {
  statements_.clear();
  batches_ = 0;
  if (first == kNoNode) print_node(first++);  // results that are 0
  for (const auto& [node, name] : constants) {
    statements_.push_back(
        {syntax_.keep(syntax_.number, name, syntax_.literal(constant(node))), kConstants});
    names_[node] = name;
  }
  for (std::uint32_t i = first; i < end;) {
    if (begins_run(i)) {
      const std::uint32_t behind = end_of_run(i);
      print_trigonometry(i, behind);
      i = behind;
    } else {
      print_node(i);
      ++i;
    }
  }
  return join_statements();
}

std::string BodyPrinter::join_statements() const {
  std::vector<std::set<SectionTitle>> titles;
  for (const Statement& statement : statements_) titles.push_back(statement.titles);
  const std::vector<Heading> headings = choose_headings(titles);
  auto heading = headings.begin();
  std::string text;
  for (std::size_t i = 0; i < statements_.size(); ++i) {
    if (heading != headings.end() && heading->first == i) {
      const std::string lines = wrap_text(heading->text, kHeadingColumns);
      text += (i == 0 ? "" : "\n") + comment(fmt::format("  {}", syntax_.comment), lines);
      ++heading;
    }
    text += wrap_line(statements_[i].text, 2);
  }
  return text;
}

/// Sections to which a node's statement belongs; none if the node computes nothing.
std::set<SectionTitle> BodyPrinter::titles_of(std::uint32_t node) const {
  std::set<SectionTitle> titles;
  for (const std::uint32_t own : lanes_.beside(node)) {
    const Graph::Section* const section = sections_[own];
    const bool is_known = section != nullptr && !section->title().step.empty();
    if (is_known && operation(graph_.nodes()[own].op).operands > 0) titles.insert(section->title());
  }
  return titles;
}

std::string BodyPrinter::define(std::uint32_t node, const std::string& value) const {
  return kept_elsewhere_[node] ? syntax_.store(syntax_, names_[node], value)
                               : syntax_.keep(syntax_.number, names_[node], value);
}

void BodyPrinter::print_node(std::uint32_t node) {
  if (lanes_.has_statement(node)) {
    statements_.push_back({lanes_.statement(node, expressions_), titles_of(node)});
  } else if (selected_[node] && !lanes_.is_packed(node)) {
    statements_.push_back({define(node, expressions_.formula(node)), titles_of(node)});
  }
  print_stores(node);
}

void BodyPrinter::print_stores(std::uint32_t node) {
  for (const Store& store : stores_[node]) {
    statements_.push_back(
        {syntax_.store(syntax_, store.target, expressions_.signed_reference(store.value)),
         titles_of(node)});
  }
}

bool BodyPrinter::begins_run(std::uint32_t node) const {
  return is_trigonometric(graph_.nodes()[node].op) && selected_[node];
}

/// The node behind the sines and cosines from `first` on that one call computes.
std::uint32_t BodyPrinter::end_of_run(std::uint32_t first) const {
  std::set<std::uint32_t> angles;
  std::uint32_t end = first;
  for (; end < count() && is_trigonometric(graph_.nodes()[end].op) && graph_.nodes()[end].a < first;
       ++end) {
    angles.insert(graph_.nodes()[end].a);
    if (angles.size() > most_angles_) break;
  }
  return end;
}

std::vector<std::uint32_t> BodyPrinter::angles_of(std::uint32_t first, std::uint32_t end) const {
  std::vector<std::uint32_t> angles;
  for (std::uint32_t i = first; i < end; ++i) {
    const std::uint32_t angle = graph_.nodes()[i].a;
    if (std::find(angles.begin(), angles.end(), angle) == angles.end()) angles.push_back(angle);
  }
  return angles;
}

void BodyPrinter::print_trigonometry(std::uint32_t first, std::uint32_t end) {
  const std::vector<std::uint32_t> angles = angles_of(first, end);
  const std::string suffix = batches_++ == 0 ? "" : std::to_string(batches_);
  print_call(angles, suffix);
  for (std::uint32_t i = first; i < end; ++i) {
    const Node& node = graph_.nodes()[i];
    const auto lane = std::find(angles.begin(), angles.end(), node.a) - angles.begin();
    const std::string element =
        fmt::format("{}{}[{}]", node.op == Op::sin ? "sines" : "cosines", suffix, lane);
    statements_.push_back({define(i, syntax_.read(element)), kTrigonometry});
    print_stores(i);
  }
}

void BodyPrinter::print_call(const std::vector<std::uint32_t>& angles, const std::string& suffix) {
  std::string list;
  for (const std::uint32_t angle : angles) {
    list += (list.empty() ? "" : ", ") + syntax_.read(expressions_.reference(angle));
  }
  for (const std::string& statement : syntax_.take_sines(syntax_, suffix, angles.size(), list)) {
    statements_.push_back({statement, kTrigonometry});
  }
}

/// Adds what a reference to the node reads.
void BodyPrinter::add_reads(std::uint32_t node, BodyUnit& unit) const {
  const Node& what = graph_.nodes()[node];
  if (what.op == Op::constant) {
    unit.constants.insert(node);
  } else if (what.op == Op::input) {
    const std::string& input = graph_.inputs()[what.a];
    unit.arguments.insert(input.substr(0, input.find('[')));
  } else if (selected_[node]) {
    unit.values.insert(node);
  } else {
    add_operands(node, unit);
  }
}

void BodyPrinter::add_operands(std::uint32_t node, BodyUnit& unit) const {
  const Node& what = graph_.nodes()[node];
  const int operands = operation(what.op).operands;
  if (operands >= 1) add_reads(what.a, unit);
  if (operands == 2) add_reads(what.b, unit);
}

void BodyPrinter::add_stores(std::uint32_t node, BodyUnit& unit) const {
  for (const Store& store : stores_[node]) {
    ++unit.statements;
    unit.results.insert(store.result);
    add_reads(node, unit);
  }
}

std::vector<BodyUnit> BodyPrinter::list_units() const {
  constexpr int kOfCall = 4;  // three arrays, and the call itself
  std::vector<BodyUnit> units;
  for (std::uint32_t i = 0; i < count();) {
    BodyUnit unit;
    unit.first = i;
    unit.end = begins_run(i) ? end_of_run(i) : i + 1;
    unit.statements = begins_run(i) ? kOfCall : 0;
    for (; i < unit.end; ++i) {
      if (selected_[i]) {
        ++unit.statements;
        add_operands(i, unit);
      }
      add_stores(i, unit);
    }
    for (std::uint32_t own = unit.first; own < unit.end; ++own) unit.values.erase(own);
    if (unit.statements > 0) units.push_back(std::move(unit));
  }
  return units;
}

}  // namespace treeline
