#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "emission/backend.hpp"
#include "emission/c_family_syntax.hpp"
#include "emission/comment.hpp"
#include "emission/controller_unit.hpp"
#include "emission/emitted_text.hpp"
#include "emission/print_files.hpp"
#include "emission/selftest_facts.hpp"
#include "emission/templates.hpp"
#include "text/printable.hpp"

namespace treeline {
namespace {

using Values = SelftestFacts::Values;

/// What texts of one self-test share.
struct SelftestWriter {
  const EmissionContext& context;
  const SelftestFacts& facts;
  std::string own;  ///< before the names of all that is only here
};

/// A number in hexadecimal, which keeps its bits.
std::string print_bits(const SelftestWriter& writer, double value) {
  return number_literal(writer.context, fmt::format("{:a}", value).c_str());
}

std::string print_numbers(const SelftestWriter& writer, const std::vector<double>& values) {
  std::vector<std::string> texts;
  for (const double value : values) texts.push_back(print_bits(writer, value));
  return fmt::format("{{{}}}", fmt::join(texts, ", "));
}

/// An array of arrays, or of numbers where there is one row alone.
std::string print_table(const SelftestWriter& writer, const std::string& name,
                        const std::vector<std::vector<double>>& rows, bool flat = false) {
  std::string text = fmt::format("static const {} {}", number_type(writer.context), name);
  if (!flat) text += fmt::format("[{}]", rows.size());
  text += fmt::format("[{}] = {}", rows.front().size(), flat ? "" : "{");
  std::vector<std::string> texts;
  for (const auto& row : rows) texts.push_back(print_numbers(writer, row));
  return wrap_text(fmt::format("{}{}{};", text, fmt::join(texts, ", "), flat ? "" : "}"), 99) +
         "\n";
}

std::string print_function(const SelftestWriter& writer, const Program& program,
                           const SelftestFacts::Called& called) {
  const std::string own = writer.own + called.function;
  std::string expected, results, compare, list;
  for (const Argument& argument : program.arguments) {
    list += fmt::format("{}in_{}[state], ", writer.own, argument.name);
  }
  for (const Values& result : called.results) {
    const std::size_t size = result.by_state.front().size();
    const std::string table = own + "_" + result.name;
    expected += print_table(writer, table, result.by_state);
    results += fmt::format("{} {}[{}];\n", number_type(writer.context), result.name, size);
    compare += wrap_text(fmt::format("differ |= {}differs({}, {}[state], {});", writer.own,
                                     result.name, table, size),
                         95) +
               "\n";
    list += result.name + ", ";
  }
  list.resize(list.size() - 2);
  expected.pop_back();
  return fill_template(templates::kSelftestFunction,
                       {{"expected", expected},
                        {"own", own},
                        {"states", std::to_string(writer.facts.states)},
                        {"results", results},
                        {"call", wrap_text(fmt::format("{}{}{}({});", writer.context.name,
                                                       backend_of(writer.context.language).scope,
                                                       called.function, list),
                                           95)},
                        {"compare", compare}});
}

/// Copies what the law and the robot take beside the joints; as volatile, or some compilers make a
/// call of memcpy of it.
std::string print_copy(const SelftestWriter& writer, const std::string& own) {
  if (writer.facts.motion->inputs.empty()) return {};
  return fmt::format(
      "static void {0}_copy(const {1}* from, int count, volatile {1}* to) {{\n"
      "  for (int i = 0; i < count; ++i) {{\n    to[i] = from[i];\n  }}\n}}\n\n",
      own, number_type(writer.context));
}

std::string print_motion_tables(const SelftestWriter& writer, const std::string& own) {
  const SelftestFacts::Motion& motion = *writer.facts.motion;
  std::string text = print_table(writer, own + "_q", {motion.q}, true) +
                     print_table(writer, own + "_way", {motion.way}, true) +
                     print_table(writer, own + "_goal", {motion.goal}, true) +
                     print_table(writer, own + "_tau", motion.tau);
  for (std::size_t i = 0; i < motion.inputs.size(); ++i) {
    text += print_table(writer, fmt::format("{}_in_{}", own, i), motion.inputs[i].by_state, true);
  }
  return text;
}

std::string print_motion_inputs(const SelftestWriter& writer, const std::string& own) {
  const SelftestFacts::Motion& motion = *writer.facts.motion;
  std::string text;
  for (std::size_t i = 0; i < motion.inputs.size(); ++i) {
    text += fmt::format("{0}_copy({0}_in_{1}, {2}, &input.{3}[0]);\n", own, i,
                        motion.inputs[i].by_state.front().size(), motion.inputs[i].name);
  }
  if (writer.context.controller->settings.force) {
    text += fmt::format("input.command.force = {};\n",
                        print_bits(writer, SelftestFacts::Motion::kForce));
  }
  return text;
}

/// The bytes of a struct.
std::string print_bytes_of(const SelftestWriter& writer, const std::string& name) {
  return writer.context.language == Language::c
             ? fmt::format("(unsigned char*)&{}", name)
             : fmt::format("reinterpret_cast<unsigned char*>(&{})", name);
}

std::string print_motion(const SelftestWriter& writer) {
  if (!writer.facts.motion) return {};
  const SelftestFacts::Motion& motion = *writer.facts.motion;
  const std::string own = writer.own + "step";
  std::string kinds;
  for (const std::string& kind : motion.kinds) {
    kinds +=
        fmt::format("{}{}_{}", kinds.empty() ? "" : ", ", name_in_capitals(writer.context), kind);
  }
  return fill_template(templates::kSelftestStep,
                       {{"name", writer.context.name},
                        {"own", own},
                        {"real", number_type(writer.context)},
                        {"commands", std::to_string(motion.kinds.size())},
                        {"ticks", std::to_string(SelftestFacts::Motion::kTicks)},
                        {"joints", std::to_string(motion.q.size())},
                        {"kinds", wrap_text(fmt::format("{{{}}}", kinds), 60)},
                        {"modes", fmt::format("{{{}}}", fmt::join(motion.modes, ", "))},
                        {"faults", fmt::format("{{{}U}}", fmt::join(motion.faults, "U, "))},
                        {"tables", print_motion_tables(writer, own)},
                        {"bytes_of_state", print_bytes_of(writer, "state")},
                        {"bytes_of_input", print_bytes_of(writer, "input")},
                        {"copy", print_copy(writer, own)},
                        {"zero", number_literal(writer.context, "0.0")},
                        {"one", number_literal(writer.context, "1.0")},
                        {"rate", print_bits(writer, motion.rate)},
                        {"duration", print_bits(writer, SelftestFacts::Motion::kDuration)},
                        {"inputs", print_motion_inputs(writer, own)}});
}

/// One call after the other, until a function's results differ.
std::string print_calls(const SelftestWriter& writer) {
  std::vector<std::string> functions;
  for (const auto& called : writer.facts.functions) functions.push_back(called.function);
  if (writer.facts.motion) functions.emplace_back("step");
  std::string text;
  for (std::size_t i = 0; i < functions.size(); ++i) {
    text += fmt::format("{}if ({}{}(begin) != 0) {{\n  number = {};\n}}", i == 0 ? "" : " else ",
                        writer.own, functions[i], i + 1);
  }
  return text + " else {\n  // All results are as expected.\n}";
}

/// Which number stands for which function.
std::string print_numbers_of_functions(const SelftestWriter& writer) {
  std::string text;
  for (std::size_t i = 0; i < writer.facts.functions.size(); ++i) {
    text += fmt::format("     {:>2}  {}\n", i + 1, writer.facts.functions[i].function);
  }
  if (writer.facts.motion) {
    text += fmt::format("     {:>2}  {}_step\n", writer.facts.functions.size() + 1,
                        writer.context.name);
  }
  text.pop_back();
  return text;
}

std::string print_coverage(const SelftestWriter& writer) {
  std::string text;
  if (writer.facts.motion) {
    text += fmt::format(
        "Of the step, {} cycles under {} commands, on joints that move at steady velocities: the "
        "torques, the mode and the faults after each {}. ",
        writer.facts.motion->kinds.size() * SelftestFacts::Motion::kTicks,
        writer.facts.motion->kinds.size(), SelftestFacts::Motion::kTicks);
  }
  text += writer.facts.left_out.empty()
              ? "No function is left out."
              : fmt::format("Not called: {}.", fmt::join(writer.facts.left_out, ", "));
  return text;
}

std::size_t count_numbers(const std::vector<Values>& all) {
  std::size_t count = 0;
  for (const Values& values : all) {
    for (const auto& row : values.by_state) count += row.size();
  }
  return count;
}

/// Bytes of the tables.
std::size_t count_constants(const EmissionContext& context, const SelftestFacts& facts) {
  std::size_t count = count_numbers(facts.arguments), whole = 0;
  for (const auto& called : facts.functions) count += count_numbers(called.results);
  if (facts.motion) {
    const SelftestFacts::Motion& motion = *facts.motion;
    count += (3 + motion.kinds.size()) * motion.q.size() + count_numbers(motion.inputs);
    whole = 3 * motion.kinds.size();
  }
  return (count * static_cast<std::size_t>(number_bytes(context))) + (4 * whole);
}

/// Numbers of the results that are on the stack at a time.
std::size_t count_results(const SelftestFacts& facts) {
  std::size_t most = 0;
  for (const auto& called : facts.functions) {
    most = std::max(most, count_numbers(called.results) / static_cast<std::size_t>(facts.states));
  }
  return most;
}

std::string describe_selftest_cost(const SelftestWriter& writer, const std::string& states) {
  const auto bytes = static_cast<std::size_t>(number_bytes(writer.context));
  return fmt::format(
      "Cost: {} bytes of constants beside the code, up to {} bytes of stack for results beside "
      "what "
      "the functions need{}, and the time of all calls in {}. `treeline check --target` measures "
      "it.",
      count_constants(writer.context, writer.facts), bytes * count_results(writer.facts),
      writer.facts.motion ? ", with the structs of the step once" : "", states);
}

/// A paragraph of the header's comment.
std::string in_header(const std::string& text) {
  std::string lines = wrap_text(text, 96);
  for (auto at = lines.find("\n  "); at != lines.npos; at = lines.find("\n  ", at)) {
    lines.erase(++at, 2);
  }
  return lines;
}

std::string print_selftest_header(const SelftestWriter& writer) {
  const EmissionContext& context = writer.context;
  const int count = writer.facts.states;
  const std::string states = fmt::format("{} state{}", count, count == 1 ? "" : "s");
  return fill_template(templates::kSelftestHeader,
                       {{"robot", in_comment(printable(context.robot))},
                        {"name", context.name},
                        {"real", number_type(context)},
                        {"states", states},
                        {"table", print_numbers_of_functions(writer)},
                        {"coverage", in_header(print_coverage(writer))},
                        {"cost", in_header(describe_selftest_cost(writer, states)) + " */"}});
}

std::string print_includes(const SelftestWriter& writer) {
  const std::string& name = writer.context.name;
  std::string text = fmt::format("#include \"{}_selftest.h\"\n\n", name);
  if (writer.facts.motion) {
    text += fmt::format("#include <stddef.h>\n#include <stdint.h>\n\n");
  }
  text += fmt::format("#include \"{}{}\"\n", name, backend_of(writer.context.language).header);
  if (writer.facts.motion) text += fmt::format("#include \"{}_controller.h\"\n", name);
  return text;
}

}  // namespace

std::vector<GeneratedFile> print_selftest(const Contents& contents) {
  const EmissionContext& context = contents.context;
  const SelftestWriter writer{context, *context.selftest, context.name + "_selftest_"};
  std::string inputs, functions;
  for (const Values& argument : writer.facts.arguments) {
    inputs += print_table(writer, writer.own + "in_" + argument.name, argument.by_state);
  }
  for (const auto& called : writer.facts.functions) {
    const auto program =
        std::find_if(contents.programs.begin(), contents.programs.end(),
                     [&](const Program& each) { return each.name == called.function; });
    functions += print_function(writer, *program, called);
  }
  const std::string source =
      fill_template(templates::kSelftestSource, {{"name", context.name},
                                                 {"real", number_type(context)},
                                                 {"includes", print_includes(writer)},
                                                 {"inputs", inputs},
                                                 {"functions", functions + print_motion(writer)},
                                                 {"calls", print_calls(writer)}});
  return {{context.name + "_selftest.h", print_selftest_header(writer)},
          {kSelftestStem + std::string(backend_of(context.language).source), source}};
}

}  // namespace treeline
