#include "packaging/for_fmu.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

#include "emission/print_identity.hpp"
#include "generation/describe_scene.hpp"
#include "packaging/templates.hpp"

namespace treeline {
namespace {

namespace templates = package_templates;

constexpr const char* kStep = "0.001";  ///< s, the longest step of the integration inside

/// A name of FMI's structured convention: an identifier, or a text in quotes. What neither that
/// convention nor XML takes as it is becomes %XX.
std::string quote_name(const std::string& name) {
  constexpr std::string_view kPlain = " !#$()*+,-./:;=?@[]^_{}|~";
  std::string text;
  bool is_identifier = true;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_word = byte < 0x80 && (std::isalnum(byte) != 0 || c == '_');
    is_identifier = is_identifier && is_word;
    const bool stays = is_word || kPlain.find(c) != kPlain.npos;
    text += stays ? std::string(1, c) : fmt::format("%{:02X}", byte);
  }
  is_identifier = is_identifier && !text.empty() && std::isdigit(text.front()) == 0;
  return is_identifier ? text : "'" + text + "'";
}

/// A value of the unit. Values stand in the order of their references.
struct Variable {
  std::string name;
  std::string attributes;  ///< causality, variability, initial
  std::string meaning;
  std::string unit;
  std::string start = {};         ///< empty: computed
  std::size_t derivative_of = 0;  ///< number of a state, from 1 as FMI counts; 0: of none
};

/// The unit behind the last comma of a meaning, "angle, rad"; 1 where there is none.
std::string unit_of(const std::string& meaning) {
  const auto comma = meaning.rfind(", ");
  return comma == meaning.npos ? "1" : meaning.substr(comma + 2);
}

/// Names of the form `joint.symbol`, or `joint.symbol[i]` for joints with several entries.
std::vector<std::string> name_entries(const std::vector<std::string>& joints,
                                      const std::string& symbol) {
  std::map<std::string, int> counts, seen;
  std::vector<std::string> names;
  for (const std::string& joint : joints) ++counts[joint];
  for (const std::string& joint : joints) {
    const std::string index = counts[joint] > 1 ? fmt::format("[{}]", ++seen[joint]) : "";
    names.push_back(quote_name(joint) + "." + symbol + index);
  }
  return names;
}

constexpr const char* kState = R"(causality="output" variability="continuous" initial="exact")";
constexpr const char* kInput = R"(causality="input" variability="continuous")";
constexpr const char* kParameter = R"(causality="parameter" variability="fixed" initial="exact")";
constexpr const char* kRate = R"(causality="local" variability="continuous" initial="calculated")";
constexpr const char* kResult =
    R"(causality="output" variability="continuous" initial="calculated")";

/// Joints of the entries of q or of qd.
template <class Rows>
std::vector<std::string> joints_of(const Rows& rows) {
  std::vector<std::string> joints;
  for (const auto& row : rows) joints.push_back(row.joint);
  return joints;
}

/// The program of a function; null if there is none.
const Program* find_program(const Generation& generation, Function function) {
  for (const GeneratedFunction& generated : generation.functions) {
    if (generated.function == function) return &generated.program;
  }
  return nullptr;
}

void append_states(const EmissionContext& context, std::vector<Variable>& variables) {
  const auto& rows = context.coordinate_rows;
  const auto names = name_entries(joints_of(rows), "q");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::string meaning = rows[i].meaning;
    variables.push_back({names[i], kState, meaning.substr(0, meaning.rfind(", ")), unit_of(meaning),
                         fmt::format("{}", rows[i].home)});
  }
  const auto& moves = context.velocity_rows;
  const auto rates = name_entries(joints_of(moves), "qd");
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const std::string& name = moves[i].name;  // "elbow, rad/s" or "base linear x, m/s"
    const std::size_t end = name.rfind(", ");
    const std::size_t begin = std::min(end, moves[i].joint.size() + 1);
    const std::string which = name.substr(begin, end - begin);
    variables.push_back({rates[i], kState, which.empty() ? "velocity" : which, unit_of(name), "0"});
  }
}

/// The inputs in the order in which `forward_dynamics` takes them.
void append_inputs(const EmissionContext& context, const Program& program,
                   std::vector<Variable>& variables) {
  for (const Argument& argument : program.arguments) {
    if (argument.name == "tau") {
      const auto names = name_entries(joints_of(context.velocity_rows), "tau");
      for (std::size_t i = 0; i < names.size(); ++i) {
        const bool slides = unit_of(context.velocity_rows[i].name) == "m/s";
        variables.push_back({names[i], kInput, "joint force", slides ? "N" : "N.m", "0"});
      }
    } else if (argument.name == "f_ext") {
      for (const EmissionContext::PointRow& point : context.external_forces) {
        for (int i = 1; i <= 6; ++i) {
          variables.push_back({fmt::format("{}.f_ext[{}]", quote_name(point.name), i), kInput,
                               i <= 3 ? "force" : "moment", i <= 3 ? "N" : "N.m", "0"});
        }
      }
    }
  }
}

