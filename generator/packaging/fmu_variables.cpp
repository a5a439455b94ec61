#include "packaging/fmu_variables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <string_view>

namespace treeline {
namespace {

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

constexpr const char* kInput = R"(causality="input" variability="continuous")";
constexpr const char* kCommand = R"(causality="input" variability="discrete")";
constexpr const char* kParameter = R"(causality="parameter" variability="fixed" initial="exact")";
constexpr const char* kRate = R"(causality="local" variability="continuous" initial="calculated")";

/// Joints of the entries of q or of qd.
template <class Rows>
std::vector<std::string> joints_of(const Rows& rows) {
  std::vector<std::string> joints;
  for (const auto& row : rows) joints.push_back(row.joint);
  return joints;
}

void append_states(const EmissionContext& context, std::vector<FmuVariable>& variables) {
  const auto& rows = context.coordinate_rows;
  const auto names = name_entries(joints_of(rows), "q");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::string meaning = rows[i].meaning;
    variables.push_back({names[i], kFmuState, meaning.substr(0, meaning.rfind(", ")),
                         unit_of(meaning), fmt::format("{}", rows[i].home)});
  }
  const auto& moves = context.velocity_rows;
  const auto rates = name_entries(joints_of(moves), "qd");
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const std::string& name = moves[i].name;  // "elbow, rad/s" or "base linear x, m/s"
    const std::size_t end = name.rfind(", ");
    const std::size_t begin = std::min(end, moves[i].joint.size() + 1);
    const std::string which = name.substr(begin, end - begin);
    variables.push_back(
        {rates[i], kFmuState, which.empty() ? "velocity" : which, unit_of(name), "0"});
  }
}

