#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <string_view>
#include <utility>

#include "emission/c_family_syntax.hpp"
#include "emission/comment.hpp"
#include "emission/emitted_text.hpp"
#include "emission/print_files.hpp"
#include "packaging/call_c.hpp"
#include "packaging/package_kinds.hpp"
#include "packaging/python_structs.hpp"
#include "packaging/templates.hpp"

namespace treeline {
namespace {

namespace templates = package_templates;

/// `lambda` is a word of Python: `lambda_`.
std::string python_name(const GeneratedFunction& generated) {
  const std::string& name = generated.program.name;
  return name == "lambda" ? name + "_" : name;
}

std::string list_arguments(const Program& program, std::string_view form) {
  std::string text;
  for (const Argument& argument : program.arguments) {
    text += fmt::format(fmt::runtime(form), argument.name);
  }
  return text;
}

/// A constant of C that holds a text.
std::string print_text(const std::string& constant, const std::string& text) {
  std::string quoted;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    quoted += "\n    \"";
    for (const char c : line) {
      if (c == '"' || c == '\\') quoted += '\\';
      quoted += c;
    }
    quoted += "\\n\"";
  }
  return fmt::format("static const char {}[] ={};\n", constant, quoted);
}

/// Text that `help` prints of a function: how it is called, and its contract.
std::string print_doc(const Scene& scene, const Generation& generation,
                      const GeneratedFunction& generated) {
  const Program& program = generated.program;
  std::string text = fmt::format("{}($module, {}*, out=None, threads=1)\n--\n\n",
                                 python_name(generated), list_arguments(program, "{}, "));
  text += find_comment(generation.files, scene.name + "_" + program.name);
  if (is_composed(generated)) text += "Here it is always that array.\n";
  return print_text("doc_of_" + python_name(generated), text);
}

/// A function that calls one of C with its arguments and results in two arrays.
std::string print_call(const Scene& scene, const GeneratedFunction& generated) {
  const Program& program = generated.program;
  const std::size_t written = count_written(generated);
  std::vector<std::string> list;
  for (std::size_t i = 0; i < program.arguments.size(); ++i) {
    list.push_back(fmt::format("in[{}]", i));
  }
  for (std::size_t i = 0; i < written; ++i) list.push_back(fmt::format("out[{}]", i));
  if (is_composed(generated)) list.push_back(scene.name + "_heaviest");
  const std::string returned = is_composed(generated) ? fmt::format("out[{}][0] = ", written) : "";
  const std::string call =
      fmt::format("{}{}_{}({});", returned, scene.name, program.name, fmt::join(list, ", "));
  return fmt::format("static void compute_{}(const Real* const* in, Real* const* out) {{\n{}}}\n",
                     program.name, wrap_line(call, 2));
}

/// Names and sizes of a function, for the table of all.
std::string print_row(const GeneratedFunction& generated, int operations) {
  const Program& program = generated.program;
  std::string list;
  const auto append = [&](const Argument& argument) {
    list += fmt::format("{}{{\"{}\", {}, {}}}", list.empty() ? "" : ", ", argument.name,
                        argument.rows, argument.cols);
  };
  for (const Argument& argument : program.arguments) append(argument);
  for (const Result& result : program.results) append(result.argument);
  return wrap_line(
      fmt::format("{{\"{}\", \"{}\", {}, {}, -1, {}, compute_{}, {{{}}}}},", python_name(generated),
                  in_pascal_case(program.name), program.arguments.size(), program.results.size(),
                  operations, program.name, list),
      0);
}

/// Adds a function of structs to the table.
void add_struct_call(const StructCall& call, std::size_t index, PackageFacts& facts) {
  std::string body;
  std::istringstream statements(call.call);
  for (std::string line; std::getline(statements, line);) body += wrap_line(line, 2);
  facts["calls"] +=
      fmt::format("\nstatic void compute__{}(const Real* const* in, Real* const* out) {{\n{}}}\n",
                  call.name, body);
  facts["rows"] +=
      wrap_line(fmt::format("{{\"_{0}\", \"{1}\", {2}, {3}, {4}, {5}, compute__{0}, {{{6}}}}},",
                            call.name, call.result, call.inputs, call.outputs, call.kept,
                            call.operations, call.arguments),
                0);
  facts["entries"] += fmt::format("{}ENTRY({}, _{})", index == 0 ? "" : " \\\n", index, call.name);
  facts["struct_docs"] += print_text("doc_of__" + call.name, "See structs.py.\n");
}

/// extension/functions.h: the functions as a table, with the texts that C's headers have of them.
std::string print_table(PackageFacts facts, const Scene& scene, const Generation& generation,
                        const PythonStructs& structs) {
  std::size_t count = 0, most = 0;
  int inputs = 0, operations = 0;
  std::string docs;
  for (const GeneratedFunction& generated : list_functions(generation)) {
    const Program& program = generated.program;
    int own = 0;
    for (const Argument& argument : program.arguments) own += argument.rows * argument.cols;
    // What is composed of others counts as the largest of all.
    const int flops = generated.chosen.count.flops();
    operations = std::max(operations, flops);
    facts["calls"] += (count == 0 ? "" : "\n") + print_call(scene, generated);
    facts["rows"] += print_row(generated, is_composed(generated) ? operations : flops);
    facts["entries"] +=
        fmt::format("{}ENTRY({}, {})", count == 0 ? "" : " \\\n", count, python_name(generated));
    docs += "\n" + print_doc(scene, generation, generated);
    most = std::max(most, program.arguments.size() + program.results.size());
    inputs = std::max(inputs, own);
    ++count;
  }
  for (const StructCall& call : structs.calls) {
    add_struct_call(call, count++, facts);
    most = std::max(most, static_cast<std::size_t>(call.inputs + call.outputs));
  }
  facts["objects"] = structs.exported.empty()
                         ? ""
                         : fmt::format("\nOf structs of C, see help({}.structs): {}.", scene.name,
                                       structs.exported);
  facts["conventions"] = harmless(generation.conventions);
  facts["docs"] = print_text("package_doc", fill_holes(templates::kPythonDoc, facts)) + docs +
                  facts["struct_docs"];
  facts["includes"] =
      (generation.damped ? fmt::format("#include \"../src/{}_damped.h\"\n", scene.name) : "") +
      structs.includes;
  facts["has_structs"] = structs.calls.empty() ? "0" : "1";
  facts["most_arguments"] = std::to_string(most);
  facts["most_inputs"] = std::to_string(inputs) + structs.inputs;
  return fill_holes(templates::kPythonFunctions, facts);
}

/// How Python's checkers of types see a function: of one result twice, as it gives back what is
/// given as `out`.
std::string print_types(const GeneratedFunction& generated) {
  const Program& program = generated.program;
  const std::string head = fmt::format("def {}({}*, out: ", python_name(generated),
                                       list_arguments(program, "{}: _Numbers, "));
  const auto declare = [&](const std::string& out, const std::string& result) {
    return fmt::format("{}{}, threads: int = 1) -> {}: ...\n", head, out, result);
  };
  if (program.results.size() == 1) {
    return "@overload\n" + declare("None = None", "_Array") + "@overload\n" +
           declare("_Given", "_Given") + "\n";
  }
  std::string given;
  for (std::size_t i = 0; i < program.results.size(); ++i) given += ", _Numbers | None";
  const std::string type = in_pascal_case(program.name);
  return print_result_class(type, program.results) +
         declare(fmt::format("tuple[{}] | None = None", given.substr(2)), type) + "\n";
}

/// The sources as entries of a list in JSON.
std::string quote_sources(const std::vector<PackagedSource>& sources) {
  std::string text;
  for (const PackagedSource& source : sources) {
    text += fmt::format("{}\"src/{}\"", text.empty() ? "" : ",\n", source.file);
  }
  return text;
}

/// The flags of those that have some, as members of an object in JSON.
std::string quote_own_flags(const std::vector<PackagedSource>& sources) {
  std::string text;
  for (const auto& [file, flags] : sources) {
    if (flags.empty()) continue;
    text += fmt::format("{}\"src/{}\": [\"{}\"]", text.empty() ? "" : ",\n", file, flags);
  }
  return text;
}

/// Flags as in the emitted CMakeLists.txt for the configuration Release.
std::string print_flags(const PackageFacts& facts, const Scene& scene) {
  return R"("-O3", "-g0", "-fvisibility=hidden", )" + quote_flags(facts, scene);
}

/// The example of the package: the first function, at home and at rest, or the controller's step.
std::string print_python_example(const Scene& scene, const Generation& generation,
                                 PackageFacts facts) {
  if (generation.functions.empty()) {
    return fill_holes(templates::kPythonControllerExample, facts);
  }
  const GeneratedFunction& generated = generation.functions.front();
  const Program& program = generated.program;
  facts["call"] = python_name(generated);
  facts["first"] = program.arguments.front().name;
  for (const Argument& argument : program.arguments) {
    const bool first = argument.name == facts["first"];
    facts["list"] += (first ? "" : ", ") + argument.name;
    facts["list_of_states"] += first ? "states" : ", " + argument.name;
    facts["arrays"] += argument.name == "q"
                           ? fmt::format("q = np.array({0}.home, {0}.dtype)\n", scene.name)
                           : fmt::format("{} = np.zeros({}, {}.dtype)\n", argument.name,
                                         argument.rows * argument.cols, scene.name);
  }
  return fill_holes(templates::kPythonExample, facts);
}

PackageFacts add_facts(PackageFacts facts, const Scene& scene, const Generation& generation,
                       const PythonStructs& structs) {
  facts["version"] += "+" + digest_of_files(generation.files).substr(0, 12);
  facts["flags"] = print_flags(facts, scene);
  const std::vector<PackagedSource> sources = list_packaged_sources(scene, generation);
  facts["own_flags"] = quote_own_flags(sources);
  facts["quoted_sources"] = quote_sources(sources);
  facts["task_row_names"] =
      scene.operational_points.empty() ? "NULL" : scene.name + "_task_row_names";
  facts["not_called"] = describe_not_called(scene, "Python");
  for (const GeneratedFunction& generated : list_functions(generation)) {
    facts["types"] += print_types(generated);
  }
  facts["types"] += structs.types;
  if (!facts["types"].empty()) facts["types"].pop_back();
  facts["structs"] = structs.imports;
  if (generation.functions.empty()) facts["functions"] = "none beside `Controller.step`";
  return facts;
}

}  // namespace

