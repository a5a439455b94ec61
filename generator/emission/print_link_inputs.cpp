#include "emission/print_link_inputs.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "emission/wrap_line.hpp"

namespace treeline {
namespace {

const char* function_of(const LinkInput& input) {
  switch (input.gives) {
    case LinkInput::Gives::bodies:
      return input.entries.empty() ? "add_bodies" : "add_parts_of_bodies";
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

/// What fills the array of rotors, once the table is complete.
std::string print_rotors(const LoopNames& names) {
  return call(names.function("find_rotors"),
              fmt::format("{}, {}, {}", names.table, names.array("qd"), names.array("rotors")));
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

std::string entries_name(const LinkInput& input) {
  return input.argument + "_entries";
}

std::string print_members(const LinkLoops& loops, const LoopNames& names, const std::string& type,
                          const std::vector<std::string>& gravity, bool all) {
  const LinkTableData& table = loops.table;
  std::string text = wrap_line(fmt::format("{} table;", type), 2);
  const auto set = [&](const char* member, bool has, const std::string& value) {
    if (has || all) {
      text += fmt::format("  table.{} = {};\n", member, has ? value : names.none);
    }
  };
  const auto set_number = [&](const char* member, std::size_t value) {
    if (value > 0 || all) text += fmt::format("  table.{} = {};\n", member, value);
  };
  set("links", true, names.constant("links"));
  set_number("count", table.links.size());
  set_number("slots", static_cast<std::size_t>(table.slots));
  for (std::size_t k = 0; k < gravity.size(); ++k) {
    text +=
        fmt::format("  table.gravity[{}] = {};\n", k,
                    loops.gravity.empty() ? gravity[k] : fmt::format("{}[{}]", loops.gravity, k));
  }
  set("points", !table.points.empty(),
      moves_points(table) ? names.array("points") : names.constant("points"));
  set_number("point_count", table.points.size());
  set("point_rows", !table.rows.empty(), names.constant("point_rows"));
  set_number("rows", table.rows.size());
  set("drives", !table.drives.empty(), names.constant("drives"));
  set("frictions", !table.frictions.empty(), names.constant("frictions"));
  set("couplings", !table.couplings.empty(), names.constant("couplings"));
  set_number("joints", static_cast<std::size_t>(table.joints));
  set("ball_axes", !table.balls.empty(), names.constant("ball_axes"));
  set("row_entries", !table.row_entries.empty(), names.constant("row_entries"));
  const bool pushed = !loops.f_ext.empty();
  set("pushed_points", pushed, names.constant("pushed_points"));
  set_number("pushed_count", pushed ? table.pushed_points.size() : 0);
  set("f_ext", pushed, names.array(loops.f_ext));
  set("bodies", !table.loaded_links.empty(), names.array("bodies"));
  set("loaded_links", !table.loaded_links.empty(), names.constant("loaded_links"));
  set_number("loaded_count", table.loaded_links.size());
  const bool stepped = !loops.step.empty();
  set("rotors", stepped, names.array("rotors"));
  set("step", stepped, names.array(loops.step));
  return text + (stepped ? print_rotors(names) : "");
}

std::string print_link_inputs(const LinkLoops& loops, const LoopNames& names) {
  const LinkTableData& table = loops.table;
  std::string text;
  if (!loops.step.empty()) {
    text += fmt::format("  {} rotors[{}];\n", names.number, table.links.size());
  }
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
    const std::string entries =
        input.entries.empty()
            ? std::string()
            : fmt::format("{}, {}, ", names.constant(entries_name(input)), input.entries.size());
    text += call(names.function(function_of(input)),
                 fmt::format("{}, {}, {}{}, {}", names.constant(frames_name(input)),
                             input.frames.size(), entries, names.array(input.argument),
                             names.array(of_links ? "bodies" : "points")));
  }
  return text;
}

}  // namespace treeline
