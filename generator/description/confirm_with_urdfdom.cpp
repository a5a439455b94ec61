#include "description/confirm_with_urdfdom.hpp"

#include <console_bridge/console.h>
#include <fmt/format.h>
#include <urdf_parser/urdf_parser.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <mutex>
#include <set>

#include "description/read_number.hpp"
#include "description/rotation.hpp"
#include "description/urdf_parts.hpp"

namespace treeline {
namespace {

/// Collects what urdfdom logs for as long as it lives, and keeps it off the user's screen.
class CapturedLog : public console_bridge::OutputHandler {
 public:
  CapturedLog() : level_(console_bridge::getLogLevel()) {
    console_bridge::useOutputHandler(this);
    console_bridge::setLogLevel(console_bridge::CONSOLE_BRIDGE_LOG_WARN);
  }
  ~CapturedLog() override {
    console_bridge::setLogLevel(level_);
    console_bridge::restorePreviousOutputHandler();
  }
  CapturedLog(const CapturedLog&) = delete;
  CapturedLog& operator=(const CapturedLog&) = delete;

  void log(const std::string& message, console_bridge::LogLevel, const char*, int) override {
    if (!text.empty()) text += "; ";
    text += message;
  }

  std::string text;

 private:
  console_bridge::LogLevel level_;
};

/// Writes what concerns the dynamics, numbers as the file has them, so that they are read twice.
class EssentialUrdf {
 public:
  explicit EssentialUrdf(const Robot& robot) {
    printer_.PushHeader(false, true);
    printer_.OpenElement("robot");
    printer_.PushAttribute("name", robot.name.c_str());
  }

  void add_link(const tinyxml2::XMLElement& link) {
    open("link", &link, {"name"});
    if (const auto* inertial = link.FirstChildElement("inertial")) {
      printer_.OpenElement("inertial");
      add_origin(*inertial);
      add("mass", inertial->FirstChildElement("mass"), {"value"});
      const std::initializer_list<const char*> moments{"ixx", "ixy", "ixz", "iyy", "iyz", "izz"};
      add("inertia", inertial->FirstChildElement("inertia"), moments, "0");
      printer_.CloseElement();
    }
    printer_.CloseElement();
  }

  void add_joint(const tinyxml2::XMLElement& joint, const Joint& read) {
    const bool standard = info_of(read.type).is_standard;
    open("joint", &joint, {"name"});
    // Of all types that urdfdom knows, a floating joint too has neither axis nor range.
    const char* type = standard ? joint.Attribute("type") : joint_type_name(JointType::floating);
    if (type != nullptr) printer_.PushAttribute("type", type);
    add_origin(joint);
    add("parent", joint.FirstChildElement("parent"), {"link"});
    add("child", joint.FirstChildElement("child"), {"link"});
    const bool has_axis = info_of(read.type).has_axis;
    const auto* axis = joint.FirstChildElement("axis");
    if (has_axis && axis != nullptr) add("axis", axis, {"xyz"});
    // urdfdom insists on limits, which do not concern the dynamics.
    add("limit", nullptr, {"lower", "upper", "effort", "velocity"}, "0");
    if (read.mimic) {
      add("mimic", joint.FirstChildElement("mimic"), {"joint", "multiplier", "offset"});
    }
    printer_.CloseElement();
  }

  std::string finish() {
    printer_.CloseElement();
    return printer_.CStr();
  }

 private:
  void open(const char* name, const tinyxml2::XMLElement* from,
            std::initializer_list<const char*> attributes, const char* placeholder = nullptr) {
    printer_.OpenElement(name);
    for (const char* attribute : attributes) {
      const char* given = from == nullptr ? nullptr : from->Attribute(attribute);
      const char* value = given == nullptr ? placeholder : given;
      if (value != nullptr)
        printer_.PushAttribute(attribute, without_spaces(name, attribute, value).c_str());
    }
  }

  /// urdfdom knows one space between numbers and none around them; names are kept as they are.
  static std::string without_spaces(std::string_view element, std::string_view attribute,
                                    std::string_view value) {
    const bool is_name = attribute == "name" || attribute == "link" || attribute == "joint" ||
                         (element == "joint" && attribute == "type");
    if (is_name) return std::string(value);
    std::string numbers;
    for (const std::string_view word : split_words(value)) {
      if (!numbers.empty()) numbers += ' ';
      numbers += word;
    }
    return numbers;
  }

  void add(const char* name, const tinyxml2::XMLElement* from,
           std::initializer_list<const char*> attributes, const char* placeholder = nullptr) {
    open(name, from, attributes, placeholder);
    printer_.CloseElement();
  }

  void add_origin(const tinyxml2::XMLElement& parent) {
    if (const auto* origin = parent.FirstChildElement("origin"))
      add("origin", origin, {"xyz", "rpy"});
  }