std::vector<PackageFolder> for_python(PackageFacts facts, const Robot& /*robot*/,
                                      const Scene& scene, const Generation& generation) {
  facts["dtype"] = scene.real == Real::float32 ? "float32" : "float64";
  const PythonStructs structs = make_python_structs(facts, scene, generation);
  facts = add_facts(std::move(facts), scene, generation, structs);
  const auto fill = [&](const std::string& name, std::string_view text) {
    return GeneratedFile{name, fill_holes(text, facts)};
  };
  std::vector<GeneratedFile> package = {fill("__init__.py", templates::kPythonInit),
                                        fill("__init__.pyi", templates::kPythonTypes),
                                        {"py.typed", ""}};
  std::vector<GeneratedFile> extension = {
      fill("build.json", templates::kPythonBuild),
      {"functions.h", print_table(facts, scene, generation, structs)},
      fill("numpy_arrays.h", templates::kPythonNumpyArrays),
      fill("operands.h", templates::kPythonOperands),
      fill("loop_states.h", templates::kPythonLoopStates),
      fill("module.c", templates::kPythonModule)};
  if (!structs.calls.empty()) {
    package.push_back({"structs.py", structs.module});
    extension.push_back({"structs.h", structs.header});
  }
  const std::string example = print_python_example(scene, generation, facts);
  return {{"",
           {fill("pyproject.toml", templates::kPythonProject),
            fill("setup.py", templates::kPythonSetup), fill("README.md", templates::kPythonReadme),
            fill("MANIFEST.in", templates::kPythonManifest)}},
          {"python/" + scene.name, std::move(package)},
          {"extension", std::move(extension)},
          {"examples", {{scene.name + "_time.py", example}}}};
}

}  // namespace treeline
