#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "board/board_report.hpp"
#include "board/cross_compile.hpp"
#include "target/target.hpp"

namespace treeline {

/// Bytes in an object file by kind of section.
struct SectionBytes {
  int text = 0, constants = 0, variables = 0;
};

/// Adds up the sections that `size -A` lists.
SectionBytes add_sections(std::string_view listing);

/// Whether a symbol belongs to the compiler's own arithmetic: libgcc, for what the processor has no
/// instruction for.
bool is_arithmetic(const std::string& symbol);

/// Symbols that `nm -u` lists.
std::vector<std::string> list_undefined(std::string_view listing);

/// Measures the compiled functions: code, stack, symbols. `cycles` of each is the mean of its
/// instructions. `name` is the namespace, or the prefix in C.
std::vector<BoardFunction> measure_objects(const BoardObjects& objects, const std::string& name,
                                           const std::vector<GeneratedFunction>& functions,
                                           const Target& target, const Tools& tools);

/// Measures a function that consists of the objects from index `first` on to `last`: the
/// controller's step, the self-test.
BoardFunction measure_unit(const BoardObjects& objects, const std::string& symbol,
                           std::size_t first, std::size_t last, const Target& target,
                           const Tools& tools);

/// Kinds of instructions whose cycles differ.
enum class InstructionKind {
  other,
  memory,
  branch,
  arithmetic,
  fused,
  divide_float,
  divide_double
};

/// Kind of an instruction of Arm or RISC-V, as objdump prints it.
InstructionKind kind_of_instruction(std::string_view mnemonic, std::string_view operands);

/// Number of registers that an instruction loads or stores: those between braces, at least 1.
int count_registers(std::string_view operands);

/// Mean cycles of the instructions in objdump's listing; 1 if there are none.
double mean_cycles(std::string_view listing, const CycleCosts& costs);

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
