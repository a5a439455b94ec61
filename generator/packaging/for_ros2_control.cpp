#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "description/read_keys.hpp"
#include "emission/controller_faults.hpp"
#include "emission/controller_unit.hpp"
#include "emission/emitted_text.hpp"
#include "generation/describe_scene.hpp"
#include "packaging/package_kinds.hpp"
#include "packaging/templates.hpp"
#include "text/json_text.hpp"

namespace treeline {
namespace {

namespace templates = package_templates;

/// The package: ROS has names in small letters.
std::string ros_name(const std::string& name) {
  std::string text = name + "_controller";
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// A text in quotes, as C++, YAML and JSON have it.
std::string quote(const std::string& text) {
  return json_line(text);
}

/// So many times the same number, as lists in YAML have it.
std::string repeat(double number, std::size_t count) {
  std::string text = fmt::format("{}", number);
  if (text.find_first_of(".e") == text.npos) text += ".0";
  return fmt::format("{}", fmt::join(std::vector<std::string>(count, text), ", "));
}

/// A package of messages, and the one of it that the law has.
struct Message {
  const char* package;
  const char* header;
};

void add_messages(const std::vector<Message>& messages, PackageFacts& facts) {
  facts["messages"] = facts["message_headers"] = facts["message_targets"] = "";
  facts["depends"] =
      "<depend>controller_interface</depend>\n<depend>generate_parameter_library</depend>\n"
      "<depend>pluginlib</depend>\n<depend>rclcpp</depend>\n<depend>rclcpp_lifecycle</depend>";
  for (const Message& each : messages) {  // in the order of their names
    facts["messages"] += fmt::format("{}{}", facts["messages"].empty() ? "" : " ", each.package);
    facts["message_headers"] += fmt::format("#include <{}/{}>\n", each.package, each.header);
    facts["message_targets"] += fmt::format(" ${{{}_TARGETS}}", each.package);
    facts["depends"] += fmt::format("\n<depend>{}</depend>", each.package);
  }
  if (!messages.empty()) facts["message_headers"].pop_back();
}

/// What is there for points alone: topics, parameters, members and what is told.
void add_points(const ControllerUnit& unit, PackageFacts& facts) {
  for (const char* hole : {"point_topics", "point_rows", "point_members", "point_parameters",
                           "read_duration", "keep_unmet", "tell_unmet", "move_point"}) {
    facts[hole] = "";
  }
  if (unit.points.empty()) return;
  for (std::size_t i = 0; i < unit.points.size(); ++i) {
    const std::string topic = unit.points[i].name + "/pose";
    facts["point_topics"] += fmt::format(
        "subscriptions_.push_back(node.create_subscription<geometry_msgs::msg::PoseStamped>(\n"
        "    \"~/{}\", 1,\n    [this](const geometry_msgs::msg::PoseStamped& message) {{ "
        "move_point({}, message); }}));\n",
        topic, i);
    facts["point_rows"] += fmt::format(
        "| topic `{}`, geometry_msgs/PoseStamped in the frame of the root link | moves this point "
        "there in `move_duration`, or longer |\n",
        topic);
  }
  facts["point_topics"].pop_back();
  facts["point_rows"].pop_back();
  facts["point_members"] =
      "std::atomic<int32_t> unmet_{0};\nint32_t told_unmet_ = 0;\n"
      "double duration_ = 0;  ///< s, of motions of points";
  facts["read_duration"] = "duration_ = params.move_duration;";
  facts["keep_unmet"] = "unmet_ = output_.unmet;";
  facts["tell_unmet"] =
      "static constexpr const char* kUnmet[] = {\n"
      "    \"\", \"\", \"out of reach, or singular\", \"a joint's limit\", \"torques\", "
      "\"no contact\"};\n"
      "const int32_t unmet = unmet_;\n"
      "if (unmet != told_unmet_ && unmet != 0) {\n"
      "  RCLCPP_ERROR(*logger_, \"a motion was given up: %s\", kUnmet[unmet]);\n}\n"
      "told_unmet_ = unmet;";
  facts["point_parameters"] = templates::kRos2ControlPointParameters;
  facts["move_point"] = fill_holes(templates::kRos2ControlMovePoint, facts);
  facts["move_point"].pop_back();
}

/// The law by `NAME_step`. Returns its template.
std::string_view add_step(const ControllerUnit& unit, PackageFacts& facts) {
  std::vector<Message> messages = {{"std_srvs", "srv/trigger.hpp"},
                                   {"trajectory_msgs", "msg/joint_trajectory.hpp"}};
  if (!unit.points.empty()) {
    messages.insert(messages.begin(), {"geometry_msgs", "msg/pose_stamped.hpp"});
  }
  add_messages(messages, facts);
  std::vector<std::string> faults;
  for (const ControllerFault& fault : kControllerFaults) faults.push_back(quote(fault.meaning));
  facts["fault_names"] = fmt::format("{}", fmt::join(faults, ",\n"));
  facts["joint_frequency"] = repeat(unit.settings.joint_frequency, unit.joints.size());
  facts["joint_damping"] = repeat(unit.settings.damping_ratio, unit.joints.size());
  add_points(unit, facts);
  facts["law_parameters"] = fill_holes(templates::kRos2ControlStepParameters, facts);
  facts["law_description"] =
      "It leads joints and points along references within limits, and brakes at faults.";
  facts["states"] = "`position` and `velocity`";
  facts["rate"] = std::to_string(std::lround(1 / unit.settings.period));
  facts["period_note"] =
      fmt::format("\nThe period of a step is one over the update rate; it was generated for {} s.",
                  unit.settings.period);
  facts["topics"] = fill_holes(templates::kRos2ControlTopics, facts);
  return templates::kRos2ControlStepLaw;
}

/// The law by `NAME_gravity`. Returns its template.
std::string_view add_gravity(PackageFacts& facts) {
  add_messages({}, facts);
  facts["law_description"] =
      "It holds the robot against gravity, so that it is led by hand: nothing brakes it.";
  facts["states"] = "`position`";
  facts["rate"] = "1000";
  facts["law_parameters"] = facts["period_note"] = facts["topics"] = "";
  return templates::kRos2ControlGravityLaw;
}

}  // namespace

std::vector<PackageFolder> for_ros2_control(PackageFacts facts, const Robot& robot,
                                            const Scene& scene, const Generation& generation) {
  const EmissionContext context = describe_scene(robot, scene, generation.mechanism);
  std::vector<std::string> joints;
  for (const auto& row : context.coordinate_rows) joints.push_back(quote(row.joint));
  facts["package"] = ros_name(scene.name);
  facts["nv"] = std::to_string(joints.size());
  facts["joint_names"] = fmt::format("{}", fmt::join(joints, ",\n"));
  facts["joint_list"] = fmt::format("{}", fmt::join(joints, ", "));
  facts["root_link"] = quote(robot.links.at(static_cast<std::size_t>(robot.root)).name);
  const std::string_view law =
      generation.controller ? add_step(*generation.controller, facts) : add_gravity(facts);
  const auto fill = [&](const std::string& name, std::string_view text) {
    return GeneratedFile{name, fill_holes(text, facts)};
  };
  return {{"",
           {fill("CMakeLists.txt", templates::kRos2ControlCMakeLists),
            fill("README.md", templates::kRos2ControlReadme),
            fill("controller.cpp", templates::kRos2ControlPlugin),
            fill("controllers.yaml", templates::kRos2ControlControllers), fill("law.hpp", law),
            fill("package.xml", templates::kRos2ControlPackage),
            fill("parameters.yaml", templates::kRos2ControlParameters),
            fill(facts["package"] + ".xml", templates::kRos2ControlPluginDescription)}}};
}

void refuse_for_ros2_control(const Robot& robot, const Scene& scene, Diagnostics& diagnostics) {
  const auto refuse = [&](bool applies, const char* key, const std::string& fault,
                          const char* remedy) {
    if (applies) diagnostics.add({Severity::error, scene.file, 0, key, fault, remedy});
  };
  const bool steps = scene.controller.has_value();
  refuse(!scene.inputs.empty(), "inputs", "ros2_control has no interface for them",
         "Leave them out, and generate a package for each load.");
  refuse(steps && !scene.external_forces.empty(), "external_forces",
         "ros2_control has no interface for them", "Leave them out.");
  refuse(steps && scene.controller->force, "controller.laws",
         "a package for ros2_control reads no sensor of forces",
         "Keep to joint_impedance and task_impedance.");
  if (steps) return;
  const bool weighs = std::find(scene.functions.begin(), scene.functions.end(),
                                Function::gravity) != scene.functions.end();
  refuse(!weighs, "functions", "without a controller the law is gravity, which is not among them",
         "Add gravity, or a controller.");
  refuse(scene.sin_cos == Sines::given, "sin_cos", "the law computes sines and cosines itself",
         "Leave it out.");
  refuse(scene.base == Base::floating, "base", "no motor moves a floating base",
         "Fix the base, or write a controller of your own.");
  const std::string unfit = find_unfit_joint(robot, scene);
  refuse(!unfit.empty(), "", "ros2_control drives every joint by its motor, but " + unfit,
         "Lock the joint, or write a controller of your own.");
  refuse(scene.holds_rows(), "constraints", "gravity is that of the open tree",
         "Leave out constraints and couplings.");
}

}  // namespace treeline
