#include "board/measure_objects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <sstream>

#include "emission/backend.hpp"

namespace treeline {
namespace {

/// Symbol of a function, in C++ up to its arguments.
std::string beginning_of_symbol(Language language, const std::string& name,
                                const GeneratedFunction& generated) {
  const std::string& function = generated.program.name;
  if (!backend_of(language).has_namespaces) return fmt::format("{}_{}", name, function);
  const std::string space = is_composed(generated) ? "composed" : name;
  return fmt::format("_ZN{}{}{}{}E", space.size(), space, function.size(), function);
}

/// The symbol of a call graph that begins so; empty if there is none.
std::string find_symbol(const CallGraph& graph, const std::string& beginning) {
  const auto found = graph.functions.lower_bound(beginning);
  const bool is_it = found != graph.functions.end() && found->first.starts_with(beginning);
  return is_it ? found->first : std::string();
}

CallGraph read_call_graphs(const BoardObjects& objects) {
  CallGraph graph;
  for (const std::string& stem : objects.stems) {
    read_call_graph(read_file(objects.folder / (stem + ".ci")), graph);
  }
  return graph;
}

/// Outputs of one of the compiler's companions for all functions.
std::vector<std::string> ask(const std::string& program, const std::string& option,
                             const BoardObjects& objects) {
  std::vector<Command> commands;
  for (const std::string& stem : objects.stems) {
    commands.push_back({program, option, objects.folder / (stem + ".o")});
  }
  std::vector<std::string> outputs;
  for (CommandOutcome& outcome : run_commands(commands, 1, objects.folder)) {
    outputs.push_back(std::move(outcome.output));
  }
  return outputs;
}

/// Stack of the function whose symbol begins so, without that of the compiler's library. Absent if
/// any other function on a path is unknown.
std::optional<int> stack_of(const CallGraph& graph, const std::string& beginning) {
  const StackUse use = add_stack(graph, find_symbol(graph, beginning));
  const bool known = std::all_of(use.unknown.begin(), use.unknown.end(), is_arithmetic);
  return known ? use.bytes : std::nullopt;
}

void sort_symbols(const std::string& listing, const CallGraph& graph, BoardFunction& function) {
  for (const std::string& symbol : list_undefined(listing)) {
    const auto found = graph.functions.find(symbol);
    if (found != graph.functions.end() && found->second.own_bytes) continue;
    (is_arithmetic(symbol) ? function.arithmetic : function.strays).push_back(symbol);
  }
}

}  // namespace

SectionBytes add_sections(std::string_view listing) {
  SectionBytes bytes;
  std::istringstream lines{std::string(listing)};
  for (std::string line; std::getline(lines, line);) {
    const auto words = split_words(line);  // name, size, address
    if (words.size() != 3) continue;
    const int size = std::atoi(words[1].c_str());
    const auto is = [&](const char* section) { return words[0].starts_with(section); };
    if (is(".text")) bytes.text += size;
    if (is(".rodata") || is(".srodata")) bytes.constants += size;
    if (is(".data") || is(".sdata") || is(".bss") || is(".sbss")) bytes.variables += size;
  }
  return bytes;
}

bool is_arithmetic(const std::string& symbol) {
  constexpr std::string_view kArm = "__aeabi_";
  if (symbol.starts_with(kArm)) {
    const std::string_view name = std::string_view(symbol).substr(kArm.size());
    constexpr std::string_view kTypes[] = {"d", "f", "i", "l", "cd", "cf", "ci", "cl", "ui", "ul"};
    return std::any_of(std::begin(kTypes), std::end(kTypes),
                       [&](std::string_view type) { return name.starts_with(type); });
  }
  constexpr std::string_view kSymbolFronts[] = {
      "__add",   "__sub",    "__mul",   "__div",  "__udiv", "__mod",  "__umod",  "__neg",
      "__eq",    "__ne",     "__lt",    "__le",   "__gt",   "__ge",   "__unord", "__fix",
      "__float", "__extend", "__trunc", "__ashl", "__ashr", "__lshr", "__clz"};
  // As __muldf3: an operation, the types of its operands, and how many they are.
  const std::size_t end = symbol.find_last_not_of("234");
  const bool ends_so = end != symbol.npos && end + 2 >= symbol.size() &&
                       std::string_view("sdtfi").find(symbol[end]) != std::string_view::npos;
  return ends_so && std::any_of(std::begin(kSymbolFronts), std::end(kSymbolFronts),
                                [&](std::string_view front) { return symbol.starts_with(front); });
}

std::vector<std::string> list_undefined(std::string_view listing) {
  std::vector<std::string> symbols;
  std::istringstream lines{std::string(listing)};
  for (std::string line; std::getline(lines, line);) {
    const auto words = split_words(line);
    if (words.size() == 2 && (words[0] == "U" || words[0] == "w")) symbols.push_back(words[1]);
  }
  return symbols;
}

std::vector<BoardFunction> measure_objects(const BoardObjects& objects, const std::string& name,
                                           const std::vector<GeneratedFunction>& functions,
                                           const Target& target, const Tools& tools) {
  const CallGraph graph = read_call_graphs(objects);
  const auto sizes = ask(tools.prefix + "size", "-A", objects);
  const auto symbols = ask(tools.prefix + "nm", "-u", objects);
  const auto listings = ask(tools.prefix + "objdump", "-d", objects);
  std::vector<BoardFunction> measured(functions.size());
  for (std::size_t i = 0; i < functions.size(); ++i) {
    BoardFunction& function = measured[i];
    function.name = source_stem(functions[i]);
    function.is_long = objects.flags[i].is_long;
    function.is_small = objects.flags[i].is_small;
    const SectionBytes bytes = add_sections(sizes[i]);
    function.text_bytes = bytes.text;
    function.constant_bytes = bytes.constants;
    function.static_bytes = bytes.variables;
    function.stack_bytes =
        stack_of(graph, beginning_of_symbol(objects.language, name, functions[i]));
    sort_symbols(symbols[i], graph, function);
    function.cycles = mean_cycles(listings[i], target.cycles);
  }
  return measured;
}

BoardFunction measure_unit(const BoardObjects& objects, const std::string& symbol,
                           std::size_t first, std::size_t last, const Target& target,
                           const Tools& tools) {
  const CallGraph graph = read_call_graphs(objects);
  const auto sizes = ask(tools.prefix + "size", "-A", objects);
  const auto symbols = ask(tools.prefix + "nm", "-u", objects);
  const auto listings = ask(tools.prefix + "objdump", "-d", objects);
  BoardFunction unit;
  unit.name = symbol;
  std::string listing;
  for (std::size_t i = first; i < last; ++i) {
    const SectionBytes bytes = add_sections(sizes[i]);
    unit.text_bytes += bytes.text;
    unit.constant_bytes += bytes.constants;
    unit.static_bytes += bytes.variables;
    sort_symbols(symbols[i], graph, unit);
    listing += listings[i];
  }
  for (auto* list : {&unit.arithmetic, &unit.strays}) {
    std::sort(list->begin(), list->end());
    list->erase(std::unique(list->begin(), list->end()), list->end());
  }
  unit.stack_bytes = stack_of(graph, unit.name);
  unit.cycles = mean_cycles(listing, target.cycles);
  return unit;
}

}  // namespace treeline
