#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "emission/print_expression.hpp"
#include "emission/print_lanes.hpp"
#include "emission/syntax.hpp"
#include "program/program.hpp"

namespace treeline {

/// Statements that stay together, of nodes `first` up to `end`: those of one node, or of sines and
/// cosines that are computed by one call.
struct BodyUnit {
  std::uint32_t first = 0, end = 0;
  int statements = 0;
  std::set<std::uint32_t> values;     ///< nodes with a name that they read
  std::set<std::uint32_t> constants;  ///< that they read
  std::set<std::string> arguments;    ///< that they read
  std::set<std::string> results;      ///< that they write
};

/// Nodes of constants and the names of their locals.
using NamedConstants = std::map<std::uint32_t, std::string>;

/// Prints the statements of a function in the order of the program's nodes.
class BodyPrinter {
 public:
  /// `taken` are identifiers that a local may not have; `most_angles` those of one call.
  BodyPrinter(const Program& program, const Syntax& syntax, std::set<std::string> taken,
              std::size_t most_angles);

  /// All units with statements, in order.
  [[nodiscard]] std::vector<BodyUnit> list_units() const;
  /// The statements of these nodes below their headings, indented by two blanks. These constants
  /// are locals with names.
  std::string print(std::uint32_t first, std::uint32_t end, const NamedConstants& constants);

  [[nodiscard]] const std::string& name_of(std::uint32_t node) const { return names_[node]; }
  [[nodiscard]] std::uint32_t count() const;
  [[nodiscard]] double constant(std::uint32_t node) const { return graph_.nodes()[node].value; }
  [[nodiscard]] bool has_statement(std::uint32_t node) const { return selected_[node]; }
  /// Constants with names that tell where they come from: `mass_3`.
  [[nodiscard]] const NamedConstants& known_constants() const { return known_constants_; }
  /// From now on the value is kept where `place` says, which is declared elsewhere.
  void keep_in(std::uint32_t node, const std::string& place);

 private:
  struct Store {
    std::string result;
    std::string target;
    Expression value;
  };

  struct Statement {
    std::string text;
    std::set<SectionTitle> titles;
  };

  [[nodiscard]] std::set<SectionTitle> titles_of(std::uint32_t node) const;
  [[nodiscard]] std::string join_statements() const;
  [[nodiscard]] std::string define(std::uint32_t node, const std::string& value) const;
  void print_node(std::uint32_t node);
  void print_stores(std::uint32_t node);
  [[nodiscard]] bool begins_run(std::uint32_t node) const;
  [[nodiscard]] std::uint32_t end_of_run(std::uint32_t first) const;
  void print_trigonometry(std::uint32_t first, std::uint32_t end);
  void print_call(const std::vector<std::uint32_t>& angles, const std::string& suffix);
  [[nodiscard]] std::vector<std::uint32_t> angles_of(std::uint32_t first, std::uint32_t end) const;
  void add_reads(std::uint32_t node, BodyUnit& unit) const;
  void add_operands(std::uint32_t node, BodyUnit& unit) const;
  void add_stores(std::uint32_t node, BodyUnit& unit) const;

  const Syntax& syntax_;
  const Graph& graph_;
  std::size_t most_angles_;
  std::vector<bool> selected_;
  NamedConstants known_constants_;
  std::vector<std::string> names_;
  std::vector<bool> kept_elsewhere_;
  LanePrinter lanes_;
  ExpressionPrinter expressions_;
  std::vector<std::vector<Store>> stores_;
  std::vector<const Graph::Section*> sections_;  // by node
  std::vector<Statement> statements_;
  int batches_ = 0;
};

}  // namespace treeline
