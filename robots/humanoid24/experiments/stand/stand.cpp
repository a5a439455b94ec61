#include "stand.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include "humanoid24_stand.hpp"
#include "humanoid24_stand_joints.hpp"
#include "servo/run_for.hpp"
#include "servo/simulated_robot.hpp"

namespace treeline::experiments {
namespace {

namespace robot = humanoid24_stand;
constexpr int kPositions = robot::kCoordinates;
constexpr int kRates = robot::kVelocities;
constexpr int kHeldRows = 12;
constexpr int kFixed = 7;  ///< columns before those of coordinates
static_assert(kPositions == 31 && kRates == 30 && robot::kTaskRows == 3);

constexpr double kPeriod = 1e-3;         ///< s
constexpr double kDuration = 6.0;        ///< s
constexpr double kLean = 0.45;           ///< of the waist to either side, rad
constexpr double kWeight = 75.0 * 9.81;  ///< N (README.md)
constexpr double kFeet[2][3] = {{0.064, 0.09, 0.0}, {0.064, -0.09, 0.0}};  ///< scene_stand.yaml
constexpr double kStabilisation[2] = {200.0, 10000.0};
// Joints in the generated code's order, after the six velocities of the base.
constexpr int kAnkle = 0, kKnee = 1, kHip = 2, kWaistRoll = 5, kLeftRoll = 7, kLeftElbow = 9,
              kRightRoll = 14, kRightElbow = 16;
constexpr double kSpread = 0.3;  ///< of the arms, which hips would touch in leaning, rad

/// Distance of both feet, which the root link carries, from where they were put, in their own
/// axes: positions and the sine of the turn.
void measure_drift(const double (&q)[kPositions], double (&drift)[kHeldRows]) {
  const double* u = q + 3;
  for (int foot = 0; foot < 2; ++foot) {
    const double* r = kFeet[foot];
    const double off[3] = {q[0] - r[0], q[1] - r[1], q[2] - r[2]};
    // R^T v = v - 2 w (u x v) + 2 u x (u x v), u: the vector part of the quaternion.
    const double c[3] = {u[1] * off[2] - u[2] * off[1], u[2] * off[0] - u[0] * off[2],
                         u[0] * off[1] - u[1] * off[0]};
    const double cc[3] = {u[1] * c[2] - u[2] * c[1], u[2] * c[0] - u[0] * c[2],
                          u[0] * c[1] - u[1] * c[0]};
    for (int i = 0; i < 3; ++i) {
      drift[6 * foot + i] = r[i] + off[i] - 2.0 * u[3] * c[i] + 2.0 * cc[i];
      drift[6 * foot + 3 + i] = 2.0 * u[3] * u[i];
    }
  }
}

struct Body {
  static constexpr int kCoordinates = kPositions;
  static constexpr int kVelocities = kRates;
  static constexpr servo::FloatingJoints<kPositions, kRates> kFloating = {0};
  /// The loop brakes by the motors alone, as it controls.
  static void inverse_dynamics(const double (&q)[kPositions], const double (&qd)[kRates],
                               const double (&qdd)[kRates], double (&tau)[kRates]) noexcept {
    const double rest[3] = {};
    const double wanted[kHeldRows] = {};
    double f[kHeldRows];
    robot::supported_control_torque(q, qd, qdd, rest, wanted, tau, f);
  }
  static void forward_dynamics(const double (&q)[kPositions], const double (&qd)[kRates],
                               const double (&tau)[kRates], double (&qdd)[kRates]) noexcept {
    double f[kHeldRows];
    double drift[kHeldRows];
    measure_drift(q, drift);
    robot::constrained_forward_dynamics(q, qd, tau, kStabilisation, drift, qdd, f);
  }
};
using State = servo::StateOf<Body>;

/// Limits of speeds and torques as the URDF has them; the base has no motors. Limits of position
/// are left out: the law does not know them, and the wrist passes its own by a tenth of a degree.
servo::SafetyLimits<kPositions, kRates> limits_of_humanoid() {
  servo::SafetyLimits<kPositions, kRates> limits;
  std::copy(std::begin(robot::kVelocityLimits), std::end(robot::kVelocityLimits),
            limits.velocity.begin());
  std::copy(std::begin(robot::kEffortLimits), std::end(robot::kEffortLimits),
            limits.torque.begin());
  std::fill_n(limits.torque.begin(), 6, 0.0);
  return limits;
}

State initial_state() {
  State state{};
  state.q[6] = 1.0;
  double* joints = state.q + 7;
  joints[kAnkle] = 0.25;
  joints[kKnee] = -0.45;
  joints[kHip] = 0.2;
  joints[kLeftElbow] = joints[kRightElbow] = -0.8;
  joints[kLeftRoll] = kSpread;
  joints[kRightRoll] = -kSpread;
  return state;
}

/// Angle of the waist: from rest to one side, to the other and back to rest.
double lean_at(double time) {
  const double turn = 2.0 * std::acos(-1.0) * time / kDuration;
  return kLean * std::sin(turn) * 0.5 * (1.0 - std::cos(2.0 * turn));
}

/// What the controller asks for at one state.
struct Wish {
  double xdd_cmd[3];
  double qdd_0[kRates] = {};
  double f_wanted[kHeldRows] = {};
  double hand_error = 0.0;
};

/// The hand stays, the posture leans, the load of the feet follows the centre of mass.
Wish wish_at(double time, const State& state, const State& start, const double (&place)[3]) {
  Wish wish;
  double position[3], rotation[9], J[3 * kRates], com[3];
  robot::forward_kinematics(state.q, position, rotation);
  robot::jacobian(state.q, J);
  robot::center_of_mass(state.q, com);
  for (int i = 0; i < 3; ++i) {
    double velocity = 0.0;
    for (int k = 0; k < kRates; ++k) velocity += J[i * kRates + k] * state.qd[k];
    wish.xdd_cmd[i] = 1600.0 * (place[i] - position[i]) - 80.0 * velocity;
  }
  wish.hand_error =
      std::hypot(place[0] - position[0], place[1] - position[1], place[2] - position[2]);
  for (int k = 6; k < kRates; ++k) {
    const double wanted = start.q[k + 1] + (k == 6 + kWaistRoll ? lean_at(time) : 0.0);
    wish.qdd_0[k] = 400.0 * (wanted - state.q[k + 1]) - 40.0 * state.qd[k];
  }
  const double share = 0.5 + com[1] / (kFeet[0][1] - kFeet[1][1]);
  wish.f_wanted[2] = kWeight * share;
  wish.f_wanted[8] = kWeight * (1.0 - share);
  return wish;
}

/// Forces of the ground on both feet together, N.
double force_difference(const double (&a)[kHeldRows], const double (&b)[kHeldRows]) {
  double difference = 0.0;
  for (int i = 0; i < 3; ++i) {
    difference = std::max(difference, std::fabs(a[i] + a[6 + i] - b[i] - b[6 + i]));
  }
  return difference;
}

void look_at_ground(const State& state, const double (&tau)[kRates], const double (&f)[kHeldRows],
                    StandFigures& figures) {
  double drift[kHeldRows], ground[kHeldRows], qdd[kRates];
  measure_drift(state.q, drift);
  for (const double off : drift) figures.drift = std::max(figures.drift, std::fabs(off));
  robot::constrained_forward_dynamics(state.q, state.qd, tau, kStabilisation, drift, qdd, ground);
  figures.force_error = std::max(figures.force_error, force_difference(f, ground));
  for (int i = 0; i < 6; ++i) {
    figures.base_torque = std::max(figures.base_torque, std::fabs(tau[i]));
  }
  for (const double* foot : {f, f + 6}) {
    figures.least_load = std::min(figures.least_load, foot[2]);
    figures.friction = std::max(figures.friction, std::hypot(foot[0], foot[1]) / foot[2]);
    figures.pressure_x = std::max(figures.pressure_x, std::fabs(foot[4] / foot[2]));
    figures.pressure_y = std::max(figures.pressure_y, std::fabs(foot[3] / foot[2]));
  }
}

void record(double time, const Wish& wish, const State& state, const double (&tau)[kRates],
            const double (&f)[kHeldRows], StandRun& run) {
  StandFigures& figures = run.figures;
  const double share = f[2] / (f[2] + f[8]);
  figures.hand_error = std::max(figures.hand_error, wish.hand_error);
  figures.least_share = std::min(figures.least_share, share);
  figures.most_share = std::max(figures.most_share, share);
  look_at_ground(state, tau, f, figures);
  double row[kFixed + kPositions] = {
      time, state.q[7 + kWaistRoll], wish.hand_error, f[2], f[8], f[3], f[9]};
  std::copy(std::begin(state.q), std::end(state.q), row + kFixed);
  run.table.append(row);
}

std::vector<std::string> column_names() {
  return report::with_coordinates({"time", "waist_roll", "hand_error", "left_load", "right_load",
                                   "left_roll_moment", "right_roll_moment"},
                                  robot::kCoordinates);
}

}  // namespace

StandRun run_stand() {
  const State start = initial_state();
  double place[3], rotation[9];
  robot::forward_kinematics(start.q, place, rotation);
  servo::SimulatedRobot<Body> simulated(start, 4, Body::kFloating);
  const int cycles = static_cast<int>(std::lround(kDuration / kPeriod));
  StandRun run{report::Table(column_names(), static_cast<std::size_t>(cycles) + 1), {}};
  const auto law = [&](double time, const State& state, double(&tau)[kRates]) {
    const Wish wish = wish_at(time, state, start, place);
    double f[kHeldRows];
    robot::supported_control_torque(state.q, state.qd, wish.qdd_0, wish.xdd_cmd, wish.f_wanted, tau,
                                    f);
    record(time, wish, state, tau, f, run);
    return true;
  };
  const servo::RunEnd end =
      servo::run_law<Body>(kDuration, 1.0 / kPeriod, limits_of_humanoid(), simulated, law);
  run.figures.fault = static_cast<bool>(end.fault);
  return run;
}

std::string stand_summary(const StandRun& run) {
  const StandFigures& f = run.figures;
  return fmt::format(
      "the humanoid stands on two feet and leans by {} rad to either side\n"
      "torque at the base        {} N m, largest\n"
      "left hand off its place   {:.2e} m\n"
      "feet off their places     {:.2e} m, rad\n"
      "share of the left foot    {:.3f} to {:.3f}, least load of a foot {:.1f} N\n"
      "centres of pressure       {:.4f} m forward, {:.4f} m sideways of the feet's middles\n"
      "friction                  {:.3f}\n"
      "forces chosen and acting  {:.2e} N apart\n",
      kLean, f.base_torque, f.hand_error, f.drift, f.least_share, f.most_share, f.least_load,
      f.pressure_x, f.pressure_y, f.friction, f.force_error);
}

report::Plot stand_figure(const StandRun& run) {
  report::Plot plot;
  plot.title = "The humanoid shifts its weight, motors alone";
  plot.x_label = "time (s)";
  plot.x = run.table.column(0);
  plot.panels.push_back(
      {"Waist, roll", "angle (rad)", {{"waist", run.table.column(1), false}}, 0.0});
  plot.panels.push_back(
      {"Load of the feet",
       "force (N)",
       {{"left", run.table.column(3), false}, {"right", run.table.column(4), false}},
       0.0});
  std::vector<double> error = run.table.column(2);
  for (double& value : error) value *= 1e6;
  plot.panels.push_back(
      {"Hand's distance from its place", "distance (\u00b5m)", {{"hand", error, false}}, 0.0});
  return plot;
}

bool stand_claim_holds(const StandRun& run) {
  const StandFigures& f = run.figures;
  const bool held = !f.fault && f.base_torque == 0.0 && f.hand_error < 1e-4 && f.drift < 1e-9;
  const bool shifted = f.least_share < 0.4 && f.most_share > 0.58;
  const bool carried = f.least_load > 0.0 && f.friction < 0.2 && f.pressure_x < 0.12 &&
                       f.pressure_y < 0.045 && f.force_error < 1e-6 * kWeight;
  return held && shifted && carried;
}

}  // namespace treeline::experiments