void append_rates(const EmissionContext& context, std::vector<Variable>& variables) {
  const std::size_t nq = context.coordinate_rows.size();
  for (std::size_t i = 0; i < nq; ++i) {
    const Variable& state = variables[i];
    const std::string unit = state.unit == "1" ? "1/s" : state.unit + "/s";
    variables.push_back({fmt::format("der({})", state.name), kRate, "dq/dt", unit, "", i + 1});
  }
  const auto names = name_entries(joints_of(context.velocity_rows), "qdd");
  for (std::size_t i = 0; i < names.size(); ++i) {
    variables.push_back(
        {names[i], kResult, "acceleration", variables[nq + i].unit + "2", "", nq + i + 1});
  }
}

std::vector<Variable> list_variables(const EmissionContext& context, const Program& program) {
  std::vector<Variable> variables;
  append_states(context, variables);
  append_inputs(context, program, variables);
  variables.push_back(
      {"step", kParameter, "longest step of the integration inside co-simulation", "s", kStep});
  append_rates(context, variables);
  return variables;
}

/// What differs between versions of FMI in the files of a unit. Its second version counts unknowns
/// from 1, the third calls them by their references.
struct Version {
  const char* variable;  ///< with holes for name, reference, meaning, attributes, and what follows
  const char* output;    ///< lines of lists, with a hole for the unknown
  const char* derivative;
  const char* initial_unknown;
  std::size_t first;        ///< number of the first variable
  const char* derivatives;  ///< the attribute that offers directional derivatives
  const char* source_file;  ///< with a hole for its name
  std::string_view description, wrapper, platform;
};

constexpr const char* kUnknown = "<Unknown index=\"{}\"{}/>\n";
const Version kSecond = {
    "<ScalarVariable name=\"{}\" valueReference=\"{}\" description=\"{}\" {}><Real{}/>"
    "</ScalarVariable>\n",
    kUnknown,
    kUnknown,
    kUnknown,
    1,
    "providesDirectionalDerivative",
    "<File name=\"{}\"/>\n",
    templates::kFmuModelDescription2,
    templates::kFmuWrapper2,
    templates::kFmuPlatform2};
const Version kThird = {"<Float64 name=\"{}\" valueReference=\"{}\" description=\"{}\" {}{}/>\n",
                        "<Output valueReference=\"{}\"{}/>\n",
                        "<ContinuousStateDerivative valueReference=\"{}\"{}/>\n",
                        "<InitialUnknown valueReference=\"{}\"{}/>\n",
                        0,
                        "providesDirectionalDerivatives",
                        "<SourceFile name=\"{}\"/>\n",
                        templates::kFmuModelDescription3,
                        templates::kFmuWrapper3,
                        templates::kFmuPlatform3};

std::string print_variable(const Version& version, std::size_t reference,
                           const Variable& variable) {
  std::string more = fmt::format(" unit=\"{}\"", variable.unit);
  if (!variable.start.empty()) more += fmt::format(" start=\"{}\"", variable.start);
  if (variable.derivative_of > 0) {
    more += fmt::format(" derivative=\"{}\"", variable.derivative_of - 1 + version.first);
  }
  return fmt::format(fmt::runtime(version.variable), variable.name, reference, variable.meaning,
                     variable.attributes, more);
}

/// Fills what modelDescription.xml says of variables. States depend on nothing else, so that no
/// importer sees a loop through tau and q.
void add_variables(const Version& version, const std::vector<Variable>& variables,
                   PackageFacts& facts) {
  for (std::size_t i = 0; i < variables.size(); ++i) {
    const auto add = [&](const char* list, const char* line, const std::string& depends = "") {
      facts[list] += fmt::format(fmt::runtime(line), i + version.first, depends);
    };
    const std::string attributes = variables[i].attributes;
    facts["variables"] += print_variable(version, i, variables[i]);
    if (attributes == kState) {
      add("outputs", version.output, fmt::format(" dependencies=\"{}\"", i + version.first));
    }
    if (attributes == kResult) add("outputs", version.output);
    if (variables[i].derivative_of == 0) continue;
    add("derivatives", version.derivative);
    add("initial_unknowns", version.initial_unknown);
  }
  for (const char* lines : {"variables", "outputs", "derivatives", "initial_unknowns"}) {
    facts[lines].pop_back();
  }
}

/// Rows {q, v, coordinates, velocities} of the joints.
std::string print_joints(const EmissionContext& context) {
  std::string text;
  for (const EmissionContext::JointRow& joint : context.joints) {
    text += fmt::format("{}{{{}, {}, {}, {}}}", text.empty() ? "" : ",\n", joint.first_coordinate,
                        joint.first_velocity, joint.coordinates, joint.velocities);
  }
  return text;
}

