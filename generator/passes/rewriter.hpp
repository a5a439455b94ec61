#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "program/program.hpp"

namespace treeline {

/// Builds a program anew, node by node, through the constructors of Expression. Names and sections
/// are kept. For passes that replace nodes by other expressions.
class Rewriter {
 public:
  explicit Rewriter(const Program& program);

  /// Calls `replace(node, *this)` for every node in order, while the new graph is open; `replace`
  /// returns the node's new value. Returns the new program.
  template <class Replace>
  Program run(Replace replace) {
    const Graph::Scope scope(rewritten_.graph);
    for (std::uint32_t node = 0; node < values_.size(); ++node) {
      enter(node);
      values_[node] = replace(node, *this);
      keep_name(node);
    }
    return finish();
  }

  /// New value of an old node that was visited before.
  [[nodiscard]] Expression value(std::uint32_t node) const { return values_[node]; }

  /// Applies the node's operation to the new values of its operands.
  [[nodiscard]] Expression copy(std::uint32_t node) const;

 private:
  void enter(std::uint32_t node);
  void keep_name(std::uint32_t node);
  Program finish();

  const Program& program_;
  Program rewritten_;
  std::vector<Expression> values_;
  std::size_t next_section_ = 0;
};

}  // namespace treeline
