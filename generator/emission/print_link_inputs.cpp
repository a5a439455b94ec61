#include "emission/print_link_inputs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "emission/emitted_text.hpp"
#include "emission/print_link_table.hpp"

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
      return {input.entries.empty() ? "tl_add_bodies" : "tl_add_parts_of_bodies", "bodies"};
    case LinkInput::Gives::origins:
      return {"tl_move_points", "points"};
    case LinkInput::Gives::axes:
      return {"tl_turn_points", "points"};
    case LinkInput::Gives::rotors:
      return {"tl_give_rotors", "rotors"};
    case LinkInput::Gives::dampings:
      return {"tl_give_dampings", "drives"};
    case LinkInput::Gives::frictions:
      break;
  }
  return {"tl_give_frictions", "frictions"};
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
  return fmt::format("  {} {}[{}];\n", names.in_loops(type), array, count) +
         call(names.in_loops(fmt::format("tl_copy_{}", array)),
              fmt::format("{}, {}, &{}[0]", from, count, array));
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

std::vector<LinkMember> list_members(const LinkLoops& loops, const LoopNames& names,
                                     const std::vector<std::string>& gravity) {
  const LinkTableData& table = loops.table;
  const auto pointer = [&](bool has, const char* constant, bool is_changed = false) {
    return !has         ? names.none
           : is_changed ? fmt::format("&{}[0]", constant)
                        : names.constant(constant);
  };
  const auto argument = [&](const std::string& name) {
    return name.empty() ? names.none : fmt::format("&{}[0]", name);
  };
  std::vector<LinkMember> members = {
      {"links", names.constant("links")},
      {"count", std::to_string(table.links.size())},
      {"slots", std::to_string(table.slots)},
      {"gravity", fmt::format("{{{}}}", fmt::join(gravity, ", "))},
      {"points", pointer(has_points(table), "points", moves_points(table))},
      {"point_count", std::to_string(table.points.size())},
      {"point_rows", pointer(!table.rows.empty(), "point_rows")},
      {"rows", std::to_string(table.rows.size())},
      {"couplings", pointer(!table.couplings.empty(), "couplings")},
      {"joints", std::to_string(table.joints)},
      {"row_entries", pointer(!table.row_entries.empty(), "row_entries")},
      {"rotors", pointer(table.gives(LinkInput::Gives::rotors), "rotors", true)},
      {"step", argument(loops.step)}};
  const auto add = [&](bool has, std::initializer_list<LinkMember> more) {
    if (has) members.insert(members.end(), more);
  };
  const bool pushed = !loops.f_ext.empty();
  add(!table.drives.empty(), {{"drives", pointer(true, "drives", changes_drives(loops))}});
  add(!table.frictions.empty(),
      {{"frictions", pointer(true, "frictions", changes_frictions(loops))}});
  add(!table.balls.empty(), {{"ball_axes", pointer(true, "ball_axes")}});
  add(!table.pushed_points.empty(),
      {{"pushed_points", pointer(pushed, "pushed_points")},
       {"pushed_count", std::to_string(pushed ? table.pushed_points.size() : 0)},
       {"f_ext", argument(loops.f_ext)}});
  add(!table.loaded_links.empty(), {{"bodies", pointer(true, "bodies", true)},
                                    {"loaded_links", pointer(true, "loaded_links")},
                                    {"loaded_count", std::to_string(table.loaded_links.size())}});
  return members;
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
    text += call(names.in_loops("tl_copy_rotors"),
                 fmt::format("{}, {}, {}", names.constant("links"), links, "&rotors[0]"));
  }
  if (changes_drives(loops)) {
    text += print_array("TlLinkDrive", "drives", names.constant("drives"), links, names);
  }
  if (changes_frictions(loops)) {
    text += print_array("TlLinkFriction", "frictions", names.constant("frictions"), links, names);
  }
  return text;
}

std::string print_link_inputs(const LinkLoops& loops, const LoopNames& names) {
  const LinkTableData& table = loops.table;
  std::string text = print_link_arrays(loops, names);
  if (!table.loaded_links.empty()) {
    const std::string from = names.constant("links") + ", " + names.constant("loaded_links");
    text += print_array("TlLinkBody", "bodies", from, table.loaded_links.size(), names);
  }
  if (moves_points(table)) {
    text +=
        print_array("TlLinkPoint", "points", names.constant("points"), table.points.size(), names);
  }
  for (const LinkInput& input : table.inputs) {
    if (is_of_friction(input) && !loops.uses_friction) continue;
    const InputStep step = step_of(input);
    const std::string entries =
        input.entries.empty()
            ? std::string()
            : fmt::format("{}, {}, ", names.constant(entries_name(input)), input.entries.size());
    text += call(names.in_loops(step.function),
                 fmt::format("{}, {}, {}&{}[0], &{}[0]", names.constant(frames_name(input)),
                             std::max(input.frames.size(), input.numbers.size()), entries,
                             input.argument, step.array));
  }
  return text;
}

}  // namespace treeline