  tinyxml2::XMLPrinter printer_{nullptr, true};
};

Eigen::Vector3d vector(const std::array<double, 3>& v) {
  return {v[0], v[1], v[2]};
}

bool same(const Pose& ours, const urdf::Pose& theirs) {
  const auto& p = theirs.position;
  if (ours.xyz != std::array{p.x, p.y, p.z}) return false;
  const auto& r = theirs.rotation;
  const Eigen::Vector3d v(r.x, r.y, r.z);
  Eigen::Matrix3d skew;
  skew << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  const Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity() + 2 * (r.w * skew + skew * skew);
  // Rounding of a few operations, and quarter turns, which are exact on our side up to 1e-14 of
  // the angle.
  const double tolerance = 1e-14 * (100 + 4 * vector(ours.rpy).cwiseAbs().sum());
  return (rotation - rotation_from_rpy<double>(ours.rpy)).cwiseAbs().maxCoeff() <= tolerance;
}

bool same(const Link& ours, const urdf::Link& theirs) {
  if (ours.inertial.has_value() != static_cast<bool>(theirs.inertial)) return false;
  if (!ours.inertial) return true;
  const Inertial& a = *ours.inertial;
  const urdf::Inertial& read = *theirs.inertial;
  Inertial b{
      counted_mass(read.mass), {}, read.ixx, read.ixy, read.ixz, read.iyy, read.iyz, read.izz};
  (void)drop_smallest_moments(b);
  return a.mass == b.mass && a.ixx == b.ixx && a.ixy == b.ixy && a.ixz == b.ixz && a.iyy == b.iyy &&
         a.iyz == b.iyz && a.izz == b.izz && same(a.origin, read.origin);
}

int type_of(JointType type) {
  switch (type) {
    case JointType::revolute:
      return urdf::Joint::REVOLUTE;
    case JointType::continuous:
      return urdf::Joint::CONTINUOUS;
    case JointType::prismatic:
      return urdf::Joint::PRISMATIC;
    case JointType::fixed:
      return urdf::Joint::FIXED;
    case JointType::floating:
      return urdf::Joint::FLOATING;
    case JointType::planar:
      return urdf::Joint::PLANAR;
    case JointType::ball:
      return urdf::Joint::FLOATING;  // as which it is handed over
  }
  return urdf::Joint::UNKNOWN;
}

bool same_axis(const Joint& ours, const urdf::Vector3& theirs) {
  if (!info_of(ours.type).has_axis) return true;
  const Eigen::Vector3d axis = Eigen::Vector3d(theirs.x, theirs.y, theirs.z).stableNormalized();
  return (axis - vector(ours.axis)).cwiseAbs().maxCoeff() <= 1e-14;
}

bool same_mimic(const NamedJoint& ours, const urdf::Joint& theirs) {
  if (ours.mimicked.has_value() != static_cast<bool>(theirs.mimic)) return false;
  if (!ours.mimicked) return true;
  return *ours.mimicked == theirs.mimic->joint_name &&
         ours.joint.mimic->multiplier == theirs.mimic->multiplier &&
         ours.joint.mimic->offset == theirs.mimic->offset;
}

bool same(const NamedJoint& ours, const urdf::Joint& theirs) {
  return type_of(ours.joint.type) == theirs.type && ours.parent == theirs.parent_link_name &&
         ours.child == theirs.child_link_name &&
         same(ours.joint.origin, theirs.parent_to_joint_origin_transform) &&
         same_axis(ours.joint, theirs.axis) && same_mimic(ours, theirs);
}

/// Difference between the two readers' results; empty when they agree.
std::string find_difference(const Robot& robot, const std::vector<NamedJoint>& joints,
                            const urdf::ModelInterface& model) {
  if (model.links_.size() != robot.links.size()) return "number of links";
  if (model.joints_.size() != robot.joints.size()) return "number of joints";
  const auto root = model.getRoot();
  if (!root || root->name != robot.links[static_cast<std::size_t>(robot.root)].name) return "root";
  for (const Link& link : robot.links) {
    const auto found = model.getLink(link.name);
    if (!found || !same(link, *found)) return "link " + link.name;
  }
  for (const NamedJoint& named : joints) {
    const auto found = model.getJoint(named.joint.name);
    if (!found || !same(named, *found)) return "joint " + named.joint.name;
  }
  return {};
}

}  // namespace

bool confirm_with_urdfdom(const Robot& robot, const std::vector<NamedJoint>& joints,
                          const std::vector<UrdfElement>& links, UrdfReading& reading) {
  EssentialUrdf urdf(robot);
  for (const UrdfElement& link : links) urdf.add_link(link.xml());
  for (const NamedJoint& joint : joints) urdf.add_joint(joint.element.xml(), joint.joint);
  // The log's handler is global to the process.
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  const CapturedLog log;
  const urdf::ModelInterfaceSharedPtr model = urdf::parseURDF(urdf.finish());
  std::string difference = log.text;
  if (difference.empty()) {
    difference = model ? find_difference(robot, joints, *model) : "it hands over nothing";
  }
  if (difference.empty()) return true;
  reading.report(Severity::error, 0, "robot",
                 fmt::format("urdfdom reads this file differently: {}", difference),
                 "this is a fault of one of the two readers: please report it with the file");
  return false;
}

}  // namespace treeline
