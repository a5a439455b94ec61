#include "generation/describe_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "description/robot_queries.hpp"
#include "description/scene_queries.hpp"
#include "generation/append_notes.hpp"
#include "mechanism/digits50_from_file.hpp"
#include "mechanism/home_of.hpp"
#include "recursion/tree/virtual_linkage.hpp"

namespace treeline {
namespace {

std::string range_text(const Limits& limits, const char* unit) {
  const Limit& lower = limits.lower;
  const Limit& upper = limits.upper;
  const bool misses =
      lower.state() == LimitState::implausible || upper.state() == LimitState::implausible;
  const std::string file =
      misses ? fmt::format(" ({:g} .. {:g} in the file)", lower.written(), upper.written()) : "";
  if (lower.is_stated() && upper.is_stated()) {
    return fmt::format("{} .. {} {}", lower.value(), upper.value(), unit);
  }
  if (lower.is_stated()) return fmt::format("at least {} {}{}", lower.value(), unit, file);
  if (upper.is_stated()) return fmt::format("at most {} {}{}", upper.value(), unit, file);
  return misses ? "no range" + file : "";
}

std::string limit_text(const Limit& limit, const char* unit, const char* none) {
  if (limit.is_stated()) return fmt::format("{} {}", limit.value(), unit);
  return limit.state() == LimitState::absent
             ? ""
             : fmt::format("no limit of {} ({:g} in the file)", none, limit.written());
}

std::string limits_text(const Joint& joint) {
  if (!joint.limits) return {};
  const bool angle = !info_of(joint.type).slides();
  std::string text;
  for (const std::string& part :
       {range_text(*joint.limits, angle ? "rad" : "m"),
        limit_text(joint.limits->effort, angle ? "N m" : "N", "effort"),
        limit_text(joint.limits->velocity, angle ? "rad/s" : "m/s", "speed")}) {
    if (!part.empty()) text += (text.empty() ? "" : ", ") + part;
  }
  return text;
}

/// One row for each joint that owns coordinates, in the order of q.
std::vector<EmissionContext::JointRow> joint_rows(const Robot& robot, const Mechanism& mechanism) {
  std::vector<EmissionContext::JointRow> rows;
  for (const MovingLink& link : mechanism.links) {
    if (link.mimics) {
      continue;
    }
    if (!rows.empty() && rows.back().name == link.joint) {  // the next axis of the same joint
      rows.back().coordinates += link.coordinates();
      rows.back().velocities += link.velocities();
      continue;
    }
    const Joint* joint = find_joint(robot, link.joint);
    rows.push_back({link.joint, joint != nullptr ? joint_type_name(joint->type) : "floating base",
                    link.q_index, link.coordinates(), link.v_index, link.velocities(),
                    joint != nullptr ? limits_text(*joint) : std::string()});
  }
  return rows;
}

std::vector<std::string> joint_conventions(const Robot& robot, const Mechanism& mechanism) {
  std::set<JointType> types;
  for (const MovingLink& link : mechanism.links) {
    if (link.spins) continue;  // not in the file
    const Joint* joint = find_joint(robot, link.joint);
    types.insert(joint != nullptr ? joint->type : JointType::floating);
  }
  std::vector<std::string> conventions;
  for (const JointType type : types) {
    const std::string convention = info_of(type).convention;
    if (!convention.empty()) conventions.push_back(convention);
  }
  return conventions;
}

std::vector<EmissionContext::CoordinateRow> coordinate_rows(const Mechanism& mechanism) {
  std::vector<EmissionContext::CoordinateRow> rows;
  for (const Coordinate& coordinate : mechanism.coordinates) {
    rows.push_back({coordinate.joint, coordinate.meaning, coordinate.lower, coordinate.upper,
                    home_of(coordinate)});
  }
  return rows;
}

std::string origin_text(const Pose& origin) {
  const auto& xyz = origin.xyz;
  const auto& rpy = origin.rpy;
  std::string text = fmt::format("origin ({}, {}, {}) m", xyz[0], xyz[1], xyz[2]);
  if (rpy != std::array<double, 3>{}) {
    text += fmt::format(", rpy ({}, {}, {}) rad", rpy[0], rpy[1], rpy[2]);
  }
  return text;
}

std::string frame_text(const ScenePoint& point) {
  if (point.center_of_mass) return "world axes";
  return origin_text(point.origin) +
         (point.axes == Axes::world ? " in the link, world axes" : " in the link, own axes");
}

std::vector<EmissionContext::PointRow> point_rows(const std::vector<ScenePoint>& points) {
  std::vector<EmissionContext::PointRow> rows;
  int first_row = 0;
  const bool prioritized = has_priorities(points);
  for (const ScenePoint& point : points) {
    const std::string priority =
        prioritized ? fmt::format(", priority {}", point.priority) : std::string();
    rows.push_back({point.name, point.center_of_mass ? "all links, the centre of mass" : point.link,
                    frame_text(point) + priority, list_rows(point), first_row});
    for (const bool on : point.rows) {
      first_row += on ? 1 : 0;
    }
  }
  return rows;
}

/// Notes which entries of contact functions belong to which point, and which block to which link.
void append_contact_notes(const Scene& scene, const Mechanism& mechanism,
                          std::vector<std::string>& notes) {
  for (std::size_t i = 0; i < scene.contacts.size(); ++i) {
    const ScenePoint& contact = scene.contacts[i];
    notes.push_back(fmt::format("contact {}: {} on link {}, {}", i, contact.name, contact.link,
                                frame_text(contact)));
  }
  const bool asked = std::find(scene.functions.begin(), scene.functions.end(),
                               Function::link_inverse_inertias) != scene.functions.end();
  for (std::size_t i = 0; asked && i < mechanism.link_frames.size(); ++i) {
    notes.push_back(fmt::format("block {} of link_inverse_inertias: link {}", i,
                                mechanism.link_frames[i].name));
  }
}

/// Note on a rolling contact: the body that rolls, and the surface on which it rolls.
std::string rolling_note(const SceneLoop& loop) {
  const SceneRolling& rolling = *loop.rolling;
  const std::string wheel =
      rolling.axis ? fmt::format("a disc of {} m about [{:g}, {:g}, {:g}]", rolling.radius,
                                 (*rolling.axis)[0], (*rolling.axis)[1], (*rolling.axis)[2])
                   : fmt::format("a ball of {} m", rolling.radius);
  const std::string ground = !rolling.on_radius ? std::string("the plane z = 0")
                             : *rolling.on_radius > 0
                                 ? fmt::format("a ball of {} m", *rolling.on_radius)
                                 : fmt::format("a bowl of {} m", -*rolling.on_radius);
  return fmt::format("constraint {}: {} rolls on {} of the other link; rows of the touching points",
                     loop.first.name, wheel, ground);
}

/// Notes which rows hold parts of the robot to each other, after `row` others.
void append_loop_notes(const Scene& scene, std::size_t row, std::vector<std::string>& notes) {
  for (const SceneLoop& loop : scene.loops) {
    if (loop.rolling) notes.push_back(rolling_note(loop));
    notes.push_back(fmt::format(
        "constraint {}: {} of link {}, {}, held to link {}, {}, along the latter's axes; rows from "
        "{}",
        loop.first.name, list_rows(loop.second, " "), loop.first.link,
        origin_text(loop.first.origin), loop.second.link, origin_text(loop.second.origin), row));
    const auto& on = loop.second.rows;
    row += static_cast<std::size_t>(std::count(on.begin(), on.end(), true));
  }
  for (const SceneCoupling& coupling : scene.couplings) {
    std::string sum;
    for (const auto& [joint, factor] : coupling.parts) {
      sum += fmt::format("{}{} {}", sum.empty() ? "" : " + ", factor, joint);
    }
    notes.push_back(fmt::format("coupling {}: {} + {} = 0; row {}", coupling.name, sum,
                                coupling.offset, row++));
  }
}

/// Notes what rates of velocities along a point's own axes are.
void append_axes_note(const Scene& scene, std::vector<std::string>& notes) {
  const auto turns = [](const ScenePoint& point) {
    return point.axes == Axes::local && (point.rows[0] || point.rows[1] || point.rows[2]);
  };
  if (std::any_of(scene.operational_points.begin(), scene.operational_points.end(), turns) ||
      std::any_of(scene.constraints.begin(), scene.constraints.end(), turns)) {
    notes.push_back(
        "own axes turn with the link: rates of velocities along them are R^T (dv/dt - w x v)");
  }
}

/// Notes which rows are held, and which entries of tau are zero.
void append_constraint_notes(const Scene& scene, const Mechanism& mechanism,
                             std::vector<std::string>& notes) {
  const auto rows = point_rows(scene.constraints);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    notes.push_back(
        fmt::format("constraint {}: {} holds {} of link {} to the world, {}; rows from {}", i,
                    rows[i].name, list_rows(scene.constraints[i], " "), rows[i].link,
                    frame_text(scene.constraints[i]), rows[i].first_row));
  }
  append_loop_notes(scene, static_cast<std::size_t>(mechanism.anchored_rows()), notes);
  const bool asked = std::any_of(scene.functions.begin(), scene.functions.end(), [](Function f) {
    return f == Function::supported_control_torque;
  });
  if (!asked) return;
  std::string passive;
  for (const int v : mechanism.passive) {
    passive += fmt::format("{}{}", passive.empty() ? "" : " ", v);
  }
  notes.push_back(
      fmt::format("passive, without a motor: qd[i] of i = {}", passive.empty() ? "none" : passive));
}

/// Notes on the steps that have headers of their own.
void append_step_notes(const Scene& scene, std::vector<std::string>& notes) {
  if (scene.controller) {
    notes.push_back(fmt::format(
        "a controller is in {0}_controller.h: {0}_step(config, state, input, output)", scene.name));
  }
  if (scene.ground_step) {
    notes.push_back(fmt::format(
        "a step on the ground is in {0}_ground.h: {0}_ground_step(ground, dt, tau, q, qd, memory, "
        "report)",
        scene.name));
  }
}

/// Note on tasks that conflict.
constexpr const char* kPriorityNote =
    "control_torque keeps strict priority: each row acts in the dynamically consistent null space "
    "of the rows above it, by priority and then by row. With c its inverse inertia there and s "
    "that of its point, summed over the rows of its kind (x y z or rx ry rz), it is achieved to "
    "the last digits where c > s/80, whatever lower rows ask for. A row in conflict with rows "
    "above it has a smaller c and gives up, alone, the share 1/(1 + t^8), t = 2^13 c/s; the torque "
    "remains finite. Each point must be able to move in some row of each kind that it lists.";

/// `tensions of the rods 1-2, 2-3, 3-1, 3-4, 1-4, warp of 4 between the points`, in the order of
/// `internal`.
std::string linkage_text(const SceneObject& object) {
  std::vector<Digits50Vector3> points;
  for (const SceneGrasp& grasp : object.grasps) {
    points.push_back(inverse(digits50_pose(grasp.origin)).p);
  }
  std::string text;
  bool warps = false;
  for (const LinkageForce& force : list_linkage_forces(points)) {
    const bool is_rod = force.kind == LinkageForce::Kind::tension;
    text += text.empty() ? "tensions of the rods " : ", ";
    text += is_rod ? fmt::format("{}-{}", force.from + 1, force.to + 1)
                   : fmt::format("warp of {}", force.to + 1);
    warps = warps || !is_rod;
  }
  text += " between the points";
  if (warps) {
    text +=
        " (warp: force at a point along the normal (r_2 - r_1) x (r_3 - r_1) of the first three, "
        "which balance it by forces along that normal)";
  }
  return text;
}

/// Text that the reader needs to fill in `xdd_object` and `internal`.
std::string object_text(const SceneObject& object) {
  std::string text = fmt::format("object {}, {} kg, held at", object.name, object.inertial.mass);
  for (const SceneGrasp& grasp : object.grasps) {
    const auto& xyz = grasp.origin.xyz;
    text += fmt::format("{} {} (object's origin at ({}, {}, {}) m in the point's frame)",
                        &grasp == &object.grasps.front() ? "" : ",", grasp.point, xyz[0], xyz[1],
                        xyz[2]);
  }
  if (object.grasps.size() == 2) {
    text +=
        "; internal: tension, torsion (m_2 - m_1).x / 2, then m_1.y m_1.z m_2.y m_2.z of the "
        "moments at the points; x from the first point to the second, y = up x x with up the "
        "object's z axis (x axis if |x_z| > 0.9), z = x x y; tension stretches, a squeeze is "
        "negative";
  } else if (object.grasps.size() > 2) {
    text += fmt::format(
        "; internal: {}; then the moments at all points, object's axes; tension stretches, a "
        "squeeze is negative",
        linkage_text(object));
  }
  return text;
}

}  // namespace

