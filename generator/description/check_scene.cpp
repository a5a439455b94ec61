#include "description/check_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "description/read_keys.hpp"
#include "description/robot_queries.hpp"
#include "description/scene_inputs.hpp"
#include "description/scene_queries.hpp"
#include "description/urdf_parts.hpp"
#include "text/identifier.hpp"

namespace treeline {
namespace {

/// Names what has no mass beyond it, so that the mass matrix has no inverse in any pose; empty
/// where everything moves mass. What else makes it singular takes figures, see
/// `leave_out_singular`.
std::string find_singular(const Robot& robot, const Scene& scene) {
  if (scene.base == Base::floating && !moves_inertia(robot)) return "the floating base";
  std::vector<std::string> names;
  for (const int j : find_massless_joints(robot)) {
    const Joint& joint = robot.joints[static_cast<std::size_t>(j)];
    const bool moves_itself = scene.locked.contains(joint.name) ||
                              scene.armature.contains(joint.name) ||
                              scene.rotors.contains(joint.name);
    if (!moves_itself) names.push_back(fmt::format("\"{}\"", joint.name));
  }
  if (names.empty()) return {};
  return fmt::format("joint{} {}", names.size() > 1 ? "s" : "", fmt::join(names, ", "));
}

/// Whether a floating base, a floating joint or one that the scene calls passive has no motor.
bool lacks_motors(const Robot& robot, const Scene& scene) {
  return scene.base == Base::floating || !scene.passive.empty() ||
         std::any_of(robot.joints.begin(), robot.joints.end(),
                     [](const Joint& joint) { return joint.type == JointType::floating; });
}

/// All functions that the scene can have; where M is known to have no inverse, those without it.
void choose_functions(const Robot& robot, const std::string& singular, Scene& scene) {
  scene.functions = default_functions(robot, scene);
  add_functions_of_limits(robot, scene);
  if (!singular.empty()) std::erase_if(scene.functions, inverts_mass_matrix);
}

/// Whether the function depends on inertia, but not on base parameters alone.
bool exceeds_base_parameters(const Scene& scene, Function function) {
  return depends_on_inertia(scene, function) &&
         !takes_input(scene, function, Quantity::base_parameters);
}

/// Reports a function that the scene's constraints do not permit.
void report_constraints(const SceneElement& list, const Scene& scene, Function function) {
  const char* missing = "nothing is held";
  const char* remedy = "add a list constraints or couplings, or remove the function";
  if (scene.holds_rows()) {
    missing = "nothing is held between two links, and no joints are coupled";
    remedy = "errors of constraints to the world are those of their points; remove the function";
  } else if (function == Function::supported_control_torque) {
    missing = why_unsupported(scene);
    remedy =
        "add constraints or couplings; or operational_points, and passive joints where nothing "
        "floats";
  }
  list.error(fmt::format("{} is listed, but {}", function_name(function), missing), remedy);
}

void check_functions(const SceneElement& list, const Robot& robot, const std::string& singular,
                     const Scene& scene) {
  for (const Function function : scene.functions) {
    if (info_of(function).group == FunctionGroup::points && scene.operational_points.empty()) {
      list.error(
          fmt::format("{} is listed, but there is no operational point", function_name(function)),
          "add a list operational_points, or remove the function");
    } else if (needs_contacts(function) && scene.contacts.empty()) {
      list.error(fmt::format("{} is listed, but there is no contact", function_name(function)),
                 "add a list contacts, or remove the function");
    } else if (needs_objects(function) && scene.objects.empty()) {
      list.error(fmt::format("{} is listed, but there is no object", function_name(function)),
                 "add a list objects, or remove the function");
    } else if (needs_constraints(function) && !permits(robot, scene, function)) {
      report_constraints(list, scene, function);
    } else if (needs_mass(function) && !(total_mass(robot) > 0)) {
      list.error(fmt::format("{} is listed, but no link has mass", function_name(function)),
                 "give some link mass in the robot's file, or remove the function");
    } else if (scene.inputs.base_parameters && exceeds_base_parameters(scene, function)) {
      list.error(
          fmt::format("{} is listed, but it depends on masses that base parameters do not contain",
                      function_name(function)),
          "remove the function, or make parameters of links an input");
    } else if (!scene.rotors.empty() && (function == Function::subtree_masses_and_centers ||
                                         function == Function::link_inverse_inertias)) {
      list.error(
          fmt::format("{} is listed, but rotors with gyroscopic moments are links without mass",
                      function_name(function)),
          "remove the function, or gyroscopic: true");
    } else if (inverts_mass_matrix(function) && !singular.empty()) {
      list.error(
          fmt::format("{} is listed, but nothing beyond {} has mass: the mass matrix is singular",
                      function_name(function), singular),
          "give it mass in the robot's file, lock the joint, or remove the function");
    }
  }
}

void check_implicit_friction(const SceneElement& list, const Scene& scene) {
  const auto& functions = scene.functions;
  if (!scene.implicit_friction ||
      std::any_of(functions.begin(), functions.end(),
                  [](Function each) { return takes(each, Quantity::step); })) {
    return;
  }
  list.error("friction is implicit, but no function takes a step",
             "add forward_dynamics or constrained_forward_dynamics");
}

/// Checks the scene of `damped_control_torque` and the functions that it calls.
void check_damped(const SceneElement& top, const SceneElement& list, const Robot& robot,
                  const std::string& singular, const Scene& scene) {
  if (!scene.damped) return;
  if (has_priorities(scene.operational_points)) {
    top.error("damped knows no priorities, but the operational points differ in theirs",
              "remove damped: what conflicts yields by priority; or remove the priorities");
    return;
  }
  if (!scene.inputs.active_tasks.empty()) {
    top.error("damped does every task all the time, but inputs lists some under active",
              "remove damped; or remove them, and make a scene for each set of tasks");
    return;
  }
  for (const Function function : kDampedFunctions) {
    if (std::count(scene.functions.begin(), scene.functions.end(), function) > 0) continue;
    if (inverts_mass_matrix(function) && !singular.empty()) {
      top.error(fmt::format("nothing beyond {} has mass: the mass matrix is singular, and damped "
                            "needs its inverse",
                            singular),
                "give it mass in the robot's file, lock the joint, or remove damped");
      return;
    }
    list.error(
        fmt::format("damped needs {}, which is not among the functions", function_name(function)),
        !permits(robot, scene, function) ? "add a list operational_points"
                                         : "add it to functions, or leave out functions for all");
    return;
  }
}

void check_forces_used(const SceneElement& top, const Scene& scene) {
  if (scene.external_forces.empty()) return;
  if (std::any_of(scene.functions.begin(), scene.functions.end(), takes_external_forces)) return;
  if (scene.controller) return;  // whose torques take them
  top.warn("external_forces are listed, but no function takes them",
           "add inverse_dynamics, forward_dynamics or control_torque to functions");
}

/// Checks that contacts move: at a link that is at rest, their effective mass is infinite.
void check_contacts(const SceneElement& top, const Robot& robot, const Scene& scene) {
  for (const ScenePoint& contact : scene.contacts) {
    if (!find_freedoms_of_link(robot, scene, contact.link).empty()) continue;
    top.error(fmt::format("contact \"{}\" is on link \"{}\", which cannot move", contact.name,
                          contact.link),
              "put it on a link behind a joint that moves");
  }
}

void check_contacts_used(const SceneElement& top, const Scene& scene) {
  const bool used = std::any_of(scene.functions.begin(), scene.functions.end(), needs_contacts);
  if (scene.contacts.empty() || used) return;
  top.warn("contacts are listed, but no function takes them",
           "add contact_inverse_inertia, effective_mass or impulse_response to functions");
}

/// A frame that cannot move needs no force to be held.
void check_constraints(const SceneElement& top, const Robot& robot, const Scene& scene) {
  for (const ScenePoint& held : scene.constraints) {
    if (!find_freedoms_of_link(robot, scene, held.link).empty()) continue;
    top.error(
        fmt::format("constraint \"{}\" holds link \"{}\", which cannot move", held.name, held.link),
        "hold a link behind a joint that moves, or write base: floating");
  }
  for (const SceneLoop& loop : scene.loops) {
    const bool moves = loop.second.link == kWorldEnd
                           ? !find_freedoms_of_link(robot, scene, loop.first.link).empty()
                           : moves_against(robot, scene, loop.first.link, loop.second.link);
    if (moves) continue;
    top.error(fmt::format("constraint \"{}\" is between links \"{}\" and \"{}\", which no joint "
                          "moves against each other",
                          loop.first.name, loop.first.link, loop.second.link),
              "name two links with joints that move between them");
  }
}

void check_constraints_used(const SceneElement& top, const Scene& scene) {
  const bool listed = scene.holds_rows() || !scene.passive.empty();
  const bool used = std::any_of(scene.functions.begin(), scene.functions.end(), needs_constraints);
  if (!listed || used) return;
  const bool has_function = scene.holds_rows() || !scene.operational_points.empty();
  top.warn(
      "constraints or passive joints are listed, but no function takes them",
      has_function
          ? "add constrained_forward_dynamics or supported_control_torque to functions"
          : "add operational_points: supported_control_torque moves them without these joints");
}

/// More rows than coordinates that move them: an error where a bare solve is asked for, else said.
void complain_of_rows(const SceneElement& top, const Scene& scene, const std::string& what) {
  if (scene.singular == SingularTasks::exact) {
    top.error(what,
              "control fewer rows, or list under functions those that need no lambda, or leave out "
              "singular: exact, so that rows yield");
  } else {
    top.warn(
        what,
        "rows that those before them leave nothing to move yield; control fewer rows to choose "
        "them");
  }
}

/// Lambda exists only if the rows can be moved independently of each other. Rows in strict priority
/// need not be.
void check_rows(const SceneElement& top, const Robot& robot, const Scene& scene) {
  const bool prioritized = has_priorities(scene.operational_points);
  const auto needs_lambda = [prioritized](Function f) {
    return has_lambda(f) && !(f == Function::control_torque && prioritized);
  };
  if (std::none_of(scene.functions.begin(), scene.functions.end(), needs_lambda)) return;
  Freedoms all;
  long rows = 0;
  std::string names;
  bool complained = false;
  for (const ScenePoint& point : scene.operational_points) {
    const Freedoms own = find_freedoms_of(robot, scene, point);
    const long own_rows = std::count(point.rows.begin(), point.rows.end(), true);
    if (own_rows > count(own)) {
      complain_of_rows(
          top, scene,
          fmt::format(
              "point \"{}\" has {} rows, but {} moves with {} coordinates only: "
              "{}",
              point.name, own_rows,
              point.center_of_mass ? kCenterOfMass : fmt::format("its link \"{}\"", point.link),
              count(own), list_rows(point)));
      complained = true;
    }
    all.insert(own.begin(), own.end());
    rows += own_rows;
    names += fmt::format("{}{}: {}", names.empty() ? "" : ", ", point.name, list_rows(point));
  }
  if (rows > count(all) && !complained) {
    complain_of_rows(top, scene,
                     fmt::format("the operational points have {} rows together, but {} coordinates "
                                 "move them: {}",
                                 rows, count(all), names));
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
    top.error(fmt::format("the joints \"{}\" and \"{}\" of {} would both be {} in emitted code",
                          first->second, name, robot.file, first->first),
              "rename one of them there");
  }
}

}  // namespace

bool permits(const Robot& robot, const Scene& scene, Function function) {
  switch (info_of(function).group) {
    case FunctionGroup::points:
      return !scene.operational_points.empty();
    case FunctionGroup::objects:
      return !scene.objects.empty();
    case FunctionGroup::contacts:
      return !scene.contacts.empty();
    case FunctionGroup::constraints:
      if (function == Function::constraint_errors) {
        return !scene.loops.empty() || !scene.couplings.empty();
      }
      return scene.holds_rows() ||
             (function == Function::supported_control_torque && !scene.operational_points.empty() &&
              lacks_motors(robot, scene));
    case FunctionGroup::robot:
    case FunctionGroup::links:
    case FunctionGroup::center_of_mass:
    case FunctionGroup::derivatives:
      break;
  }
  return true;
}

std::vector<Function> default_functions(const Robot& robot, const Scene& scene) {
  const bool supports = scene.holds_rows() || !scene.passive.empty();
  std::vector<Function> functions;
  for (const FunctionInfo& row : kFunctions) {
    const bool wanted = supports || row.function != Function::supported_control_torque;
    if (row.emitted == Emitted::by_default && wanted && permits(robot, scene, row.function)) {
      functions.push_back(row.function);
    }
  }
  return functions;
}

void complete_scene(const SceneElement& top, const SceneElement& list, const Robot& robot,
                    bool listed, Scene& scene) {
  const Freedoms freedoms = find_freedoms(robot, scene);
  if (freedoms.empty()) {
    const bool jointed =
        std::any_of(robot.joints.begin(), robot.joints.end(),
                    [](const Joint& joint) { return info_of(joint.type).moves(); });
    top.error("nothing moves: the robot has no coordinates in this scene",
              jointed ? "unlock a joint, or write base: floating"
              : moves_inertia(robot)
                  ? "write base: floating: no joint moves"
                  : "give its links mass, so that the base can float: no joint moves");
    return;
  }
  const Link& root = robot.links[static_cast<std::size_t>(robot.root)];
  if (scene.base == Base::floating && root.name == "world") {
    top.warn("the base floats, but the root link is called \"world\"",
             "write base: fixed if that link is the ground");
  }
  if (!check_center_of_mass(top, robot, scene)) return;
  const std::string singular = find_singular(robot, scene);
  if (!listed) {
    choose_functions(robot, singular, scene);
  } else {
    check_functions(list, robot, singular, scene);
  }
  check_damped(top, list, robot, singular, scene);
  check_limits(top, robot, scene);
  check_controller(top, robot, singular, scene);
  check_inputs_used(top, scene);
  check_implicit_friction(list, scene);
  check_regressor_used(top, scene);
  check_contacts(top, robot, scene);
  check_constraints(top, robot, scene);
  check_rows(top, robot, scene);
  check_objects(top, robot, scene);
  check_joint_identifiers(top, robot, freedoms);
}

void warn_of_unused(const SceneElement& top, const Scene& scene) {
  check_forces_used(top, scene);
  check_contacts_used(top, scene);
  check_constraints_used(top, scene);
}

}  // namespace treeline
