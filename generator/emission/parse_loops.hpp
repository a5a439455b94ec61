#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace treeline {

/// A declaration of the runtime's loops over links: a struct, or a function.
struct LoopItem {
  std::string comment;     ///< the lines of comment before it
  std::string parameters;  ///< of its template: `int power, class Real`
  std::string head;        ///< in one line: `struct Turn`, `void clear(Real (&v)[3]) noexcept`
  std::string body;        ///< the lines between its braces
  std::string source;      ///< all of this as the header has it

  [[nodiscard]] bool is_struct() const { return head.starts_with("struct "); }
  /// Name of the struct or function.
  [[nodiscard]] std::string name() const;
};

/// The declarations of a header `runtime/core/link_*.hpp`, in their order.
std::vector<LoopItem> parse_loops(std::string_view header);

/// Whether a name may have this character.
bool is_of_word(char c);

/// `text` with each statement, head of a loop and branch in one line. Comments keep their lines.
std::vector<std::string> join_statements(std::string_view text);

}  // namespace treeline
