#include "packaging/python_structs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>

#include "emission/c_family_syntax.hpp"
#include "emission/controller_unit.hpp"
#include "emission/emitted_text.hpp"
#include "emission/list_members.hpp"
#include "emission/print_manifest.hpp"
#include "packaging/call_c.hpp"
#include "packaging/templates.hpp"
#include "passes/count_operations.hpp"
#include "text/identifier.hpp"

namespace treeline {
namespace {

namespace templates = package_templates;

/// A type of an emitted header: the name in C behind `NAME_`.
struct HeaderType {
  const char* type;
  const char* base;  ///< of an enumeration in Python; null: a struct
  const char* meaning;
  const char* initial = "";  ///< the function that fills a struct; empty: it begins with zeros
};

constexpr HeaderType kOfController[] = {
    {"behaviour", "IntEnum", "Sets of tasks."},
    {"mode", "IntEnum", "Modes."},
    {"fault", "IntFlag", "Bits of faults."},
    {"kind", "IntEnum", "Kinds of commands."},
    {"refusal", "IntEnum", "Why a command was refused. What went on before goes on."},
    {"unmet", "IntEnum", "Why the motion of a point was given up."},
    {"config_field", "IntEnum", "Members of the configuration."},
    {"config", nullptr, "Gains and limits; they may change at any step.", "_default_config"},
    {"command", nullptr, "A command."},
    {"input", nullptr, "What a step takes."},
    {"output", nullptr, "What a step gives."},
    {"state", nullptr, "What a step leaves for the next. Zeros are the state to begin with."}};
constexpr HeaderType kOfLimits[] = {
    {"cone_row", nullptr, "A row of a cone."},
    {"torque_limits", nullptr, "What may be asked of motors and supports.", "_default_limits"},
    {"limited_torque", nullptr,
     "What became of the limits; the same object in every cycle starts from the last."}};

/// Members of whole numbers that are enumerators.
struct CodedMember {
  const char* member;
  const char* enumeration;
};
constexpr CodedMember kCoded[] = {
    {"behaviour", "Behaviour"}, {"mode", "Mode"},   {"faults", "Fault"}, {"reason", "Fault"},
    {"refused", "Refusal"},     {"unmet", "Unmet"}, {"kind", "Kind"}};

/// The text of a file; empty where the scene does not ask for it.
std::string find_text(const Generation& generation, const std::string& name) {
  const auto found = std::find_if(generation.files.begin(), generation.files.end(),
                                  [&](const GeneratedFile& file) { return file.name == name; });
  return found == generation.files.end() ? "" : found->text;
}

/// What Python and NumPy know of a type of C: how NumPy writes it, or the struct's name.
std::string print_format(const Scene& scene, const std::string& type) {
  if (type == "int32_t" || type == "uint32_t") return type.starts_with('u') ? "u4" : "i4";
  if (type == "bool") return "?";
  const bool is_struct = type != scene.name + "_number" && type.starts_with(scene.name + "_");
  if (is_struct) return type.substr(scene.name.size() + 1);
  return scene.real == Real::float32 ? "f4" : "f8";
}

/// A class of enumerators, whose names have neither the robot nor the enumeration in front; empty
/// where the header has none.
std::string print_enumeration(const Scene& scene, const HeaderType& type,
                              const std::string& header) {
  std::string text = fmt::format("class {}(enum.{}):\n    \"\"\"{}\"\"\"\n\n",
                                 in_pascal_case(type.type), type.base, type.meaning);
  const std::string own = in_capitals(type.type) + "_";
  const auto enumerators = list_enumerators(header, scene.name + "_" + type.type);
  if (enumerators.empty()) return {};
  for (const auto& [full, value] : enumerators) {
    const std::string name = full.substr(scene.name.size() + 1);
    text +=
        fmt::format("    {} = {}\n", name.starts_with(own) ? name.substr(own.size()) : name, value);
  }
  return text + "\n\n";
}

/// A member of a class, with what C says of it.
std::string print_member(const StructMember& member, const std::string& format) {
  const bool is_struct = format.size() > 2;
  if (is_struct && !member.is_array) {
    return fmt::format("    {} = Inner({})\n", member.name, in_pascal_case(format));
  }
  const char* type = "Any";
  if (member.is_array) {
    type = is_struct ? "NDArray[np.void]" : format[0] == 'f' ? "_Array" : "NDArray[np.int32]";
  }
  const auto* const coded = std::ranges::find(
      kCoded, member.name, [](const CodedMember& each) { return std::string(each.member); });
  return fmt::format("    {} = Member[{}]({}{})\n", member.name, type, quote_json(member.meaning),
                     coded == std::end(kCoded) ? "" : ", " + std::string(coded->enumeration));
}

/// Adds types of a header: classes of Python, and tables of C.
template <std::size_t count>
void add_types(const Scene& scene, const HeaderType (&types)[count], const std::string& header,
               PackageFacts& facts) {
  for (const HeaderType& type : types) {
    if (type.base != nullptr) {
      facts["classes"] += print_enumeration(scene, type, header);
      continue;
    }
    const std::string in_c = scene.name + "_" + type.type;
    std::string members;
    std::string rows;
    for (const StructMember& member : list_members(header, in_c)) {
      const std::string format = print_format(scene, member.type);
      members += print_member(member, format);
      rows += fmt::format("{}    MEMBER({}, {}, \"{}\", {})", rows.empty() ? "" : ",\n", in_c,
                          member.name, format, member.is_array);
    }
    facts["classes"] += fmt::format(
        "class {}(Struct):\n    \"\"\"{}\"\"\"\n\n    __slots__ = ()\n"
        "    _struct = \"{}\"\n    _initial = \"{}\"\n{}\n\n",
        in_pascal_case(type.type), type.meaning, type.type, type.initial, members);
    facts["members"] +=
        fmt::format("static const Member members_of_{}[] = {{\n{}}};\n", type.type, rows);
    facts["layouts"] +=
        fmt::format("{}LAYOUT(\"{}\", {}, members_of_{})", facts["layouts"].empty() ? "" : ",\n",
                    type.type, in_c, type.type);
  }
}

/// Lets the package have names of structs.py.
void export_names(std::initializer_list<const char*> names, PythonStructs& made) {
  for (const char* const name : names) {
    made.exported += (made.exported.empty() ? "" : ", ") + std::string(name);
    made.imports += fmt::format("from .structs import {0} as {0}\n", name);
  }
}

/// An entry of the table of arguments: a struct as so many numbers.
std::string print_struct(const Scene& scene, const std::string& type) {
  return fmt::format("{{\"{}\", REALS({}_{}), 1}}", type, scene.name, type);
}

void add_controller(const Scene& scene, const Generation& generation, PackageFacts& facts,
                    PythonStructs& made) {
  const std::string header = find_text(generation, scene.name + "_controller.h");
  if (header.empty()) return;
  add_types(scene, kOfController, header, facts);
  facts["classes"] += fill_holes(templates::kPythonController, facts);
  if (generation.controller->behaves()) export_names({"Behaviour"}, made);
  export_names({"Controller", "Fault", "Kind", "Mode", "Refusal", "Unmet"}, made);
  made.inputs +=
      fmt::format(" + REALS({0}_config) + REALS({0}_state) + REALS({0}_input)", scene.name);
  made.includes += fmt::format("#include \"../src/{}_controller.h\"\n", scene.name);
  const std::string& name = scene.name;
  const auto entry = [&](const char* type) { return print_struct(scene, type); };
  int operations = 0;
  for (const Program* const program : generation.controller->programs()) {
    operations += count_operations(*program).flops();
  }
  made.calls.push_back({"default_config",
                        fmt::format("(void)in;\n{0}_default_config(({0}_config*)out[0]);", name),
                        "", 0, 1, -1, entry("config"), 0});
  made.calls.push_back({"check_config",
                        fmt::format("int32_t index = 0;\n"
                                    "out[0][0] = (Real){0}_check_config((const {0}_config*)in[0], "
                                    "&index);\nout[0][1] = (Real)index;",
                                    name),
                        "", 1, 1, -1, entry("config") + ", {\"field\", 2, 1}", 0});
  made.calls.push_back(
      {"step",
       fmt::format("{0}_step((const {0}_config*)in[0], ({0}_state*)in[1], (const {0}_input*)in[2], "
                   "({0}_output*)out[0]);",
                   name),
       "", 3, 1, 1,
       entry("config") + ", " + entry("state") + ", " + entry("input") + ", " + entry("output"),
       operations});
}

/// Calls limited control with the arguments of the function that it limits, and two structs.
StructCall make_limited_call(const Scene& scene, const GeneratedFunction& supported) {
  StructCall call;
  call.name = "limited_control_torque";
  call.result = "LimitedControlTorque";
  call.operations = supported.chosen.count.flops();
  std::string passed;
  for (const Argument& argument : supported.program.arguments) {
    call.arguments +=
        fmt::format("{{\"{}\", {}, {}}}, ", argument.name, argument.rows, argument.cols);
    passed += fmt::format("in[{}], ", call.inputs++);
  }
  call.kept = call.inputs;
  call.inputs += 2;
  call.arguments +=
      print_struct(scene, "limited_torque") + ", " + print_struct(scene, "torque_limits");
  for (const auto& [result, values] : supported.program.results) {
    call.arguments += fmt::format(", {{\"{}\", {}, {}}}", result.name, result.rows, result.cols);
    passed += fmt::format("out[{}], ", call.outputs++);
  }
  call.call = fmt::format(
      "{0}_limited_control_torque({1}({0}_limited_torque*)in[{2}], "
      "(const {0}_torque_limits*)in[{3}]);",
      scene.name, passed, call.kept, call.kept + 1);
  return call;
}

void add_limits(const Scene& scene, const Generation& generation, PackageFacts& facts,
                PythonStructs& made) {
  const std::string header = find_text(generation, scene.name + "_limited.h");
  if (header.empty()) return;
  add_types(scene, kOfLimits, header, facts);
  export_names({"LimitedTorque", "TorqueLimits", "limited_control_torque"}, made);
  made.inputs += fmt::format(" + REALS({0}_limited_torque) + REALS({0}_torque_limits)", scene.name);
  made.includes += fmt::format("#include \"../src/{}_limited.h\"\n", scene.name);
  made.calls.push_back({"default_limits",
                        fmt::format("(void)in;\nmemcpy(out[0], &{0}_default_limits, "
                                    "sizeof({0}_default_limits));",
                                    scene.name),
                        "", 0, 1, -1, print_struct(scene, "torque_limits"), 0});
  const auto supported = std::ranges::find(generation.functions, Function::supported_control_torque,
                                           &GeneratedFunction::function);
  made.calls.push_back(make_limited_call(scene, *supported));
  for (const Argument& argument : supported->program.arguments) {
    facts["list"] += argument.name + ": _Array,\n";
    facts["list_passed"] += argument.name + ",\n";
  }
  const StructCall& call = made.calls.back();
  facts["limited_result"] = call.outputs > 1 ? call.result : "_Array";
  if (call.outputs > 1) {
    made.types = print_result_class(call.result, supported->program.results);
    facts["type_imports"] = fmt::format("if TYPE_CHECKING:\n    from . import {}\n", call.result);
  }
  facts["limited_doc"] = find_comment(generation.files, scene.name + "_limited_control_torque");
  facts["classes"] += fill_holes(templates::kPythonLimited, facts);
}

}  // namespace

std::string print_result_class(const std::string& type, const std::vector<Result>& results) {
  std::string arrays;
  std::string names;
  std::string fields;
  for (const Result& result : results) {
    arrays += ", _Array";
    names += fmt::format(", \"{}\"", result.argument.name);
    fields += fmt::format("    @property\n    def {}(self) -> _Array: ...\n", result.argument.name);
  }
  return fmt::format("@final\nclass {}(structseq[_Array], tuple[{}]):\n", type, arrays.substr(2)) +
         fmt::format("    __match_args__: Final = ({})\n{}\n", names.substr(2), fields);
}

PythonStructs make_python_structs(const PackageFacts& given, const Scene& scene,
                                  const Generation& generation) {
  PackageFacts facts = given;
  facts["type_imports"] = "";
  PythonStructs made;
  add_controller(scene, generation, facts, made);
  add_limits(scene, generation, facts, made);
  if (made.calls.empty()) return made;
  made.header = fill_holes(templates::kPythonStructsHeader, facts);
  made.module = fill_holes(templates::kPythonStructs, facts);
  return made;
}

}  // namespace treeline
