#pragma once

#include <array>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string_view>

namespace treeline {

/// Arguments that functions take. The row of an argument in `kQuantities` holds its properties.
enum class Quantity {
  q,
  sin_q,
  cos_q,
  qd,
  qdd,
  qdd_0,
  tau,
  xdd_cmd,
  f_ext,
  impulse,
  internal,
  normals,
  stabilisation,
  xdd_object,
  drift,
  f_wanted,
  step,
  gravity,
  payload,
  parameters,
  base_parameters,
  tool,
  tool_orientation,
  contact,
  active,
  active_tasks,
};

/// Index space of an argument: the kind of thing to which its entries belong.
enum class IndexSpace {
  positions,        ///< nq coordinates
  velocities,       ///< nv velocities
  task_rows,        ///< the controlled rows of all operational points
  external_forces,  ///< 6 an external force, force over moment
  contacts,         ///< 3 a contact
  objects,          ///< 6 an object, linear over angular
  linkages,         ///< 6 a grasp but for the first of each object
  grasp_gains,      ///< 2: damping, stiffness
  held_rows,        ///< the rows that constraints hold
  anchored_rows,    ///< rows that constraints hold relative to the world
  step,             ///< 1, if the scene makes friction implicit
  gravity,          ///< 3, if the scene makes gravity an input
  payloads,         ///< 10 a payload that the scene makes an input
  parameters,       ///< 10 a link whose inertial parameters the scene makes an input
  base_parameters,  ///< the base parameters, if the scene makes them an input
  tools,            ///< 3 an operational point whose origin the scene makes an input
  orientations,     ///< 4 an operational point whose orientation the scene makes an input
  contact_places,   ///< 3 a contact whose origin the scene makes an input
  active_groups,    ///< 1 a constraint that comes and goes
  active_tasks,     ///< 1 an operational point whose task comes and goes
};

/// All that is known of a quantity. Units are those of rotation and translation where joints or
/// rows have either.
struct QuantityInfo {
  Quantity quantity;
  const char* symbol;   ///< name of the argument
  const char* meaning;  ///< as contracts tell it
  const char* unit;
  IndexSpace space;
  double range;  ///< largest magnitude that rounding bounds allow where the URDF states none
};

/// Ranges of q that rounding bounds allow where the URDF states no limits.
inline constexpr double kAngleRange = std::numbers::pi;  ///< rad
inline constexpr double kPositionRange = 10;             ///< m

/// Largest qd that rounding bounds allow, whatever limit the URDF states: rad/s, a motor of 955 rpm
/// without a gear, or m/s. Bounds grow with its square: at the 1000 rad/s that exporters write,
/// they would be a hundred times too wide for the speeds that joints reach.
inline constexpr double kFastestInBounds = 100;

/// Ranges that rounding bounds allow for bodies whose inertial parameters are inputs, where the
/// scene states none.
inline constexpr double kPayloadMass = 10;    ///< kg
inline constexpr double kPayloadReach = 0.5;  ///< m, farthest matter from the link's origin

/// Number of inertial parameters of a rigid body.
inline constexpr int kInertialParameters = 10;

/// Every quantity, in the order of the enumeration.
inline constexpr auto kQuantities = std::to_array<QuantityInfo>({
    {Quantity::q, "q", "joint coordinates", "rad, m", IndexSpace::positions, kPositionRange},
    {Quantity::sin_q, "sin_q", "sines of q; read for angles only", "1", IndexSpace::positions, 1},
    {Quantity::cos_q, "cos_q", "cosines of q; read for angles only", "1", IndexSpace::positions, 1},
    {Quantity::qd, "qd", "joint velocities", "rad/s, m/s", IndexSpace::velocities, 10},
    {Quantity::qdd, "qdd", "joint accelerations", "rad/s^2, m/s^2", IndexSpace::velocities, 100},
    {Quantity::qdd_0, "qdd_0", "joint accelerations that the posture asks for", "rad/s^2, m/s^2",
     IndexSpace::velocities, 100},
    {Quantity::tau, "tau", "joint forces", "N m, N", IndexSpace::velocities, 1000},
    {Quantity::xdd_cmd, "xdd_cmd", "commanded accelerations of the task rows", "m/s^2, rad/s^2",
     IndexSpace::task_rows, 100},
    {Quantity::f_ext, "f_ext", "force and moment on the robot at each external force's point",
     "N, N m", IndexSpace::external_forces, 1000},
    {Quantity::impulse, "impulse",
     "impulses on the robot, N s, world axes, one contact after the other", "N s",
     IndexSpace::contacts, 100},
    {Quantity::internal, "internal", "commanded internal forces of the virtual linkages", "N, N m",
     IndexSpace::linkages, 1000},
    {Quantity::normals, "normals", "directions, world axes, one contact after the other", "1",
     IndexSpace::contacts, 1},
    {Quantity::stabilisation, "stabilisation",
     "damping, 1/s, and stiffness, 1/s^2, of the drift (Baumgarte); 0: none", "1/s, 1/s^2",
     IndexSpace::grasp_gains, 1000},
    {Quantity::xdd_object, "xdd_object",
     "commanded accelerations of the objects' origins over angular ones, world axes",
     "m/s^2, rad/s^2", IndexSpace::objects, 100},
    {Quantity::drift, "drift",
     "how far the rows that constraints hold relative to the world are from where they should be: "
     "position, or a small turn, along the row",
     "m, rad", IndexSpace::anchored_rows, 0.1},
    {Quantity::f_wanted, "f_wanted",
     "forces that the constraints shall have, in their rows; the nearest ones that carry the "
     "motion are taken",
     "N, N m", IndexSpace::held_rows, 1000},
    {Quantity::step, "step", "time step at whose end friction and springs are taken, positive", "s",
     IndexSpace::step, 0.01},
    {Quantity::gravity, "gravity", "acceleration of gravity, world axes", "m/s^2",
     IndexSpace::gravity, 20},
    {Quantity::payload, "payload",
     "m, m c_x, m c_y, m c_z, Ixx, Ixy, Iyy, Ixz, Iyz, Izz of each body added to a link, about the "
     "origin of the link's frame in the URDF and in its axes, kg, kg m, kg m^2",
     "kg, kg m, kg m^2", IndexSpace::payloads, kPayloadMass},
    {Quantity::parameters, "parameters",
     "m, m c_x, m c_y, m c_z, Ixx, Ixy, Iyy, Ixz, Iyz, Izz of each link named, in place of the "
     "URDF's, about the origin of the link's frame and in its axes, kg, kg m, kg m^2",
     "kg, kg m, kg m^2", IndexSpace::parameters, kPayloadMass},
    {Quantity::base_parameters, "base_parameters",
     "base parameters as listed above, in place of the inertial parameters of all links",
     "kg, kg m, kg m^2", IndexSpace::base_parameters, kPayloadMass},
    {Quantity::tool, "tool",
     "origin of each point named, in the frame of its link in the URDF, in place of the scene's, m",
     "m", IndexSpace::tools, 1},
    {Quantity::tool_orientation, "tool_orientation",
     "quaternion x, y, z, w of each point named, its axes to those of its link in the URDF, in "
     "place of the scene's; of any length",
     "1", IndexSpace::orientations, 1},
    {Quantity::contact, "contact",
     "origin of each contact named, in the frame of its link in the URDF, in place of the "
     "scene's, m",
     "m", IndexSpace::contact_places, 1},
    {Quantity::active, "active",
     "share, 0 to 1, to which each constraint named is held: at 1 as all others are, at 0 as if it "
     "were not there",
     "1", IndexSpace::active_groups, 1},
    {Quantity::active_tasks, "active_tasks",
     "share, 0 to 1, to which the task of each point named is done: at 1 as all others are, at 0 "
     "as "
     "if it were not there",
     "1", IndexSpace::active_tasks, 1},
});

static_assert(kQuantities.size() == static_cast<std::size_t>(Quantity::active_tasks) + 1,
              "every quantity has a row");
static_assert(
    [] {
      for (std::size_t i = 0; i < kQuantities.size(); ++i) {
        if (kQuantities[i].quantity != static_cast<Quantity>(i)) return false;
        for (std::size_t j = 0; j < i; ++j) {
          if (std::string_view(kQuantities[i].symbol) == kQuantities[j].symbol) return false;
        }
      }
      return true;
    }(),
    "rows are in the order of the enumeration, and no two symbols are the same");

constexpr const QuantityInfo& info_of(Quantity quantity) {
  return kQuantities[static_cast<std::size_t>(quantity)];
}
constexpr const char* symbol_of(Quantity quantity) {
  return info_of(quantity).symbol;
}
/// The quantity that an argument of this name is; nothing when there is none.
constexpr std::optional<Quantity> find_quantity(std::string_view symbol) {
  for (const QuantityInfo& row : kQuantities) {
    if (symbol == row.symbol) return row.quantity;
  }
  return std::nullopt;
}

/// Whether it says what the robot is, not what it does: the scene's key `inputs` asks for it.
constexpr bool is_of_model(Quantity quantity) {
  return quantity >= Quantity::gravity;
}

/// The quantity that an input of a graph is an entry of, as `qd` for `qd[3]`; nothing for an input
/// that is none.
constexpr std::optional<Quantity> quantity_of_input(std::string_view input) {
  const std::size_t bracket = input.find('[');
  if (bracket == std::string_view::npos) return std::nullopt;
  return find_quantity(input.substr(0, bracket));
}

}  // namespace treeline