/// The call's arguments: q, qd and inputs are one array, `numbers`.
std::string print_call(const Program& program, std::size_t nq, std::size_t states) {
  std::string text;
  std::size_t next = states;
  for (const Argument& argument : program.arguments) {
    const bool is_state = argument.name == "q" || argument.name == "qd";
    text += fmt::format("numbers + {}, ", is_state ? (argument.name == "q" ? 0 : nq) : next);
    next += is_state ? 0 : static_cast<std::size_t>(argument.rows * argument.cols);
  }
  return text + "qdd";
}

std::string print_source_files(const Version& version, const PackageFacts& facts) {
  std::string text = fmt::format(fmt::runtime(version.source_file), "fmu.c");
  std::istringstream words(facts.at("sources"));
  constexpr std::size_t kFolder = std::string_view("../src/").size();
  for (std::string word; words >> word;) {
    text += fmt::format(fmt::runtime(version.source_file), word.substr(kFolder));
  }
  text.pop_back();
  return text;
}

/// Offers directional derivatives where the code has them: by q, qd and tau, and of rates that are
/// velocities.
void add_derivatives(const Version& version, const Generation& generation, bool has_others,
                     PackageFacts& facts) {
  const bool offers =
      !has_others && find_program(generation, Function::forward_dynamics_derivatives) != nullptr;
  facts["offers_derivatives"] = offers ? fmt::format(" {}=\"true\"", version.derivatives) : "";
  facts["differentiate"] =
      fill_facts(offers ? templates::kFmuDifferentiate : templates::kFmuNoDerivatives, facts);
  facts["differentiate"].pop_back();  // the last line break
}

}  // namespace

std::vector<PackageFolder> for_fmu(PackageKind kind, PackageFacts facts, const Robot& robot,
                                   const Scene& scene, const Generation& generation) {
  const bool is_third = kind == PackageKind::fmu3;
  const Version& version = is_third ? kThird : kSecond;
  const EmissionContext context = describe_scene(robot, scene, generation.mechanism);
  const Program& program = *find_program(generation, Function::forward_dynamics);
  const std::size_t nq = context.coordinate_rows.size();
  const std::size_t nv = context.velocity_rows.size();
  const std::vector<Variable> variables = list_variables(context, program);
  add_variables(version, variables, facts);
  facts["guid"] = digest_of_files(generation.files);
  facts["step"] = kStep;
  facts["nq"] = std::to_string(nq);
  facts["nv"] = std::to_string(nv);
  facts["inputs"] = std::to_string(variables.size() - 2 * (nq + nv) - 1);
  facts["joints"] = print_joints(context);
  facts["call"] = print_call(program, nq, nq + nv);
  facts["time"] = std::to_string(variables.size());
  facts["units"] = templates::kFmuUnits;
  facts["platform"] = version.platform;
  facts["source_files"] = print_source_files(version, facts);
  add_derivatives(version, generation, nq != nv || !context.external_forces.empty(), facts);
  const auto fill = [&](const std::string& name, std::string_view text) {
    return GeneratedFile{name, fill_facts(text, facts)};
  };
  std::vector<GeneratedFile> files = {
      fill("CMakeLists.txt", templates::kFmuCMakeLists), fill("fmu.c", version.wrapper),
      fill("fmu_model.h", templates::kFmuModel), fill("modelDescription.xml", version.description)};
  if (is_third) {
    files.push_back(fill("buildDescription.xml", templates::kFmuBuildDescription));
  }
  return {{"", std::move(files)}};
}

void refuse_for_fmu(const Scene& scene, Diagnostics& diagnostics) {
  const auto refuse = [&](bool applies, const char* key, const char* fault, const char* remedy) {
    if (applies) diagnostics.add({Severity::error, scene.file, 0, key, fault, remedy});
  };
  const bool moves = std::find(scene.functions.begin(), scene.functions.end(),
                               Function::forward_dynamics) != scene.functions.end();
  refuse(!moves, "functions", "an FMU integrates forward_dynamics, which is not among them",
         "Add forward_dynamics.");
  refuse(scene.sin_cos == Sines::given, "sin_cos", "an FMU computes sines and cosines itself",
         "Leave it out.");
  refuse(!scene.inputs.empty(), "inputs", "an FMU has its model fixed, and no such inputs",
         "Leave them out, and generate an FMU for each load.");
  refuse(scene.implicit_friction, "joint_friction",
         "implicit friction is that of one step, and an FMU's steps are the importer's",
         "Leave out `implicit`.");
  refuse(scene.holds_rows(), "constraints",
         "an FMU integrates forward_dynamics, which lets the robot go where rows are held",
         "Leave out constraints and couplings.");
  refuse(!scene.objects.empty(), "objects",
         "an FMU integrates forward_dynamics, which does not carry them", "Leave them out.");
}

}  // namespace treeline
