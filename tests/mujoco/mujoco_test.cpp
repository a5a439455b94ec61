// The interpreter with Treeline's reader, compared with MuJoCo with its own reader: every robot of
// tests/data, fixed and floating, at random states. Would catch: misunderstandings of URDF that the
// reader and the interpreter share; momentum about another point or with the rotors' own, and
// accelerations of frames that are those of twists. disagreements.tsv lists the differences and
// their reasons; a row whose figures agree is a failure.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "data/list_data.hpp"
#include "description/read_urdf.hpp"
#include "interpreter/instances.hpp"
#include "mujoco/mujoco_figures.hpp"

namespace treeline::tests {
namespace {

constexpr double kTolerance = 1e-9;
/// Share of the largest figure by which smaller figures may differ due to rounding.
constexpr double kFloor = 1e-5;

struct Case {
  DataRobot robot;
  Base base;
};

std::string name_of(const Case& tested) {
  const bool floats = tested.base == Base::floating;
  return tested.robot.name.substr(tested.robot.name.find('/') + 1) +
         (floats ? "_floating" : "_fixed");
}

void PrintTo(const Case& tested, std::ostream* out) {
  *out << name_of(tested);
}

std::vector<Case> list_cases() {
  std::vector<Case> cases;
  for (const char* folder : {"published", "golden"}) {
    for (const DataRobot& robot : data_robots(folder)) {
      // Of files in both folders one suffices.
      if (robot.name == "golden/ur5" || robot.name == "golden/panda") continue;
      cases.push_back({robot, Base::fixed});
      cases.push_back({robot, Base::floating});
    }
  }
  return cases;
}

/// Reasons of known differences, by figure.
std::map<std::string, std::string> known_disagreements(const std::string& name) {
  std::map<std::string, std::string> known;
  std::ifstream table(TREELINE_MUJOCO_DISAGREEMENTS);
  std::string line;
  std::getline(table, line);
  while (std::getline(table, line)) {
    std::istringstream columns(line);
    std::string robot, figure, reason;
    std::getline(columns, robot, '\t');
    std::getline(columns, figure, '\t');
    std::getline(columns, reason, '\t');
    if (robot == name) known[figure] = reason;
  }
  return known;
}

double mass_matrix_error(const DoubleMatrix& ours, const DoubleMatrix& theirs) {
  const DoubleVector size = theirs.diagonal().cwiseAbs().cwiseSqrt();
  const DoubleMatrix scale =
      (size * size.transpose()).array() + kFloor * theirs.cwiseAbs().maxCoeff();
  return (ours - theirs).cwiseAbs().cwiseQuotient(scale).maxCoeff();
}

/// Relative to the terms that forces are sums of.
double error_of_sum(const DoubleVector& ours, const DoubleVector& theirs,
                    const DoubleVector& terms) {
  const DoubleVector scale = terms.array() + kFloor * terms.maxCoeff();
  return (ours - theirs).cwiseAbs().cwiseQuotient(scale).maxCoeff();
}

double force_error(const DoubleVector& ours, const DoubleVector& theirs, const MujocoState& s) {
  return error_of_sum(ours, theirs,
                      s.mass_matrix.cwiseAbs() * s.qdd.cwiseAbs() + s.nonlinear_effects.cwiseAbs() +
                          s.inverse_dynamics.cwiseAbs());
}

double pose_error(const interpreter::PointPose<double>& ours,
                  const interpreter::PointPose<double>& theirs) {
  const double length = std::max(1.0, theirs.position.norm());
  return std::max((ours.position - theirs.position).norm() / length,
                  (ours.rotation - theirs.rotation).norm());
}

interpreter::Points<double> points_at(const interpreter::Model<double>& model,
                                      const std::vector<std::string>& links) {
  std::vector<ScenePoint> points(links.size());
  for (std::size_t i = 0; i < links.size(); ++i) points[i].name = points[i].link = links[i];
  return points_from_scene(model, points);
}

using Errors = std::map<std::string, double>;

/// Six entries of each link, relative to the largest of all links, but to 1 at least.
double twist_error(const DoubleVector& ours, const DoubleVector& theirs,
                   const std::vector<std::string>& links) {
  double worst = 0;
  for (std::size_t i = 0; i < links.size(); ++i) {
    const auto at = 6 * static_cast<Eigen::Index>(i);
    if (links[i] == "world") continue;
    worst = std::max(worst, (ours.segment<6>(at) - theirs.segment<6>(at)).norm());
  }
  return worst / std::max(1.0, theirs.cwiseAbs().maxCoeff());
}

double relative_error(const DoubleMatrix& ours, const DoubleMatrix& theirs) {
  return (ours - theirs).cwiseAbs().maxCoeff() / std::max(1e-3, theirs.cwiseAbs().maxCoeff());
}

template <class Note>
void note_whole(const interpreter::Model<double>& model, const MujocoState& s, Note note) {
  const MujocoWhole& whole = s.whole;
  note("center_of_mass",
       relative_error(interpreter::center_of_mass<double>(model, s.q), whole.center_of_mass));
  note("potential_energy",
       relative_error(DoubleVector::Constant(1, interpreter::potential_energy<double>(model, s.q)),
                      DoubleVector::Constant(1, whole.potential_energy)));
  note("center_of_mass_jacobian",
       relative_error(interpreter::center_of_mass_jacobian<double>(model, s.q),
                      whole.center_of_mass_jacobian));
  note("centroidal_momentum_matrix",
       relative_error(interpreter::centroidal_momentum_matrix<double>(model, s.q),
                      whole.momentum_matrix));
  note("centroidal_momentum",
       relative_error(interpreter::centroidal_momentum<double>(model, s.q, s.qd), whole.momentum));
}

/// The same robot without anything in its joints, with rotors of motors, and with friction and
/// springs besides.
struct Models {
  interpreter::Model<double> plain, with_rotors, with_drives;
};

/// Differences of accelerations count as the forces that they take.
template <class Note>
void note_drives(const interpreter::Model<double>& model, const MujocoState& s, Note note) {
  const DoubleVector tau = interpreter::inverse_dynamics<double>(model, s.q, s.qd, s.qdd);
  note("inverse_dynamics_with_drives", force_error(tau, s.inverse_dynamics_with_drives, s));
  const DoubleMatrix M = interpreter::mass_matrix<double>(model, s.q);
  const DoubleVector moments = Eigen::SelfAdjointEigenSolver<DoubleMatrix>(M).eigenvalues();
  if (moments(0) < 1e-13 * moments(moments.size() - 1)) return;  // a base without mass
  const DoubleVector& theirs = s.forward_dynamics_with_drives;
  const DoubleVector terms =
      M.cwiseAbs() * theirs.cwiseAbs() + s.nonlinear_effects.cwiseAbs() + s.applied.cwiseAbs();
  const DoubleVector ours = interpreter::forward_dynamics<double>(model, s.q, s.qd, s.applied);
  note("forward_dynamics_with_drives", error_of_sum(M * ours, M * theirs, terms));
  note("forward_dynamics_with_drives_backward",
       error_of_sum(interpreter::inverse_dynamics<double>(model, s.q, s.qd, theirs), s.applied,
                    terms));
}

void add_errors(const Models& models, const MujocoFigures& figures, const MujocoState& s,
                Errors& errors) {
  const auto& model = models.plain;
  const auto note = [&](const char* figure, double error) {
    if (!(error <= errors[figure])) errors[figure] = error;
  };
  const auto points = points_at(model, figures.links);
  const auto poses = interpreter::forward_kinematics<double>(model, points, s.q);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (figures.links[i] != "world") note("poses", pose_error(poses[i], s.poses[i]));
  }
  if (model.nv == 0) return;
  note("mass_matrix",
       mass_matrix_error(interpreter::mass_matrix<double>(model, s.q), s.mass_matrix));
  note("nonlinear_effects", force_error(interpreter::nonlinear_effects<double>(model, s.q, s.qd),
                                        s.nonlinear_effects, s));
  note("inverse_dynamics",
       force_error(interpreter::inverse_dynamics<double>(model, s.q, s.qd, s.qdd),
                   s.inverse_dynamics, s));
  note("point_velocity", twist_error(interpreter::point_velocity<double>(model, points, s.q, s.qd),
                                     s.velocities, figures.links));
  note("point_acceleration",
       twist_error(interpreter::point_acceleration<double>(model, points, s.q, s.qd, s.qdd),
                   s.accelerations, figures.links));
  note("mass_matrix_with_rotors",
       mass_matrix_error(interpreter::mass_matrix<double>(models.with_rotors, s.q),
                         s.mass_matrix_with_rotors));
  note("kinetic_energy_with_rotors",
       relative_error(DoubleVector::Constant(
                          1, interpreter::kinetic_energy<double>(models.with_rotors, s.q, s.qd)),
                      DoubleVector::Constant(1, s.kinetic_energy_with_rotors)));
  note_drives(models.with_drives, s, note);
  if (interpreter::total_mass(model) > 0) note_whole(models.with_rotors, s, note);
}

/// Largest error of each figure. Figures that cannot be compared are reported.
Errors compare(const Case& tested, std::string& text) {
  Diagnostics diagnostics;
  std::optional<Robot> robot = read_urdf(tested.robot.path, diagnostics);
  if (!robot) {
    for (const Diagnostic& d : diagnostics.list()) text += to_string(d) + "\n";
    return {{"refused by Treeline", 1}};
  }
  for (Joint& joint : robot->joints) joint.mimic.reset();
  Scene scene;
  scene.base = tested.base;
  const auto model = model_from_robot<double>(*robot, scene);
  const auto figures = read_mujoco_figures(
      std::string(TREELINE_MUJOCO_FIGURES) + "/" + name_of(tested) + ".json", *robot, model);
  if (!figures.refused.empty()) {
    text = figures.refused;
    return {{"refused by MuJoCo", 1}};
  }
  if (figures.nv != model.nv) return {{"freedoms", 1}};
  text = "seed " + std::to_string(figures.seed);
  scene.armature = figures.armature;
  const auto with_rotors = model_from_robot<double>(*robot, scene);
  for (const auto& [joint, damping] : figures.damping) {
    scene.joint_friction[joint] = {damping, 0, 0};
  }
  for (const auto& [joint, stiffness] : figures.stiffness) {
    scene.joint_springs[joint] = {stiffness, 0};
  }
  const Models models{model, with_rotors, model_from_robot<double>(*robot, scene)};
  Errors errors;
  for (const MujocoState& state : figures.states) add_errors(models, figures, state, errors);
  return errors;
}

class Mujoco : public testing::TestWithParam<Case> {};

INSTANTIATE_TEST_SUITE_P(Robots, Mujoco, testing::ValuesIn(list_cases()),
                         [](const auto& tested) { return name_of(tested.param); });

TEST_P(Mujoco, Agrees) {
  std::string text;
  const Errors errors = compare(GetParam(), text);
  const auto known = known_disagreements(name_of(GetParam()));
  for (const auto& [figure, error] : errors) {
    std::ostringstream value;
    value << error;
    RecordProperty(figure, value.str());
    if (known.count(figure) == 0) {
      EXPECT_LE(error, kTolerance) << figure << ": " << text;
    } else {
      EXPECT_GT(error, kTolerance) << figure << " agrees now: remove its row";
    }
  }
  for (const auto& [figure, reason] : known) {
    EXPECT_EQ(errors.count(figure), 1U)
        << figure << " (" << reason << ") is not so: remove its row";
  }
}

TEST(MujocoDisagreements, NameRobotsThatAreHere) {
  std::set<std::string> names;
  for (const Case& tested : list_cases()) names.insert(name_of(tested));
  std::ifstream table(TREELINE_MUJOCO_DISAGREEMENTS);
  std::string line;
  ASSERT_TRUE(std::getline(table, line));
  while (std::getline(table, line)) {
    EXPECT_EQ(names.count(line.substr(0, line.find('\t'))), 1U) << line;
    EXPECT_EQ(std::count(line.begin(), line.end(), '\t'), 2) << line << ": a reason is missing";
  }
}

}  // namespace
}  // namespace treeline::tests
