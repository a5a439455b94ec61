#include <fmt/format.h>

#include <algorithm>

#include "board/run_board.hpp"
#include "board/templates.hpp"
#include "emission/emitted_text.hpp"

namespace treeline {
namespace {

int size_of(const Argument& argument) {
  return argument.rows * argument.cols;
}

/// The text as it stands between quotes in C++ or in assembly.
std::string escape(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '"' || c == '\\') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

/// Types of a function's arguments, for a declaration.
std::string print_types(const GeneratedFunction& generated, bool with_names) {
  const Program& program = generated.program;
  std::string list;
  const auto append = [&](const char* qualifier, const Argument& argument) {
    list += fmt::format("{}{}Real (&{})[{}]", list.empty() ? "" : ", ", qualifier,
                        with_names ? argument.name : "", size_of(argument));
  };
  for (const Argument& argument : program.arguments) append("const ", argument);
  for (std::size_t i = 0; i < count_written(generated); ++i) {
    append("", program.results[i].argument);
  }
  return list;
}

/// Arguments of a call at the place of a state.
std::string print_call_arguments(const GeneratedFunction& generated,
                                 const std::vector<StatePlace>& places) {
  std::string list;
  for (const Argument& argument : generated.program.arguments) {
    const auto place = std::find_if(places.begin(), places.end(), [&](const StatePlace& each) {
      return each.name == argument.name;
    });
    list += fmt::format("{}input<{}>({}, state)", list.empty() ? "" : ", ", size_of(argument),
                        place->at);
  }
  int at = 0;
  for (std::size_t i = 0; i < count_written(generated); ++i) {
    const int size = size_of(generated.program.results[i].argument);
    list += fmt::format("{}output<{}>({})", list.empty() ? "" : ", ", size, at);
    at += size;
  }
  return list;
}

/// The functions that do nothing.
std::string declare_empty(const std::string& name,
                          const std::vector<GeneratedFunction>& functions) {
  std::string text = fmt::format("namespace empty {{\nusing {}::Real;\n", name);
  for (const GeneratedFunction& generated : functions) {
    text += fmt::format("void {}({}) noexcept;\n", generated.program.name,
                        print_types(generated, false));
  }
  return text + "}\n\n";
}

/// Names of a function's arguments, for a call.
std::string list_names(const GeneratedFunction& generated) {
  std::string names;
  for (const Argument& argument : generated.program.arguments) names += argument.name + ", ";
  for (std::size_t i = 0; i < count_written(generated); ++i) {
    names += (i == 0 ? "" : ", ") + generated.program.results[i].argument.name;
  }
  return names;
}

/// Calls a function in C, whose arrays are pointers. Compiled into the caller, as if that called it
/// itself.
std::string print_c_call(const std::string& name, const GeneratedFunction& generated) {
  const bool composed = is_composed(generated);
  return fmt::format(
      "__attribute__((always_inline)) inline {} {}({}) noexcept {{\n  {}{}_{}({}{});\n}}\n",
      composed ? "Real" : "void", generated.program.name, print_types(generated, true),
      composed ? "return " : "", name, generated.program.name, list_names(generated),
      composed ? fmt::format(", {}_heaviest", name) : "");
}

std::string print_case(const std::string& name, const GeneratedFunction& generated,
                       const std::vector<StatePlace>& places) {
  const std::string before =
      is_composed(generated) ? fmt::format("record.outputs[{}] = ", count_outputs(generated) - 1)
                             : std::string();
  return fill_template(board_templates::kCase,
                       {{"stem", source_stem(generated)},
                        {"space", is_composed(generated) ? "composed" : name},
                        {"function", generated.program.name},
                        {"arguments", print_call_arguments(generated, places)},
                        {"before", before}});
}

/// What the program includes and declares for a controller and a self-test.
std::string print_heads(const std::string& name, const HarnessFiles& files) {
  return (files.selftest ? fmt::format("#include \"{}_selftest.h\"\n", name) : "") +
         files.step_head;
}

}  // namespace

int count_outputs(const GeneratedFunction& generated) {
  int size = 0;
  for (const Result& result : generated.program.results) size += size_of(result.argument);
  return size;
}

std::vector<StatePlace> place_arguments(const std::vector<GeneratedFunction>& functions) {
  std::vector<StatePlace> places;
  int at = 0;
  for (const GeneratedFunction& generated : functions) {
    for (const Argument& argument : generated.program.arguments) {
      const bool placed = std::any_of(places.begin(), places.end(), [&](const StatePlace& each) {
        return each.name == argument.name;
      });
      if (placed) continue;
      places.push_back({argument.name, size_of(argument), at});
      at += size_of(argument);
    }
  }
  return places;
}

std::string print_functions_header(const std::string& name,
                                   const std::vector<GeneratedFunction>& functions) {
  std::string composed;
  for (const GeneratedFunction& generated : functions) {
    if (!is_composed(generated)) continue;
    composed += fmt::format("Real {}({}) noexcept;\n", generated.program.name,
                            print_types(generated, false));
  }
  return fmt::format(
      "#pragma once\n#include \"{0}.hpp\"\n\n{1}namespace composed {{\nusing {0}::Real;\n{2}}}\n",
      name, declare_empty(name, functions), composed);
}

std::string print_c_functions_header(const std::string& name,
                                     const std::vector<GeneratedFunction>& functions, Real real) {
  std::string plain, composed;
  for (const GeneratedFunction& generated : functions) {
    (is_composed(generated) ? composed : plain) += print_c_call(name, generated);
  }
  return fmt::format(
      "#pragma once\n#include \"{0}{1}.h\"\n\nnamespace {0} {{\nusing Real = {2};\n{3}}}\n\n"
      "{4}namespace composed {{\nusing {0}::Real;\n{5}}}\n",
      name, composed.empty() ? "" : "_damped", real == Real::float32 ? "float" : "double", plain,
      declare_empty(name, functions), composed);
}

std::string print_empty_functions(const std::vector<GeneratedFunction>& functions) {
  std::string text = "#include \"functions.hpp\"\n\nnamespace empty {\n";
  for (const GeneratedFunction& generated : functions) {
    text += fmt::format("void {}({}) noexcept {{}}\n", generated.program.name,
                        print_types(generated, false));
  }
  return text + "}\n";
}

std::string print_composed_function(const std::string& name, const GeneratedFunction& generated) {
  return fmt::format(
      "#include \"functions.hpp\"\n#include \"{0}_damped.hpp\"\n\nnamespace composed {{\n"
      "Real {1}({2}) noexcept {{\n  return {0}::{1}({3});\n}}\n}}\n",
      name, generated.program.name, print_types(generated, true), list_names(generated));
}

std::string print_main(const std::string& name, const std::vector<GeneratedFunction>& functions,
                       const HarnessFiles& files) {
  const std::vector<StatePlace> places = place_arguments(functions);
  std::string cases, rows;
  int most = 1;
  for (const GeneratedFunction& generated : functions) {
    const std::string stem = source_stem(generated);
    cases += print_case(name, generated, places);
    rows += fmt::format(
        "{{count_{0}, count_empty_{0}, use_stack_{0}, call_{0}, call_empty_{0}, {1}}},\n", stem,
        count_outputs(generated));
    most = std::max(most, count_outputs(generated));
  }
  return fill_template(
      board_templates::kMain,
      {{"name", name},
       {"states_file", escape(escape(files.states))},  // assembly within C++
       {"id", files.id},
       {"states", std::to_string(files.count)},
       {"state_size", std::to_string(places.empty() ? 0 : places.back().at + places.back().size)},
       {"case_count", std::to_string(functions.size())},
       {"most_outputs", std::to_string(most)},
       {"cases", cases},
       {"heads", print_heads(name, files)},
       {"step", files.step_part},
       {"run_steps", files.step_part.empty() ? "" : "run_steps();"},
       {"selftest",
        files.selftest ? fill_template(board_templates::kSelftest, {{"name", name}}) : ""},
       {"run_selftest", files.selftest ? "run_selftest();" : ""},
       {"rows", rows}});
}

std::string print_start(const Board& board) {
  switch (board.kind) {
    case BoardKind::cortex_m:
      return fill_template(board_templates::kCortexM,
                           {{"clock_mhz", std::to_string(board.clock_mhz)}});
    case BoardKind::riscv:
      return std::string(board_templates::kRiscv);
    case BoardKind::aarch64:
      return std::string(board_templates::kAarch64);
    case BoardKind::none:
      break;
  }
  return {};
}

}  // namespace treeline
