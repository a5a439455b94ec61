#include "interpreter/supported_cases.hpp"

#include <Eigen/QR>
#include <algorithm>

#include "description/scene_queries.hpp"
#include "oracle/model_from_robot.hpp"
#include "recursion/function_results.hpp"

namespace treeline::tests {

std::ostream& operator<<(std::ostream& out, const Standing& standing) {
  return out << standing.name;
}

const std::vector<Standing>& standings() {
  static const std::vector<Standing> kStandings{
      {"one_foot", {kAllRows}},
      {"two_feet", {kAllRows, kAllRows}},
      {"three_points", {kPointFoot, kPointFoot, kPointFoot}},
      {"four_points", {kPointFoot, kPointFoot, kPointFoot, kPointFoot}, 3},
      {"foot_and_edge", {kAllRows, {true, false, true, true, false, false}}, 4},
      {"two_points", {kPointFoot, kPointFoot}, 3},
      {"one_point", {kPointFoot}, 3},
      {"no_foot", {}, 3},
      {"passive_joint", {}, 3, false, 1},
      {"passive_joints_at_a_wall", {kPointFoot}, 2, false, 2},
      {"hand_at_a_wall", {kAllRows}, 2, false},
      {"mimics", {kAllRows, kAllRows}, 3, true, 0, 0.15},
      {"pushed", {kPointFoot, kPointFoot, kPointFoot}, 3, true, 1, 0, 2},
      {"drives", {kAllRows}, 4, true, 1, 0, 1, 0.5}};
  return kStandings;
}

const std::vector<Standing>& looped() {
  static const std::vector<Standing> kLooped{
      {"hinged_loop", {}, 2, false, 2, 0, 0, 0, {kHinge}},
      {"two_loops", {}, 2, false, 3, 0, 1, 0.5, {kHinge, kPointFoot}},
      {"loop_in_space", {}, 2, true, 1, 0, 0, 0, {kHinge}},
      {"loop_on_a_foot",
       {kPointFoot},
       2,
       false,
       2,
       0,
       0,
       0,
       {{true, false, true, true, false, false}}},
      {"loop_with_mimics", {}, 2, false, 1, 0.15, 0, 0, {kPointFoot}},
      {"welded_loop", {}, 2, false, 2, 0, 0, 0, {kAllRows}},
      {"coupled", {}, 2, false, 1, 0, 0, 0, {}, 2},
      {"coupled_loop", {kPointFoot}, 2, true, 0, 0, 0, 0, {kHinge}, 1}};
  return kLooped;
}

const std::vector<Standing>& rolling() {
  const SceneRolling ball{0.3, {}, {}}, disc{0.4, {{0.48, 0.6, 0.64}}, {}}, balls{0.3, {}, 0.5},
      bowl{0.3, {}, -0.9};
  const Rows flat{true, true, false, false, false, false};
  const Rows no_spin{true, true, true, false, false, true};
  static const std::vector<Standing> kRolling{
      {"ball_on_the_ground", {}, 2, true, 1, 0, 0, 0, {no_spin}, 0, {ball}, true},
      {"disc_on_the_ground", {}, 2, true, 1, 0, 0, 0, {kPointFoot}, 0, {disc}, true},
      {"two_wheels", {}, 2, true, 2, 0, 0, 0, {flat, kPointFoot}, 0, {disc, ball}, true},
      {"ball_on_a_link", {}, 2, false, 1, 0, 1, 0.5, {kPointFoot}, 0, {ball}},
      {"disc_on_a_link", {}, 2, false, 2, 0, 0, 0, {kPointFoot}, 1, {disc}},
      {"two_balls", {kPointFoot}, 2, true, 1, 0, 0, 0, {kPointFoot}, 0, {balls}},
      {"ball_in_a_bowl", {}, 2, true, 1, 0, 0, 0, {kPointFoot}, 0, {bowl}, true}};
  return kRolling;
}

std::vector<Standing> standings_and_loops() {
  std::vector<Standing> all = standings();
  all.insert(all.end(), looped().begin(), looped().end());
  all.insert(all.end(), rolling().begin(), rolling().end());
  return all;
}

namespace {

/// A constraint between two links that move against each other.
SceneLoop draw_loop(Rng& rng, const RandomOptions& options, const RandomMechanism& made,
                    const std::string& name) {
  SceneLoop loop;
  do {
    loop = {detail::random_point(rng, options, made.robot, name),
            detail::random_point(rng, options, made.robot, name)};
  } while (!moves_against(made.robot, made.scene, loop.first.link, loop.second.link));
  return loop;
}

/// Constraints between joints: each of two, or of one alone.
void draw_couplings(Rng& rng, int count, RandomMechanism& made) {
  std::vector<std::string> joints;
  for (const Joint& joint : made.robot.joints) {
    if (detail::has_one_degree(joint) && !joint.mimic) joints.push_back(joint.name);
  }
  for (int i = 0; i < count; ++i) {
    SceneCoupling coupling{"coupling_" + std::to_string(i), {}, rng.rounded(-1, 1)};
    for (int part = 0; part < 2; ++part) {
      coupling.parts.push_back({joints[detail::at(2 * i + part)], rng.rounded(0.5, 3)});
    }
    made.scene.couplings.push_back(coupling);
  }
}

RandomOptions options_of(const Standing& standing) {
  RandomOptions options;
  options.joints = 10 + 5 * static_cast<int>(standing.feet.size() + standing.loops.size());
  options.branching = 0.2;
  options.mix = {5, 1, 1, 0.3, 0, 0.3, 0.3};
  options.floating_base = standing.floating_base;
  options.mimic = standing.mimic;
  options.rotors = options.drives = standing.drives;
  options.operational_points = 2;
  options.external_forces = standing.external_forces;
  return options;
}

void draw_feet(Rng& rng, const Standing& standing, RandomMechanism& made) {
  for (std::size_t i = 0; i < standing.feet.size(); ++i) {
    made.scene.constraints.push_back(
        detail::random_point(rng, options_of(standing), made.robot, "foot_" + std::to_string(i)));
    made.scene.constraints.back().rows = standing.feet[i];
  }
}

void draw_loops(Rng& rng, const Standing& standing, RandomMechanism& made) {
  auto& loops = made.scene.loops;
  for (std::size_t i = 0; i < standing.loops.size(); ++i) {
    loops.push_back(draw_loop(rng, options_of(standing), made, "loop_" + std::to_string(i)));
    loops.back().second.rows = standing.loops[i];
    if (i < standing.rolling.size()) loops.back().rolling = standing.rolling[i];
    if (standing.on_world) loops.back().second.link = kWorldEnd;
  }
}

/// Rows and priorities of tasks, at most `standing.task_rows` rows in all, and which joints have no
/// motor.
void draw_tasks(Rng& rng, const Standing& standing, RandomMechanism& made) {
  Scene& scene = made.scene;
  int left = standing.task_rows;
  for (ScenePoint& point : scene.operational_points) {
    for (bool& row : point.rows) row = left > 0 && rng.chance(0.6) && left-- > 0;
    point.priority = 1 + rng.below(2);
  }
  for (const Joint& joint : made.robot.joints) {
    const auto wanted = static_cast<std::size_t>(standing.passive);
    if (scene.passive.size() < wanted && detail::has_one_degree(joint) && !joint.mimic) {
      scene.passive.push_back(joint.name);
    }
  }
}

/// What `made` asks for, without the numbers of a state.
interpreter::SupportedTask<Digits50> task_of(const interpreter::Model<Digits50>& model,
                                             const RandomMechanism& made) {
  interpreter::SupportedTask<Digits50> task;
  task.constraints = points_from_scene(model, made.scene.constraints);
  task.loops = loops_from_scene(model, made.robot, made.scene);
  task.points = points_from_scene(model, made.scene.operational_points);
  task.passive = passive_velocities(model, made.robot, made.scene);
  task.external_points = points_from_scene(model, made.scene.external_forces);
  return task;
}

void draw_numbers(Rng& rng, const Standing& standing, StandingCase& c) {
  const auto drawn = [&](int count, double size) {
    return random_entries<Digits50>(rng, count, size);
  };
  const int anchored = interpreter::row_count(c.task.constraints);
  const int held = anchored + interpreter::row_count(c.task.loops);
  c.q = random_position(rng, c.model, 2.0);
  c.qd = drawn(c.model.nv, 2);
  c.tau = drawn(c.model.nv, 20);
  c.drift = drawn(anchored, 0.01);
  c.task.qdd_0 = drawn(c.model.nv, 5);
  c.task.xdd_cmd = drawn(interpreter::row_count(c.task.points), 5);
  c.task.f_wanted = drawn(held, 50);
  c.task.f_ext = drawn(6 * standing.external_forces, 30);
}

}  // namespace

StandingCase draw_standing(std::uint64_t seed, const Standing& standing) {
  StandingCase c;
  c.made = random_mechanism(seed, options_of(standing));
  Rng rng(seed + 5);
  draw_feet(rng, standing, c.made);
  draw_loops(rng, standing, c.made);
  draw_couplings(rng, standing.couplings, c.made);
  draw_tasks(rng, standing, c.made);
  c.model = model_from_robot<Digits50>(c.made.robot, c.made.scene);
  c.task = task_of(c.model, c.made);
  draw_numbers(rng, standing, c);
  return c;
}

namespace {

/// Smallest singular value but those that are zero to rounding, relative to the largest.
double spread(const Matrix50& A) {
  if (A.rows() == 0 || A.cols() == 0) return 1;
  const Eigen::MatrixXd in_double =
      A.unaryExpr([](const Digits50& x) { return static_cast<double>(x); });
  const Eigen::VectorXd s = in_double.jacobiSvd().singularValues();
  double least = s(0);
  for (const double value : s) {
    if (value > 1e-11 * s(0)) least = value;
  }
  return s(0) / least;
}

/// Inverse inertia of the task rows by motors alone, while constraints hold: from the motion that a
/// unit force of each motor causes.
Matrix50 motor_mobility(const StandingCase& c) {
  const interpreter::detail::SupportedRows<Digits50> rows(c.model, c.task, c.q, c.qd);
  const Matrix50 M_inverse = interpreter::inverse_of_positive_definite<Digits50>(rows.M);
  const Matrix50 J_s = rows.J.topRows(rows.held);
  Matrix50 held = M_inverse;
  if (rows.held > 0) {
    const Matrix50 carried = M_inverse * J_s.transpose();
    const Matrix50 A = J_s * carried;
    held -= carried * interpreter::inverse_of_positive_definite<Digits50>(A) * carried.transpose();
  }
  Matrix50 by_motors = rows.J.bottomRows(rows.J.rows() - rows.held) * held;
  for (const int v : c.task.passive) by_motors.col(v).setZero();
  return by_motors * by_motors.transpose();
}

}  // namespace

StandingCase draw_standing_regular(std::uint64_t seed, const Standing& standing) {
  for (;; seed += 13) {
    StandingCase c = draw_standing(seed, standing);
    if (interpreter::row_count(c.task.points) == 0) continue;
    const interpreter::detail::SupportedRows<Digits50> rows(c.model, c.task, c.q, c.qd);
    const Matrix50 A =
        rows.J * interpreter::inverse_of_positive_definite<Digits50>(rows.M) * rows.J.transpose();
    if (rows.held > 0) {
      c.growth = condition(Matrix50(A.topLeftCorner(rows.held, rows.held)));
      if (!(c.growth < 1e5)) continue;
      c.growth = std::max(c.growth, spread(rows.J_passive.topRows(rows.held)));
    }
    c.growth = std::max({c.growth, condition(rows.M), condition(A), condition(motor_mobility(c))});
    if (c.growth < 1e6) return c;
  }
}

}  // namespace treeline::tests
