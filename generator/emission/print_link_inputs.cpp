#include "emission/print_link_inputs.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "emission/wrap_line.hpp"

namespace treeline {
namespace {

const char* function_of(const LinkInput& input) {
  switch (input.gives) {
    case LinkInput::Gives::bodies:
      return "add_bodies";
    case LinkInput::Gives::origins:
      return "move_points";
    case LinkInput::Gives::axes:
      break;
  }
  return "turn_points";
}

std::string call(const std::string& function, const std::string& arguments) {
  return wrap_line(fmt::format("{}({});", function, arguments), 2);
}

/// An array, filled from the constants.
std::string print_array(const char* type, const char* array, const std::string& from,
                        std::size_t count, const LoopNames& names) {
  return fmt::format("  {} {}[{}];\n", names.type(type), array, count) +
         call(names.function(fmt::format("copy_{}", array)),
              fmt::format("{}, {}, {}", from, count, names.array(array)));
}

}  // namespace

bool is_of_links(const LinkInput& input) {
  return input.gives == LinkInput::Gives::bodies;
}

bool moves_points(const LinkTableData& table) {
  return !std::all_of(table.inputs.begin(), table.inputs.end(), is_of_links);
}

std::string frames_name(const LinkInput& input) {
  return input.argument + "_frames";
}

std::string print_gravity(const LinkLoops* loops, const std::string& constant) {
  if (loops == nullptr || loops->gravity.empty()) return constant;
  return fmt::format("{{{0}[0], {0}[1], {0}[2]}}", loops->gravity);
}

std::string print_link_inputs(const LinkLoops& loops, const LoopNames& names) {
  const LinkTableData& table = loops.table;
  std::string text;
  if (!table.loaded_links.empty()) {
    const std::string from = names.constant("links") + ", " + names.constant("loaded_links");
    text += print_array("LinkBody", "bodies", from, table.loaded_links.size(), names);
  }
  if (moves_points(table)) {
    text +=
        print_array("LinkPoint", "points", names.constant("points"), table.points.size(), names);
  }
  for (const LinkInput& input : table.inputs) {
    const bool of_links = is_of_links(input);
    text +=
        call(names.function(function_of(input)),
             fmt::format("{}, {}, {}, {}", names.constant(frames_name(input)), input.frames.size(),
                         names.array(input.argument), names.array(of_links ? "bodies" : "points")));
  }
  return text;
}

}  // namespace treeline
