#include "compilation/print_step_entry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "compilation/templates.hpp"
#include "emission/emitted_text.hpp"
#include "emission/list_members.hpp"

namespace treeline {
namespace {

constexpr const char* kDynamicsStem = "treeline_check_step_dynamics";

/// The call that visits a member. `path` leads to it from the struct.
std::string print_visited(const std::string& name, const StructMember& member,
                          const std::string& path) {
  const char* const kind = member.type == "int32_t"    ? "SIGNED"
                           : member.type == "uint32_t" ? "UNSIGNED"
                                                       : "REAL";
  const std::string number = member.type == name + "_number" ? member.type : "int32_t";
  return fmt::format(
      "  visit_member(visit, \"{0}\", {1}, (int)(sizeof of->{0} / sizeof({2})), "
      "&of->{0});\n",
      path, kind, number);
}

/// A function that visits each member of a struct, those of a command within the input too.
std::string print_visit(const std::string& name, const std::string& header,
                        const std::string& part) {
  std::string calls;
  for (const StructMember& member : list_members(header, name + "_" + part)) {
    if (member.type == name + "_command") {
      for (const StructMember& of_command : list_members(header, member.type)) {
        calls += print_visited(name, of_command, member.name + "." + of_command.name);
      }
    } else {
      calls += print_visited(name, member, member.name);
    }
  }
  return fmt::format("static void visit_{0}(struct visit* visit, {1}_{0}* of) {{\n{2}}}\n", part,
                     name, calls);
}

/// A function of the controller, which hands its arguments to the host.
std::string print_handed_on(const Program& program, std::size_t index) {
  std::string parameters, in, out, wide, given;
  const auto append = [](std::string& list, const std::string& item) {
    list += (list.empty() ? "" : ", ") + item;
  };
  for (const Argument& argument : program.arguments) {
    const int size = argument.rows * argument.cols;
    append(parameters, fmt::format("const Real (&{})[{}]", argument.name, size));
    wide += fmt::format("  Wide<{1}> wide_{0}({0});\n", argument.name, size);
    append(in, "wide_" + argument.name + ".numbers");
  }
  for (const Result& result : program.results) {
    const Argument& argument = result.argument;
    const int size = argument.rows * argument.cols;
    append(parameters, fmt::format("Real (&{})[{}]", argument.name, size));
    wide += fmt::format("  Wide<{1}> wide_{0};\n", argument.name, size);
    append(out, "wide_" + argument.name + ".numbers");
    given += fmt::format("  wide_{0}.give({0});\n", argument.name);
  }
  return fmt::format(
      "void {}({}) noexcept {{\n{}  const long double* const in[] = {{{}}};\n"
      "  long double* const out[] = {{{}}};\n  compute(with, {}, in, out);\n{}}}\n",
      program.name, parameters, wide, in, out, index, given);
}

std::string replace_once(std::string text, const std::string& old, const std::string& by) {
  const std::size_t at = text.find(old);
  return at == std::string::npos ? text : text.replace(at, old.size(), by);
}

}  // namespace

std::string find_controller_header(const std::string& name,
                                   const std::vector<GeneratedFile>& files) {
  const auto found = std::find_if(files.begin(), files.end(), [&](const GeneratedFile& file) {
    return file.name == name + "_controller.h";
  });
  return found == files.end() ? std::string() : found->text;
}

std::string print_step_entry(const std::string& name, const std::string& header, const char* flat) {
  std::string visits;
  for (const char* part : {"config", "state", "input", "output"}) {
    visits += print_visit(name, header, part) + "\n";
  }
  return fill_template(compilation_templates::kStep,
                       {{"name", name}, {"flat", flat}, {"visits", visits}});
}

std::vector<GeneratedFile> print_step_reference(const std::string& name,
                                                const std::vector<GeneratedFile>& files,
                                                const ControllerUnit& unit, const char* real) {
  constexpr std::array kNumbers = {"sin_cos.hpp", "square_root.hpp"};
  const std::string numbers =
      fill_template(compilation_templates::kStepNumbers, {{"name", name}, {"real", real}});
  std::vector<GeneratedFile> reference = {{name + ".hpp", numbers}};
  for (const char* file : kNumbers) {
    reference.push_back({file, fmt::format("#pragma once\n#include \"{}.hpp\"\n", name)});
  }
  for (const GeneratedFile& file : files) {
    const bool replaced =
        file.name == name + ".hpp" || std::count(kNumbers.begin(), kNumbers.end(), file.name) > 0;
    if (replaced || (file.name != "controller.cpp" && !file.name.ends_with(".hpp"))) continue;
    reference.push_back(file);
  }
  std::string header = find_controller_header(name, files);
  const std::string typed = fmt::format(" {}_number;", name);
  for (const char* emitted : {"typedef double", "typedef float"}) {
    header =
        replace_once(std::move(header), emitted + typed, fmt::format("typedef {}{}", real, typed));
  }
  reference.push_back({name + "_controller.h", header});
  std::string functions;
  const auto programs = unit.programs();
  for (std::size_t i = 0; i < programs.size(); ++i) {
    functions += print_handed_on(*programs[i], i) + "\n";
  }
  reference.push_back({kDynamicsStem + std::string(".cpp"),
                       fill_template(compilation_templates::kStepDynamics,
                                     {{"name", name}, {"functions", functions}})});
  reference.push_back(
      {kStepStem + std::string(".cpp"), print_step_entry(name, header, "long double")});
  return reference;
}

std::vector<std::string> list_reference_stems() {
  return {"controller", kDynamicsStem, kStepStem};
}

}  // namespace treeline