std::vector<EmissionContext::VelocityRow> velocity_rows(const Robot& robot,
                                                        const Mechanism& mechanism) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  std::vector<EmissionContext::VelocityRow> rows;
  for (const std::string& name : mechanism.velocities) rows.push_back({"", name, kNone, kNone});
  for (const MovingLink& link : mechanism.links) {
    if (link.mimics) continue;
    for (int i = 0; i < link.velocities(); ++i) {
      rows[static_cast<std::size_t>(link.v_index + i)].joint = link.joint;
    }
    const Joint* joint = find_joint(robot, link.joint);
    if (joint == nullptr || !joint->limits) continue;
    EmissionContext::VelocityRow& row = rows[static_cast<std::size_t>(link.v_index)];
    row.velocity = joint->limits->velocity;
    row.effort = joint->limits->effort;
  }
  return rows;
}

EmissionContext describe_scene(const Robot& robot, const Scene& scene, const Mechanism& mechanism) {
  EmissionContext context;
  context.name = scene.name;
  context.robot = robot.name;
  context.language = scene.language;
  context.single_precision = scene.real == Real::float32;
  context.misra = scene.profile == Profile::misra;
  context.target = scene.target;
  context.optimize = scene.optimize;
  context.lanes = scene.lanes;
  context.asks_for_lanes = scene.asks_for_lanes;
  context.batch = scene.batch;
  context.effective_mass_limits = effective_mass_limits(scene);
  context.coordinates = mechanism.nq();
  context.velocities = mechanism.nv();
  context.task_rows = mechanism.task_rows();
  context.base = scene.base == Base::fixed ? "fixed" : "floating";
  context.gravity = scene.gravity;
  context.gravity_given = scene.inputs.gravity;
  context.joints = joint_rows(robot, mechanism);
  context.joint_conventions = joint_conventions(robot, mechanism);
  context.coordinate_rows = coordinate_rows(mechanism);
  context.velocity_rows = velocity_rows(robot, mechanism);
  context.operational_points = point_rows(scene.operational_points);
  context.external_forces = point_rows(scene.external_forces);
  append_axes_note(scene, context.notes);
  append_input_notes(scene, mechanism, context.notes);
  append_regressor_notes(scene, mechanism, context.notes);
  for (const SceneObject& object : scene.objects) {
    context.notes.push_back(object_text(object));
  }
  for (const auto& [joint, value] : scene.locked) {
    context.notes.push_back(fmt::format("joint {} is locked at {}", joint, value));
  }
  append_step_notes(scene, context.notes);
  append_drive_notes(robot, scene, context.notes);
  for (const Joint& joint : robot.joints) {
    if (joint.mimic) {
      context.notes.push_back(
          fmt::format("joint {} follows {}: {} q + {}", joint.name,
                      robot.joints[static_cast<std::size_t>(joint.mimic->joint)].name,
                      joint.mimic->multiplier, joint.mimic->offset));
    }
  }
  append_contact_notes(scene, mechanism, context.notes);
  append_constraint_notes(scene, mechanism, context.notes);
  const bool controlled = std::find(scene.functions.begin(), scene.functions.end(),
                                    Function::control_torque) != scene.functions.end();
  if (controlled && has_priorities(scene.operational_points)) {
    context.notes.emplace_back(kPriorityNote);
  }
  return context;
}

}  // namespace treeline
