#include "emission/print_link_inputs.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "emission/wrap_line.hpp"

namespace treeline {
namespace {

/// The function that enters an argument into the table, and the array that it fills.
struct InputStep {
  const char* function;
  const char* array;
};

InputStep step_of(const LinkInput& input) {
  switch (input.gives) {
    case LinkInput::Gives::bodies:
      return {input.entries.empty() ? "add_bodies" : "add_parts_of_bodies", "bodies"};
    case LinkInput::Gives::origins:
      return {"move_points", "points"};
    case LinkInput::Gives::axes:
      return {"turn_points", "points"};
    case LinkInput::Gives::rotors:
      return {"give_rotors", "rotors"};
    case LinkInput::Gives::dampings:
      return {"give_dampings", "drives"};
    case LinkInput::Gives::frictions:
      break;
  }
  return {"give_frictions", "frictions"};
}

bool is_of_friction(const LinkInput& input) {
  return input.gives == LinkInput::Gives::dampings || input.gives == LinkInput::Gives::frictions;
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

/// Call that makes the table's rotors those of a step, once the table is complete.
std::string print_step(const LoopNames& names) {
  const std::string rotors = names.array("rotors");
  return call(names.function("find_rotors"),
              fmt::format("{}, {}, {}", names.table, names.array("qd"), rotors)) +
         fmt::format("  table.rotors = {};\n", rotors);
}

}  // namespace

bool moves_points(const LinkTableData& table) {
  return std::any_of(table.inputs.begin(), table.inputs.end(),
                     [](const LinkInput& input) { return input.is_of_points(); });
}

bool changes_rotors(const LinkLoops& loops) {
  return !loops.step.empty() || loops.table.gives(LinkInput::Gives::rotors);
}

bool changes_drives(const LinkLoops& loops) {
  return loops.uses_friction && loops.table.gives(LinkInput::Gives::dampings);
}

bool changes_frictions(const LinkLoops& loops) {
  return loops.uses_friction && loops.table.gives(LinkInput::Gives::frictions);
}

std::string frames_name(const LinkInput& input) {
  return input.argument + "_" + (input.numbers.empty() ? "frames" : step_of(input).array);
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
  set("drives", !table.drives.empty(),
      changes_drives(loops) ? names.array("drives") : names.constant("drives"));
  set("frictions", !table.frictions.empty(),
      changes_frictions(loops) ? names.array("frictions") : names.constant("frictions"));
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
  set("rotors", table.gives(LinkInput::Gives::rotors), names.array("rotors"));
  set("step", !loops.step.empty(), names.array(loops.step));
  return text + (loops.step.empty() ? "" : print_step(names));
}

/// The arrays that take the place of constants of links, as these are.
std::string print_link_arrays(const LinkLoops& loops, const LoopNames& names) {
  const LinkTableData& table = loops.table;
  const std::size_t links = table.links.size();
  std::string text;
  if (changes_rotors(loops)) {
    text += fmt::format("  {} rotors[{}];\n", names.number, links);
  }
  if (table.gives(LinkInput::Gives::rotors)) {
    text += call(names.function("copy_rotors"),
                 fmt::format("{}, {}, {}", names.constant("links"), links, names.array("rotors")));
  }
  if (changes_drives(loops)) {
    text += print_array("LinkDrive", "drives", names.constant("drives"), links, names);
  }
  if (changes_frictions(loops)) {
    text += print_array("LinkFriction", "frictions", names.constant("frictions"), links, names);
  }
  return text;
}

std::string print_link_inputs(const LinkLoops& loops, const LoopNames& names) {
  const LinkTableData& table = loops.table;
  std::string text = print_link_arrays(loops, names);
  if (!table.loaded_links.empty()) {
    const std::string from = names.constant("links") + ", " + names.constant("loaded_links");
    text += print_array("LinkBody", "bodies", from, table.loaded_links.size(), names);
  }
  if (moves_points(table)) {
    text +=
        print_array("LinkPoint", "points", names.constant("points"), table.points.size(), names);
  }
  for (const LinkInput& input : table.inputs) {
    if (is_of_friction(input) && !loops.uses_friction) continue;
    const InputStep step = step_of(input);
    const std::string entries =
        input.entries.empty()
            ? std::string()
            : fmt::format("{}, {}, ", names.constant(entries_name(input)), input.entries.size());
    text += call(names.function(step.function),
                 fmt::format("{}, {}, {}{}, {}", names.constant(frames_name(input)),
                             std::max(input.frames.size(), input.numbers.size()), entries,
                             names.array(input.argument), names.array(step.array)));
  }
  return text;
}

}  // namespace treeline
