#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace treeline {

/// Calls between functions and the stack that each needs, as the compiler measured it.
struct CallGraph {
  struct Node {
    std::optional<int> own_bytes;  ///< absent: not compiled here, or without a bound
    std::set<std::string> calls;   ///< symbols
  };
  std::map<std::string, Node> functions;  ///< by symbol
};

/// Adds what a file of GCC's -fcallgraph-info=su says.
void read_call_graph(std::string_view text, CallGraph& graph);

/// Stack along the deepest path of calls, and the functions on any path whose stack is unknown.
struct StackUse {
  std::optional<int> bytes;  ///< of the known functions; absent if there is recursion
  std::set<std::string> unknown;
};
StackUse add_stack(const CallGraph& graph, const std::string& symbol);

}  // namespace treeline
