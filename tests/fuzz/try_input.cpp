#include "try_input.hpp"

#include <cmath>
#include <exception>
#include <optional>
#include <utility>

#include "description/read_number.hpp"
#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"
#include "description/scan_xml.hpp"
#include "generation/generate_code.hpp"
#include "mechanism/build_mechanism.hpp"
#include "mutate_text.hpp"
#include "recursion/routes/trace_function.hpp"

namespace treeline::fuzz {
namespace {

constexpr std::size_t kMostLinksReduced = 6, kMostLinksTraced = 4;

bool is_finite(const Pose& pose) {
  for (const double x : pose.xyz) {
    if (!std::isfinite(x)) return false;
  }
  for (const double x : pose.rpy) {
    if (!std::isfinite(x)) return false;
  }
  return true;
}

bool is_finite(const Inertial& i) {
  const double sum = i.ixx + i.ixy + i.ixz + i.iyy + i.iyz + i.izz;
  return std::isfinite(i.mass) && std::isfinite(sum) && is_finite(i.origin);
}

std::string find_fault(const Diagnostics& diagnostics) {
  for (const Diagnostic& diagnostic : diagnostics.list()) {
    if (diagnostic.fault.empty()) return "a diagnostic does not say what is wrong";
  }
  return {};
}

std::string find_fault(const Joint& joint, int links) {
  const bool inside = joint.parent >= 0 && joint.parent < links && joint.child >= 0 &&
                      joint.child < links && joint.parent != joint.child;
  if (!inside) return "joint " + joint.name + " does not connect two links";
  if (!is_finite(joint.origin)) return "joint " + joint.name + " is not at a finite place";
  double square = 0;
  for (const double x : joint.axis) square += x * x;
  return std::abs(square - 1) < 1e-12 ? "" : "the axis of " + joint.name + " has not length 1";
}

std::string find_fault(const Robot& robot) {
  const int links = static_cast<int>(robot.links.size());
  if (robot.joints.size() + 1 != robot.links.size()) return "the accepted robot is not a tree";
  if (robot.root < 0 || robot.root >= links) return "the accepted robot has no root";
  for (const Link& link : robot.links) {
    if (link.inertial && !is_finite(*link.inertial)) return "link " + link.name + " is not finite";
  }
  for (const Joint& joint : robot.joints) {
    if (auto fault = find_fault(joint, links); !fault.empty()) return fault;
  }
  return {};
}

/// Whether the places of inertias in the text are those that the XML reader found.
std::string find_fault(const Robot& robot, const std::string& text) {
  const auto tags = find_inertia_tags(text);
  // A world that the file names and does not have is a link of the robot, behind the file's own.
  const bool adds_world = robot.links.size() > tags.size() && robot.links.back().name == "world";
  if (tags.size() + (adds_world ? 1 : 0) != robot.links.size()) {
    return "other links are found in the text";
  }
  for (std::size_t i = 0; i < tags.size(); ++i) {
    if (!tags[i] || !robot.links[i].inertial) continue;
    for (const XmlAttribute& attribute : tags[i]->attributes) {
      if (attribute.name != "ixx" || attribute.value.find('&') != std::string_view::npos) continue;
      if (read_number(attribute.value) != robot.links[i].inertial->ixx) {
        return "another inertia of " + robot.links[i].name + " is found in the text";
      }
    }
  }
  return {};
}

bool is_finite(const Digits50& x) {
  return std::isfinite(static_cast<double>(x));
}

std::string find_fault(const MovingLink& link) {
  const Digits50Matrix3& R = link.placement.R;
  if ((R * R.transpose() - Digits50Matrix3::Identity()).cwiseAbs().maxCoeff() > Digits50(1e-20)) {
    return "the frame of " + link.name + " is not orthogonal";
  }
  bool finite = is_finite(link.inertia.mass) && is_finite(link.offset);
  for (int i = 0; i < 3; ++i) {
    finite = finite && is_finite(link.placement.p(i)) && is_finite(link.inertia.h(i));
    for (int j = 0; j < 3; ++j) finite = finite && is_finite(link.inertia.Sigma(i, j));
  }
  return finite ? "" : "a constant of " + link.name + " is not finite";
}

std::string find_fault(const Program& program) {
  for (const Node& node : program.graph.nodes()) {
    if (node.op == Op::constant && !std::isfinite(node.value)) {
      return "a constant of " + program.name + " is not finite";
    }
  }
  return {};
}

std::string find_fault(const Robot& robot, const Scene& scene) {
  if (robot.links.size() > kMostLinksReduced) return {};
  const Mechanism mechanism = reduced_mechanism(robot, scene);
  for (const MovingLink& link : mechanism.links) {
    if (auto fault = find_fault(link); !fault.empty()) return fault;
  }
  if (robot.links.size() > kMostLinksTraced || mechanism.nv() == 0) return {};
  for (const Program& program : trace_function(mechanism, Function::inverse_dynamics)) {
    if (auto fault = find_fault(program); !fault.empty()) return fault;
  }
  return {};
}

std::optional<Robot> read_urdf_text(const std::string& text, std::string& fault) {
  Diagnostics diagnostics;
  auto robot = parse_urdf(text, "fuzz.urdf", diagnostics);
  fault = find_fault(diagnostics);
  if (robot.has_value() == diagnostics.has_errors())
    fault = "neither a robot nor an error, or both";
  if (robot && fault.empty()) fault = find_fault(*robot);
  if (robot && fault.empty()) fault = find_fault(*robot, text);
  return robot;
}

std::optional<Scene> read_scene_text(const std::string& text, const Robot& robot,
                                     std::string& fault) {
  Diagnostics diagnostics;
  auto scene = parse_scene(text, "fuzz.yaml", robot, diagnostics);
  fault = find_fault(diagnostics);
  if (scene.has_value() == diagnostics.has_errors())
    fault = "neither a scene nor an error, or both";
  return scene;
}

const Robot& robot_of_all_joints() {
  static const Robot robot = [] {
    std::string text = "<robot name='r'><link name='a'/>";
    char parent = 'a';
    for (const std::string type :
         {"revolute", "prismatic", "continuous", "planar", "floating", "fixed", "revolute"}) {
      const std::string child(1, static_cast<char>(parent + 1));
      text += "<joint name='j" + child + "' type='" + type + "'><parent link='" +
              std::string(1, parent) + "'/><child link='" + child +
              "'/><origin xyz='1 2 3' rpy='0 1 0'/></joint><link name='" + child +
              "'><inertial><mass value='1'/><inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' "
              "izz='1'/></inertial></link>";
      ++parent;
    }
    Diagnostics ignored;
    return parse_urdf(text + "</robot>", "joints.urdf", ignored).value();
  }();
  return robot;
}

struct RobotAndScene {
  Robot robot;
  Scene scene;
};

/// Nothing if either is refused, or breaks a rule, which `fault` then states.
std::optional<RobotAndScene> read_both(const std::string& text, std::string& fault) {
  const std::size_t mark = text.find(kSceneMark);
  if (mark == std::string::npos) return std::nullopt;
  auto robot = read_urdf_text(text.substr(0, mark), fault);
  if (!robot || !fault.empty()) return std::nullopt;
  auto scene = read_scene_text(text.substr(mark + kSceneMark.size()), *robot, fault);
  if (!scene || !fault.empty()) return std::nullopt;
  return RobotAndScene{std::move(*robot), std::move(*scene)};
}

std::string find_fault(const Generation& generation, const Diagnostics& diagnostics) {
  if (diagnostics.has_errors()) return "code comes with an error";
  if (generation.files.empty()) return "neither a file nor an error";
  for (const GeneratedFile& file : generation.files) {
    if (file.name.empty() || file.text.empty()) return "file '" + file.name + "' is empty";
  }
  for (const GeneratedFunction& function : generation.functions) {
    if (auto fault = find_fault(function.program); !fault.empty()) return fault;
  }
  return find_fault(diagnostics);
}

std::string find_fault_of_refusal(const Diagnostics& diagnostics) {
  return diagnostics.has_errors() ? find_fault(diagnostics) : "no code, and no error";
}

/// Returns what `work` returns, or the message of what it throws.
template <class Work>
std::string guarded(const Work& work) {
  try {
    return work();
  } catch (const std::exception& exception) {
    return std::string("an exception escapes: ") + exception.what();
  } catch (...) {
    return "something that is no exception is thrown";
  }
}

}  // namespace

std::string try_urdf(const std::string& text) {
  return guarded([&] {
    std::string fault;
    const auto robot = read_urdf_text(text, fault);
    return robot && fault.empty() ? find_fault(*robot, Scene{}) : fault;
  });
}

std::string try_scene(const std::string& text) {
  return guarded([&] {
    std::string fault;
    (void)read_scene_text(text, robot_of_all_joints(), fault);
    return fault;
  });
}

std::string try_both(const std::string& text) {
  return guarded([&] {
    std::string fault;
    const auto both = read_both(text, fault);
    return both ? find_fault(both->robot, both->scene) : fault;
  });
}

std::string try_generate(const std::string& text) {
  return guarded([&] {
    std::string fault;
    const auto both = read_both(text, fault);
    if (!both || both->robot.links.size() > kMostLinksTraced) return fault;
    Diagnostics diagnostics;
    const auto generation = generate_code(both->robot, both->scene, {}, diagnostics);
    return generation ? find_fault(*generation, diagnostics) : find_fault_of_refusal(diagnostics);
  });
}

}  // namespace treeline::fuzz
