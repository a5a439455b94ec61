#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "emission/emitted_text.hpp"
#include "emission/print_files.hpp"
#include "generation/describe_scene.hpp"
#include "packaging/fmu_variables.hpp"
#include "packaging/package_kinds.hpp"
#include "packaging/templates.hpp"

namespace treeline {
namespace {

namespace templates = package_templates;

/// The program of a function; null if there is none.
const Program* find_program(const Generation& generation, Function function) {
  for (const GeneratedFunction& generated : generation.functions) {
    if (generated.function == function) return &generated.program;
  }
  return nullptr;
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
  const char *begin, *end;  ///< of the list of derivatives
  std::string_view model_exchange, description, wrapper, platform;
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
    "<Derivatives>\n",
    "</Derivatives>\n",
    templates::kFmuModelExchange2,
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
                        "",
                        "",
                        templates::kFmuModelExchange3,
                        templates::kFmuModelDescription3,
                        templates::kFmuWrapper3,
                        templates::kFmuPlatform3};

std::string print_variable(const Version& version, std::size_t reference,
                           const FmuVariable& variable) {
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
void add_variables(const Version& version, const std::vector<FmuVariable>& variables,
                   PackageFacts& facts) {
  for (std::size_t i = 0; i < variables.size(); ++i) {
    const auto add = [&](const char* list, const char* line, const std::string& depends = "") {
      facts[list] += fmt::format(fmt::runtime(line), i + version.first, depends);
    };
    const std::string attributes = variables[i].attributes;
    facts["variables"] += print_variable(version, i, variables[i]);
    if (attributes == kFmuState) {
      add("outputs", version.output, fmt::format(" dependencies=\"{}\"", i + version.first));
    }
    const bool is_stepped = attributes == kFmuStepped;
    if (attributes == kFmuResult || is_stepped) add("outputs", version.output);
    const bool is_rate = variables[i].derivative_of > 0;
    if (is_rate) add("derivatives", version.derivative);
    if (is_rate || is_stepped) add("initial_unknowns", version.initial_unknown);
  }
  if (!facts["derivatives"].empty()) {
    facts["derivatives"] = version.begin + facts["derivatives"] + version.end;
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

std::string print_source_files(const Version& version, const Scene& scene,
                               const Generation& generation) {
  std::string text = fmt::format(fmt::runtime(version.source_file), "fmu.c");
  for (const PackagedSource& source : list_packaged_sources(scene, generation)) {
    text += fmt::format(fmt::runtime(version.source_file), source.file);
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
      fill_holes(offers ? templates::kFmuDifferentiate : templates::kFmuNoDerivatives, facts);
  facts["differentiate"].pop_back();  // the last line break
}

/// What the unit of a robot has of its own. Returns its values.
std::vector<FmuVariable> add_robot(const Version& version, const EmissionContext& context,
                                   const Generation& generation, PackageFacts& facts) {
  const Program& program = *find_program(generation, Function::forward_dynamics);
  const std::size_t nq = context.coordinate_rows.size();
  const std::size_t nv = context.velocity_rows.size();
  std::vector<FmuVariable> variables = list_fmu_variables(context, program);
  facts["what"] = "Rigid-body dynamics";
  facts["step"] = kFmuStep;
  facts["nq"] = std::to_string(nq);
  facts["nv"] = std::to_string(nv);
  facts["inputs"] = std::to_string(variables.size() - 2 * (nq + nv) - 1);
  facts["joints"] = print_joints(context);
  facts["call"] = print_call(program, nq, nq + nv);
  add_derivatives(version, generation, nq != nv || !context.external_forces.empty(), facts);
  facts["model_exchange"] = fill_holes(version.model_exchange, facts);
  return variables;
}

/// What the unit of a controller has of its own: it steps, and has nothing to integrate.
std::vector<FmuVariable> add_controller(const EmissionContext& context, const ControllerUnit& unit,
                                        PackageFacts& facts) {
  FmuController controller = list_fmu_controller(context, unit);
  facts["what"] = "Controller";
  facts["step"] = fmt::format("{}", unit.settings.period);
  facts["inputs"] = std::to_string(controller.inputs.size());
  facts["count"] = std::to_string(controller.inputs.size() + controller.outputs.size());
  facts["input_members"] = controller.input_members;
  facts["output_members"] = controller.output_members;
  facts["model_exchange"] = facts["offers_derivatives"] = "";
  facts["differentiate"] = templates::kFmuNoDerivatives;
  std::vector<FmuVariable> variables = std::move(controller.inputs);
  std::move(controller.outputs.begin(), controller.outputs.end(), std::back_inserter(variables));
  return variables;
}

std::vector<PackageFolder> for_fmu(const Version& version, PackageFacts facts, const Robot& robot,
                                   const Scene& scene, const Generation& generation) {
  const EmissionContext context = describe_scene(robot, scene, generation.mechanism);
  facts["guid"] = digest_of_files(generation.files);
  facts["exporting"] = templates::kFmuExporting;
  facts["units"] = templates::kFmuUnits;
  facts["platform"] = version.platform;
  facts["source_files"] = print_source_files(version, scene, generation);
  const bool controls = generation.controller != nullptr;
  const std::vector<FmuVariable> variables =
      controls ? add_controller(context, *generation.controller, facts)
               : add_robot(version, context, generation, facts);
  add_variables(version, variables, facts);
  facts["time"] = std::to_string(variables.size());
  const auto fill = [&](const std::string& name, std::string_view text) {
    return GeneratedFile{name, fill_holes(text, facts)};
  };
  std::vector<GeneratedFile> files = {
      fill("CMakeLists.txt", templates::kFmuCMakeLists), fill("fmu.c", version.wrapper),
      fill("fmu_model.h", controls ? templates::kFmuController : templates::kFmuModel),
      fill("modelDescription.xml", version.description)};
  if (&version == &kThird) {
    files.push_back(fill("buildDescription.xml", templates::kFmuBuildDescription));
  }
  return {{"", std::move(files)}};
}

}  // namespace

std::vector<PackageFolder> for_fmu2(PackageFacts facts, const Robot& robot, const Scene& scene,
                                    const Generation& generation) {
  return for_fmu(kSecond, std::move(facts), robot, scene, generation);
}

std::vector<PackageFolder> for_fmu3(PackageFacts facts, const Robot& robot, const Scene& scene,
                                    const Generation& generation) {
  return for_fmu(kThird, std::move(facts), robot, scene, generation);
}

void refuse_for_fmu(const Robot& /*robot*/, const Scene& scene, Diagnostics& diagnostics) {
  const auto refuse = [&](bool applies, const char* key, const char* fault, const char* remedy) {
    if (applies) diagnostics.add({Severity::error, scene.file, 0, key, fault, remedy});
  };
  refuse(!scene.inputs.empty(), "inputs", "an FMU has its model fixed, and no such inputs",
         "Leave them out, and generate an FMU for each load.");
  if (scene.controller) {
    refuse(!scene.external_forces.empty(), "external_forces",
           "an FMU of a controller has no such inputs", "Leave them out.");
    return;
  }
  const bool moves = std::find(scene.functions.begin(), scene.functions.end(),
                               Function::forward_dynamics) != scene.functions.end();
  refuse(!moves, "functions", "an FMU integrates forward_dynamics, which is not among them",
         "Add forward_dynamics.");
  refuse(scene.sin_cos == Sines::given, "sin_cos", "an FMU computes sines and cosines itself",
         "Leave it out.");
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
