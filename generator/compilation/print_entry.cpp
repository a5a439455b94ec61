#include "compilation/print_entry.hpp"

#include <fmt/format.h>

#include "compilation/templates.hpp"
#include "emission/c_family_syntax.hpp"
#include "emission/emitted_text.hpp"
#include "text/identifier.hpp"

namespace treeline {
namespace {

/// Prints the arguments of a call: `prefix`input<size>(in[i]), and `prefix`output<size>(out[i]) for
/// the first `outputs` results, each followed by `suffix`.
std::string print_arguments(const Program& program, std::size_t outputs, const char* prefix,
                            const char* suffix) {
  std::string text;
  const auto append = [&](const char* direction, const Argument& argument, const char* array,
                          std::size_t i) {
    text += fmt::format("{}{}{}<{}>({}[{}]){}", text.empty() ? "" : ", ", prefix, direction,
                        argument.rows * argument.cols, array, i, suffix);
  };
  for (std::size_t i = 0; i < program.arguments.size(); ++i) {
    append("input", program.arguments[i], "in", i);
  }
  for (std::size_t i = 0; i < outputs; ++i) {
    append("output", program.results[i].argument, "out", i);
  }
  return text;
}

/// Prints the entry of a plain function. The last result may be a returned number.
std::string print_plain(const std::string& name, const GeneratedFunction& generated) {
  const Program& program = generated.program;
  const std::size_t outputs = count_written(generated);
  std::string before;
  if (is_composed(generated)) before = fmt::format("output<1>(out[{}])[0] = ", outputs);
  return fill_template(compilation_templates::kFunction,
                       {{"name", name},
                        {"entry", source_stem(generated)},
                        {"function", program.name},
                        {"arguments", print_arguments(program, outputs, "", "")},
                        {"before", before},
                        {"after", ""}});
}

/// Prints two entries of a batch function: one takes a single state, the other all states.
std::string print_batch(const std::string& name, const GeneratedFunction& generated) {
  const Program& program = generated.program;
  const auto fill = [&](const std::string& entry, const char* prefix, const char* suffix,
                        const char* after) {
    return fill_template(
        compilation_templates::kFunction,
        {{"name", name + "::batch"},
         {"entry", entry},
         {"function", generated.program.name},
         {"arguments", print_arguments(program, program.results.size(), prefix, suffix)},
         {"before", ""},
         {"after", after}});
  };
  const std::string stem = source_stem(generated);
  return fill(stem, "batch_", ".all()", "\n  lane = (lane + 1) % kStates;") +
         fill(stem + "_all", "all_", "", "");
}

/// How an entry of C spreads one state over rows, hands its results on, and names both.
struct RowsOfC {
  std::string spread, hand_on, arrays, arguments;
};

RowsOfC print_c_rows(const std::string& name, const GeneratedFunction& generated) {
  const Program& program = generated.program;
  RowsOfC text;
  const auto append = [&](const Argument& argument, const char* direction, std::size_t i) {
    const std::string rows = fmt::format("{}_{}", direction, i);
    const int size = argument.rows * argument.cols;
    const bool is_result = std::string_view(direction) == "out";
    text.spread +=
        fmt::format("{0}_real {1}[{2}];\n{3}({4}[{5}], {6}, {1});\n", name, rows,
                    size * generated.batch, is_result ? "fill" : "spread", direction, i, size);
    if (is_result) text.hand_on += fmt::format("hand_on({}, {}, out[{}]);\n", rows, size, i);
    text.arrays += (text.arrays.empty() ? "" : ", ") + rows;
    text.arguments += fmt::format("{}{}[{}]", text.arguments.empty() ? "" : ", ", direction, i);
  };
  for (std::size_t i = 0; i < program.arguments.size(); ++i) append(program.arguments[i], "in", i);
  for (std::size_t i = 0; i < program.results.size(); ++i) {
    append(program.results[i].argument, "out", i);
  }
  return text;
}

/// The entries of a batch function in C.
std::string print_c_batch(const std::string& name, const GeneratedFunction& generated) {
  const RowsOfC rows = print_c_rows(name, generated);
  return fill_template(compilation_templates::kCBatchFunction,
                       {{"name", name},
                        {"NAME", in_capitals(name)},
                        {"entry", source_stem(generated)},
                        {"function", generated.program.name},
                        {"spread", rows.spread},
                        {"arrays", rows.arrays},
                        {"hand_on", rows.hand_on},
                        {"arguments", rows.arguments}});
}

std::string print_c_batch_helpers(const std::string& name) {
  return fill_template(compilation_templates::kCBatch,
                       {{"name", name}, {"NAME", in_capitals(name)}});
}

/// The call of limited control in C, of one state or of several.
std::string print_c_limited_call(const std::string& name, const GeneratedFunction& supported) {
  const Program& program = supported.program;
  if (supported.batch > 0) {
    const RowsOfC rows = print_c_rows(name, supported);
    return fmt::format(
        "{0}{1}_limited_torque of_states[{2}_STATES] = {{0}};\n"
        "{1}_batch_limited_control_torque({3}, of_states, &{1}_default_limits);\n"
        "{4}const {1}_limited_torque limited = of_states[checked_state];\n"
        "checked_state = (checked_state + 1) % {2}_STATES;",
        rows.spread, name, in_capitals(name), rows.arrays, rows.hand_on);
  }
  std::string list;
  for (std::size_t i = 0; i < program.arguments.size(); ++i) list += fmt::format("in[{}], ", i);
  for (std::size_t i = 0; i < program.results.size(); ++i) list += fmt::format("out[{}], ", i);
  return fmt::format(
      "{0}_limited_torque limited = {{0}};\n"
      "{0}_limited_control_torque({1}&limited, &{0}_default_limits);",
      name, list);
}

}  // namespace

std::string print_entry(const std::string& name, const std::vector<GeneratedFunction>& functions) {
  std::string text;
  bool has_batch = false;
  for (const GeneratedFunction& generated : functions) {
    if (is_composed(generated)) continue;
    has_batch = has_batch || generated.batch > 0;
    text += generated.batch > 0 ? print_batch(name, generated) : print_plain(name, generated);
  }
  std::string more(compilation_templates::kBytesOfReal);
  if (has_batch) more += fill_template(compilation_templates::kBatch, {{"name", name}});
  return fill_template(compilation_templates::kEntry,
                       {{"name", name}, {"header", name}, {"more", more}, {"functions", text}});
}

std::string print_c_entry(const std::string& name,
                          const std::vector<GeneratedFunction>& functions) {
  std::string text;
  std::string header = name;
  bool has_batch = false;
  for (const GeneratedFunction& generated : functions) {
    const Program& program = generated.program;
    if (generated.batch > 0) {
      has_batch = true;
      text += print_c_batch(name, generated);
      continue;
    }
    const std::size_t outputs = count_written(generated);
    std::string list;
    for (std::size_t i = 0; i < program.arguments.size(); ++i) list += fmt::format("in[{}], ", i);
    for (std::size_t i = 0; i < outputs; ++i) {
      list += fmt::format("{}out[{}]", i == 0 ? "" : ", ", i);
    }
    std::string before;
    if (is_composed(generated)) {
      header = name + "_damped";
      before = fmt::format("*({}_real*)out[{}] = ", name, outputs);
      list += fmt::format(", {}_heaviest", name);
    }
    text += fill_template(compilation_templates::kCFunction, {{"name", name},
                                                              {"entry", source_stem(generated)},
                                                              {"before", before},
                                                              {"function", program.name},
                                                              {"arguments", list}});
  }
  const std::string more = has_batch ? print_c_batch_helpers(name) : "";
  return fill_template(compilation_templates::kCEntry,
                       {{"name", name}, {"header", header}, {"more", more}, {"functions", text}});
}

std::string print_composed_entry(const std::string& name, const GeneratedFunction& generated) {
  return fill_template(compilation_templates::kEntry,
                       {{"name", name},
                        {"header", name + "_damped"},
                        {"more", ""},
                        {"functions", print_plain(name, generated)}});
}

std::string print_limited_entry(const std::string& name, const GeneratedFunction& supported) {
  const bool batch = supported.batch > 0;
  const std::string arguments = print_arguments(supported.program, supported.program.results.size(),
                                                batch ? "batch_" : "", batch ? ".all()" : "");
  const std::string call = batch ? fmt::format(
                                       "{0}::LimitedTorque of_states[kStates] = {{}};\n"
                                       "  {0}::batch::limited_control_torque({1}, of_states);\n"
                                       "  const {0}::LimitedTorque& limited = of_states[lane];\n"
                                       "  lane = (lane + 1) % kStates;",
                                       name, arguments)
                                 : fmt::format(
                                       "{0}::LimitedTorque limited{{}};\n"
                                       "  {0}::limited_control_torque({1}, limited);",
                                       name, arguments);
  return fill_template(
      compilation_templates::kLimited,
      {{"name", name},
       {"header", name + (batch ? "_batch_limited" : "_limited")},
       {"more", batch ? fill_template(compilation_templates::kBatch, {{"name", name}}) : ""},
       {"entry", entry_symbol(limited_stem(batch))},
       {"call", call}});
}

std::string print_c_limited_entry(const std::string& name, const GeneratedFunction& supported) {
  const bool batch = supported.batch > 0;
  return fill_template(compilation_templates::kCLimited,
                       {{"name", name},
                        {"NAME", in_capitals(name)},
                        {"stem", limited_stem(batch)},
                        {"more", batch ? print_c_batch_helpers(name) : ""},
                        {"call", print_c_limited_call(name, supported)}});
}

std::string limited_stem(bool batch) {
  return std::string(batch ? "batch_" : "") + "limited_control_torque";
}

std::string entry_symbol(const std::string& function) {
  return "treeline_check_" + function;
}

std::string raw_entry_symbol(const GeneratedFunction& generated) {
  return entry_symbol(source_stem(generated)) + (generated.batch > 0 ? "_all" : "");
}

}  // namespace treeline