/// The inputs in the order in which `forward_dynamics` takes them.
void append_inputs(const EmissionContext& context, const Program& program,
                   std::vector<FmuVariable>& variables) {
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

void append_rates(const EmissionContext& context, std::vector<FmuVariable>& variables) {
  const std::size_t nq = context.coordinate_rows.size();
  for (std::size_t i = 0; i < nq; ++i) {
    const FmuVariable& state = variables[i];
    const std::string unit = state.unit == "1" ? "1/s" : state.unit + "/s";
    variables.push_back({fmt::format("der({})", state.name), kRate, "dq/dt", unit, "", i + 1});
  }
  const auto names = name_entries(joints_of(context.velocity_rows), "qdd");
  for (std::size_t i = 0; i < names.size(); ++i) {
    variables.push_back(
        {names[i], kFmuResult, "acceleration", variables[nq + i].unit + "2", "", nq + i + 1});
  }
}

/// How many numbers a member of the controller's structs has.
enum class Count { joints, points, one, three, nine };

/// A member of the input or the output of a controller's step.
struct StepMember {
  const char* path;
  const char* kind;  ///< of its numbers, in C
  Count count;
  const char* unit;
  const char* meaning;
  bool of_task = false, of_force = false;  ///< is there for such a law alone
};

constexpr StepMember kOfInput[] = {
    {"q", "REAL", Count::joints, "", "measured position"},
    {"qd", "REAL", Count::joints, "", "measured velocity"},
    {"force", "REAL", Count::three, "N", "measured, that the pressing point exerts, world", true,
     true},
    {"command.kind", "WHOLE", Count::one, "1", "number of the command"},
    {"command.sequence", "BITS", Count::one, "1", "another number for each command"},
    {"command.point", "WHOLE", Count::one, "1", "index of the operational point"},
    {"command.duration", "REAL", Count::one, "s", "of the motion, or longer"},
    {"command.goal", "REAL", Count::joints, "", "goal of MOVE_JOINTS"},
    {"command.position", "REAL", Count::three, "m", "goal of MOVE_POINT, world", true},
    {"command.rotation", "REAL", Count::nine, "1", "of the point's axes, row by row", true},
    {"command.direction", "REAL", Count::three, "1", "of PRESS, of length 1, world", true, true},
    {"command.force", "REAL", Count::one, "N", "that the point shall exert", true, true}};
constexpr StepMember kOfOutput[] = {
    {"tau", "REAL", Count::joints, "", "for the motors"},
    {"mode", "WHOLE", Count::one, "1", "idle 0, running 1, stopping 2, faulted 3"},
    {"faults", "BITS", Count::one, "1", "bits, until RESET"},
    {"reason", "BITS", Count::one, "1", "bits of the step that led to the mode faulted"},
    {"brakes", "WHOLE", Count::one, "1", "1: close the mechanical brakes now"},
    {"refused", "WHOLE", Count::one, "1", "why this step's command was refused, or 0"},
    {"saturated", "WHOLE", Count::one, "1", "1: the torque was cut"},
    {"factor", "REAL", Count::one, "1", "by which it was shortened"},
    {"joint_error", "REAL", Count::joints, "", "reference less measured"},
    {"task_error", "REAL", Count::points, "1", "m, rad: reference less measured, world", true},
    {"unmet", "WHOLE", Count::one, "1", "why a motion was given up, or 0", true},
    {"force_error", "REAL", Count::one, "N", "wanted less measured", true, true}};

/// The unit of a member of joints: of velocities, of torques, else of positions.
std::string unit_of_member(std::string_view path, const EmissionContext& context, std::size_t i) {
  const std::string velocity = unit_of(context.velocity_rows[i].name);
  if (path == "qd") return velocity;
  const bool slides = velocity == "m/s";
  if (path == "tau") return slides ? "N" : "N.m";
  return slides ? "m" : "rad";
}

/// Adds the values of a member, and its row in the table in C.
void append_member(const StepMember& member, const EmissionContext& context,
                   const ControllerUnit& unit, bool is_input, FmuController& made) {
  const std::string path = member.path;
  const std::string attributes = !is_input                      ? kFmuStepped
                                 : path.starts_with("command.") ? kCommand
                                                                : kInput;
  const auto add = [&](const std::string& name, const std::string& its_unit, double start) {
    (is_input ? made.inputs : made.outputs)
        .push_back({name, attributes, member.meaning, its_unit,
                    is_input ? fmt::format("{}", start) : std::string()});
  };
  std::size_t count = 1;
  if (member.count == Count::joints) {
    count = unit.joints.size();
    const std::string symbol = path.substr(path.rfind('.') + 1);
    const auto names = name_entries(joints_of(context.velocity_rows), symbol);
    for (std::size_t i = 0; i < count; ++i) {
      add(names[i], unit_of_member(path, context, i),
          symbol == "q" ? context.coordinate_rows[i].home : 0);
    }
  } else {
    if (member.count == Count::points) count = 6 * unit.points.size();
    if (member.count == Count::three) count = 3;
    if (member.count == Count::nine) count = 9;
    for (std::size_t i = 0; i < count; ++i) {
      const bool is_diagonal = member.count == Count::nine && i % 4 == 0;
      add(count == 1 ? path : fmt::format("{}[{}]", path, i + 1), member.unit, is_diagonal ? 1 : 0);
    }
  }
  std::string& table = is_input ? made.input_members : made.output_members;
  table += fmt::format("{}{{offsetof({}_{}, {}), {}, {}}}", table.empty() ? "" : ",\n",
                       context.name, is_input ? "input" : "output", path, count, member.kind);
}

}  // namespace

std::vector<FmuVariable> list_fmu_variables(const EmissionContext& context,
                                            const Program& program) {
  std::vector<FmuVariable> variables;
  append_states(context, variables);
  append_inputs(context, program, variables);
  variables.push_back(
      {"step", kParameter, "longest step of the integration inside co-simulation", "s", kFmuStep});
  append_rates(context, variables);
  return variables;
}

FmuController list_fmu_controller(const EmissionContext& context, const ControllerUnit& unit) {
  FmuController made;
  const auto has = [&](const StepMember& member) {
    return (!member.of_task || unit.settings.task) && (!member.of_force || unit.settings.force);
  };
  for (const StepMember& member : kOfInput) {
    if (has(member)) append_member(member, context, unit, true, made);
  }
  for (const StepMember& member : kOfOutput) {
    if (has(member)) append_member(member, context, unit, false, made);
  }
  return made;
}

}  // namespace treeline
