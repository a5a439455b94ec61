#include "description/check_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "description/check_motion.hpp"
#include "description/check_objects.hpp"
#include "description/count_freedoms.hpp"
#include "description/identifier.hpp"

namespace treeline {
namespace {

/// Names what keeps the mass matrix from an inverse whatever the pose; empty when nothing does.
std::string find_singular(const Robot& robot, const Scene& scene) {
  if (scene.base == Base::floating && !moves_inertia(robot)) return "the floating base";
  for (const int j : find_massless_joints(robot)) {
    const Joint& joint = robot.joints[static_cast<std::size_t>(j)];
    if (!scene.locked.contains(joint.name)) return fmt::format("joint \"{}\"", joint.name);
  }
  return {};
}

bool has_mass(const Robot& robot) {
  return std::any_of(robot.links.begin(), robot.links.end(),
                     [](const Link& link) { return link.inertial && link.inertial->mass > 0; });
}

void choose_functions(const SceneElement& top, const std::string& singular, Scene& scene) {
  for (const Function function : kAllFunctions) {
    const bool possible = !needs_points(function) || !scene.operational_points.empty();
    const bool defined = !inverts_mass_matrix(function) || singular.empty();
    if (possible && defined) scene.functions.push_back(function);
  }
  if (!scene.contacts.empty() && singular.empty()) {
    std::copy_if(kContactFunctions.begin(), kContactFunctions.end(),
                 std::back_inserter(scene.functions), needs_contacts);
    std::sort(scene.functions.begin(), scene.functions.end());
  }
  if (!scene.objects.empty() && singular.empty()) {
    scene.functions.insert(scene.functions.end(), kObjectFunctions.begin(), kObjectFunctions.end());
    std::sort(scene.functions.begin(), scene.functions.end());
  }
  if (singular.empty()) return;
  top.warn(fmt::format("nothing beyond {} has mass: the functions that invert the mass matrix are "
                       "left out",
                       singular),
           "give it mass in the URDF, or lock the joint");
}

void check_functions(const SceneElement& top, const Robot& robot, const std::string& singular,
                     const Scene& scene) {
  for (const Function function : scene.functions) {
    if (needs_points(function) && scene.operational_points.empty()) {
      top.error(
          fmt::format("{} is listed, but there is no operational point", function_name(function)),
          "add a list operational_points, or remove the function");
    } else if (needs_contacts(function) && scene.contacts.empty()) {
      top.error(fmt::format("{} is listed, but there is no contact", function_name(function)),
                "add a list contacts, or remove the function");
    } else if (needs_objects(function) && scene.objects.empty()) {
      top.error(fmt::format("{} is listed, but there is no object", function_name(function)),
                "add a list objects, or remove the function");
    } else if (is_about_posture(function) && !has_mass(robot)) {
      top.error(fmt::format("{} is listed, but no link has mass", function_name(function)),
                "give some link mass in the URDF, or remove the function");
    } else if (inverts_mass_matrix(function) && !singular.empty()) {
      top.error(
          fmt::format("{} is listed, but nothing beyond {} has mass: the mass matrix is singular",
                      function_name(function), singular),
          "give it mass in the URDF, lock the joint, or remove the function");
    }
  }
}

/// What `damped_control_torque` calls.
void check_damped(const SceneElement& top, const Scene& scene) {
  if (!scene.damped) return;
  if (has_priorities(scene.operational_points)) {
    top.error("damped knows no priorities, but the operational points differ in theirs",
              "remove damped: what conflicts yields by priority; or remove the priorities");
    return;
  }
  for (const Function function : kDampedFunctions) {
    if (std::count(scene.functions.begin(), scene.functions.end(), function) > 0) continue;
    top.error(
        fmt::format("damped needs {}, which is not among the functions", function_name(function)),
        needs_points(function) && scene.operational_points.empty()
            ? "add a list operational_points"
            : "add it to functions, or leave out functions for all");
    return;
  }
}

void check_forces_used(const SceneElement& top, const Scene& scene) {
  if (scene.external_forces.empty()) return;
  if (std::any_of(scene.functions.begin(), scene.functions.end(), takes_external_forces)) return;
  top.warn("external_forces are listed, but no function takes them",
           "add inverse_dynamics, forward_dynamics or control_torque to functions");
}

/// What a contact on a link at rest would weigh is not finite.
void check_contacts(const SceneElement& top, const Robot& robot, const Scene& scene) {
  for (const ScenePoint& contact : scene.contacts) {
    if (!find_freedoms_of_link(robot, scene, contact.link).empty()) continue;
    top.error(fmt::format("contact \"{}\" is on link \"{}\", which cannot move", contact.name,
                          contact.link),
              "put it on a link behind a joint that moves");
  }
  const bool used = std::any_of(scene.functions.begin(), scene.functions.end(), needs_contacts);
  if (!scene.contacts.empty() && !used) {
    top.warn("contacts are listed, but no function takes them",
             "add contact_inverse_inertia, effective_mass or impulse_response to functions");
  }
}

/// Lambda exists only if the rows can be moved independently of each other. Rows in strict priority
/// need not be.
void check_rows(const SceneElement& top, const Robot& robot, const Scene& scene) {
  const bool yield = has_priorities(scene.operational_points);
  const auto needs_lambda = [yield](Function f) {
    return f == Function::lambda || (f == Function::control_torque && !yield);
  };
  if (std::none_of(scene.functions.begin(), scene.functions.end(), needs_lambda)) return;
  const std::string remedy =
      "control fewer rows, or list under functions those that need no lambda";
  Freedoms all;
  long rows = 0;
  for (const ScenePoint& point : scene.operational_points) {
    const Freedoms own = find_freedoms_of_link(robot, scene, point.link);
    const long own_rows = std::count(point.rows.begin(), point.rows.end(), true);
    if (own_rows > count(own)) {
      top.error(fmt::format(
                    "point \"{}\" has {} rows, but its link \"{}\" moves with {} coordinates only",
                    point.name, own_rows, point.link, count(own)),
                remedy);
      return;
    }
    all.insert(own.begin(), own.end());
    rows += own_rows;
  }
  if (rows > count(all)) {
    top.error(
        fmt::format("the operational points have {} rows together, but {} coordinates move them",
                    rows, count(all)),
        remedy);
  }
}

void check_joint_identifiers(const SceneElement& top, const Robot& robot,
                             const Freedoms& freedoms) {
  std::map<std::string, std::string> names;
  for (const auto& [owner, number] : freedoms) {
    if (owner == kFloatingBase) continue;
    const std::string& name = robot.joints[static_cast<std::size_t>(owner)].name;
    const auto [first, is_new] = names.try_emplace(identifier_from(name), name);
    if (is_new) continue;
    top.error(fmt::format("the joints \"{}\" and \"{}\" of {} would both be {} in C++",
                          first->second, name, robot.file, first->first),
              "rename one of them in the URDF");
  }
}

}  // namespace

bool needs_points(Function function) {
  switch (function) {
    case Function::forward_kinematics:
    case Function::jacobian:
    case Function::bias_acceleration:
    case Function::lambda_inverse:
    case Function::lambda:
    case Function::control_torque:
      return true;
    default:
      return false;
  }
}

bool takes_external_forces(Function function) {
  return function == Function::inverse_dynamics || function == Function::forward_dynamics ||
         function == Function::control_torque || is_derivative(function);
}

bool inverts_mass_matrix(Function function) {
  switch (function) {
    case Function::contact_inverse_inertia:
    case Function::effective_mass:
    case Function::impulse_response:
    case Function::link_inverse_inertias:
    case Function::forward_dynamics:
    case Function::forward_dynamics_derivatives:
    case Function::lambda_inverse:
    case Function::lambda:
    case Function::control_torque:
    case Function::object_control_torque:
    case Function::object_forward_dynamics:
      return true;
    default:
      return false;
  }
}

void complete_scene(const SceneElement& top, const Robot& robot, Scene& scene) {
  const Freedoms freedoms = find_freedoms(robot, scene);
  if (freedoms.empty()) {
    top.error("nothing moves: the robot has no coordinates in this scene",
              "write base: floating, or unlock a joint");
    return;
  }
  const Link& root = robot.links[static_cast<std::size_t>(robot.root)];
  if (scene.base == Base::floating && root.name == "world") {
    top.warn("the base floats, but the root link is called \"world\"",
             "write base: fixed if that link is the ground");
  }
  const std::string singular = find_singular(robot, scene);
  if (scene.functions.empty()) {
    choose_functions(top, singular, scene);
  } else {
    check_functions(top, robot, singular, scene);
  }
  check_damped(top, scene);
  check_forces_used(top, scene);
  check_contacts(top, robot, scene);
  check_rows(top, robot, scene);
  check_objects(top, robot, scene);
  check_joint_identifiers(top, robot, freedoms);
}

}  // namespace treeline
