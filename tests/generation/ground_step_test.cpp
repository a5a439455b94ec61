// Would catch: a generated step on the ground that differs from the interpreter's, whose
// formulation shares no dynamics with it; code in C whose bits are not those of C++; impulses that
// do not add up to the change of momentum; energy that contacts make; points that sink; a step that
// hangs on where in the world the robot is; and a foot that its motor lifts off while it stands.
#include <dlfcn.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <random>
#include <string>

#include "compilation/run_commands.hpp"
#include "compilation/temporary_folder.hpp"
#include "description/diagnosed.hpp"
#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"
#include "emission/write_files.hpp"
#include "generation/generate_code.hpp"
#include "interpreter/instances.hpp"
#include "oracle/model_from_robot.hpp"
#include "simulation/integrate.hpp"
#include "simulation/step_on_ground.hpp"

namespace treeline {
namespace {

using namespace simulation;  // NOLINT(google-build-using-namespace)
using simulation::State;

constexpr double kStep = 1e-3;  // s
constexpr double kFriction = 0.7;

Robot read_robot_of(const std::string& name) {
  Diagnostics diagnostics;
  return *read_urdf(std::string(TREELINE_SOURCE_DIR) + "/" + name + ".urdf", diagnostics);
}

/// A box, a ball and a rim of a link.
std::vector<SceneTouch> shapes_on(const std::string& link, double size) {
  SceneTouch box{link, {}, 0, {}};
  for (int corner = 0; corner < 8; ++corner) {
    const auto side = [&](int bit) { return (corner & bit) != 0 ? size : -size; };
    box.points.push_back({side(1), 0.5 * side(2), 0.7 * side(4)});
  }
  const SceneTouch ball{link, {{0, 0, -size}}, 0.8 * size, {}};
  const SceneTouch rims{link, {{0, -size, 0}, {0, size, 0}}, size, {0, 1, 0}};
  return {box, ball, rims};
}

std::vector<GroundShape> as_ground_shapes(const interpreter::Model<double>& model,
                                          const std::vector<SceneTouch>& touches) {
  std::vector<GroundShape> shapes;
  for (const SceneTouch& touch : touches) {
    GroundShape shape{find_body<double>(model, touch.link), touch.link, {}, touch.radius, {}};
    for (const auto& p : touch.points) shape.points.emplace_back(p[0], p[1], p[2]);
    shape.axis = {touch.axis[0], touch.axis[1], touch.axis[2]};
    shapes.push_back(shape);
  }
  return shapes;
}

/// As NAME_ground.h declares it.
struct Report {
  std::int32_t contacts, converged, left_out;
  double miss, impulse[3], energy;
  double touches[6 * 64];  // of as many contacts as the robot may have
};

/// A compiled step with its memory.
class EmittedStep {
 public:
  EmittedStep(const Robot& robot, const Scene& scene) {
    Diagnostics diagnostics;
    const auto made = generate_code(robot, scene, {}, diagnostics);
    if (!made) throw std::runtime_error(to_string(diagnostics));
    const std::filesystem::path code = folder_.path() / "code";
    if (!write_files(code, made->files, diagnostics)) {
      throw std::runtime_error(to_string(diagnostics));
    }
    const bool is_c = scene.language == Language::c;
    Command command = {is_c ? TREELINE_CC : TREELINE_CXX};
    for (const char* word : {"-O1", "-ffp-contract=off", "-Wall", "-Wextra", "-Wpedantic",
                             "-Wshadow", "-Wconversion", "-Werror", "-fPIC", "-shared", "-o"}) {
      command.emplace_back(word);
    }
    command.insert(command.begin() + 1, is_c ? "-std=c99" : "-std=c++17");
    const std::filesystem::path library = folder_.path() / "libstep.so";
    command.push_back(library);
    for (const Source& source : made->sources) {
      if (source.file.starts_with("ground")) command.push_back(code / source.file);
    }
    const auto outcome = run_commands({command}, 1, folder_.path()).front();
    if (outcome.exit_code != 0) throw std::runtime_error(first_lines(outcome.output));
    handle_.reset(dlopen(library.c_str(), RTLD_NOW));
    const std::string name = scene.name + "_ground_step";
    step_ = reinterpret_cast<Step>(dlsym(handle_.get(), name.c_str()));
  }

  Report step(double friction, double dt, const Vector& tau, State& state) {
    Report report{};
    step_(&friction, dt, tau.data(), state.q.data(), state.qd.data(), memory_.data(), &report);
    return report;
  }

 private:
  using Step = void (*)(const double*, double, const double*, double*, double*, void*, Report*);
  struct Closer {
    void operator()(void* handle) const { dlclose(handle); }
  };
  TemporaryFolder folder_;
  std::unique_ptr<void, Closer> handle_;
  Step step_ = nullptr;
  std::array<double, 128> memory_{};
};

/// A robot, what of it may touch the ground, and the interpreter's step.
struct Subject {
  Robot robot;
  Scene scene;
  interpreter::Model<double> model;
  Ground ground;

  static Subject make(Robot robot, const std::string& text,
                      const std::vector<SceneTouch>& touches) {
    Diagnostics diagnostics;
    Scene scene =
        *parse_scene(text + "ground: {step: true, friction: 0.7}\n", "s.yaml", robot, diagnostics);
    scene.functions = {Function::mass_matrix};
    scene.touches = touches;
    auto model = model_from_robot<double>(robot, scene);
    Ground ground(model, as_ground_shapes(model, touches));
    return {std::move(robot), std::move(scene), std::move(model), std::move(ground)};
  }

  [[nodiscard]] State fly(const State& from, double dt, const Vector& tau) const {
    State state = from;
    const Acceleration free = [&](double, const State& at) {
      return interpreter::forward_dynamics<double>(model, at.q, at.qd, tau);
    };
    step_semi_implicit_euler(coordinates_of(model), free, 0, dt, state);
    return state;
  }

  void step(double friction, double dt, const Vector& tau, State& state,
            GroundAccount& account) const {
    const Flight flight = [&](double, double part, State& at) {
      at = fly(at, part, tau);
      return true;
    };
    const OnGround on{model, ground, {0, friction, 0}, flight, true};
    ASSERT_TRUE(step_on_ground(on, 0, dt, state, account));
  }

  /// A random state, the lowest point 0.1 m above the ground.
  [[nodiscard]] State above_ground(std::uint64_t seed) const {
    std::mt19937_64 rng(seed);
    std::normal_distribution<double> draw;
    State state{Vector::Zero(model.nq), Vector::Zero(model.nv)};
    for (double& x : state.q) x = 0.4 * draw(rng);
    for (double& x : state.qd) x = 0.5 * draw(rng);
    normalise_quaternions(coordinates_of(model), state.q);
    const double height = ground.lowest(model, state.q).depth + 0.1;
    if (scene.base == Base::floating) state.q[2] += height;
    return state;
  }
};

/// What floats has springs and dampers about the start in its joints: it falls, lands and comes to
/// rest. An arm falls freely.
Vector hold(const Subject& subject, const State& start, const State& now) {
  if (subject.scene.base == Base::fixed) return Vector::Zero(subject.model.nv);
  Vector tau = -1.0 * now.qd;
  const Eigen::Index joints = subject.model.nv - 6;
  tau.tail(joints) -= 60 * (now.q.tail(joints) - start.q.tail(joints));
  tau.head<6>().setZero();
  return tau;
}

Subject make_quadruped() {
  std::vector<SceneTouch> touches = shapes_on("base", 0.15);
  for (const char* leg : {"LF", "RF", "LH", "RH"}) {
    touches.push_back({std::string(leg) + "_FOOT", {{0, 0, 0.02}}, 0.03, {}});
    touches.push_back({std::string(leg) + "_THIGH", {{0, 0, -0.3}, {0, 0, 0}}, 0.05, {0, 0, 1}});
  }
  return Subject::make(read_robot_of("tests/data/published/anymal_c"),
                       "base: floating\nname: anymal\nsnap_angles: 1e-9\n", touches);
}

/// An arm on a table that reaches down to the ground.
Subject make_arm() {
  std::vector<SceneTouch> touches;
  for (const char* link : {"link3", "link4", "link5", "link6"}) {
    for (const SceneTouch& shape : shapes_on(link, 0.05)) touches.push_back(shape);
  }
  return Subject::make(read_robot_of("robots/puma560/puma560"), "base: fixed\nname: arm\n",
                       touches);
}

/// Runs both steps, each from the interpreter's state, and calls `visit(before, by_code, report,
/// by_interpreter)` for each.
template <class Visit>
void fall(const Subject& subject, EmittedStep& emitted, std::uint64_t seed, const Visit& visit) {
  const State start = subject.above_ground(seed);
  State state = start;
  GroundAccount account;
  for (int i = 0; i < 600; ++i) {
    SCOPED_TRACE(fmt::format("seed {}, step {}", seed, i));
    const State before = state;
    const Vector tau = hold(subject, start, before);
    State by_code = before;
    const Report report = emitted.step(kFriction, kStep, tau, by_code);
    subject.step(kFriction, kStep, tau, state, account);
    visit(before, tau, by_code, report, state);
  }
}

double largest(const Vector& v) {
  return v.lpNorm<Eigen::Infinity>();
}

/// Both solve to 1e-12 of the largest speed up to eight contacts, and small inertias at the end of
/// a leg enlarge what they miss; 2e-13 was measured. Coordinates move by that for one step.
TEST(GroundStep, AgreesWithTheInterpreter) {
  for (const Subject& subject : {make_quadruped(), make_arm()}) {
    EmittedStep emitted(subject.robot, subject.scene);
    int pressed = 0;
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
      fall(subject, emitted, seed,
           [&](auto&, auto&, const State& by_code, const Report& report, const State& state) {
             EXPECT_EQ(report.converged, 1);
             pressed += report.contacts;
             const double q = largest(by_code.q - state.q), qd = largest(by_code.qd - state.qd);
             EXPECT_LT(q, 1e-12 * (1 + largest(state.q)));
             EXPECT_LT(qd, 1e-11 * (1 + largest(state.qd)));
           });
    }
    EXPECT_GT(pressed, 40);
  }
}

// The momentum that a step changes beside flight is the impulse that it reports; kinetic energy and
// height never make more than there was.
TEST(GroundStep, KeepsMomentumAndMakesNoEnergy) {
  const Subject subject = make_quadruped();
  EmittedStep emitted(subject.robot, subject.scene);
  double deepest = 0;
  fall(subject, emitted, 5,
       [&](const State& before, const Vector& tau, const State& by_code, const Report& report,
           auto&) {
         const State flown = subject.fly(before, kStep, tau);
         const Vector change = by_code.qd - flown.qd;
         const Vector3 gained = momentum(subject.model, {flown.q, change}).head<3>();
         const Vector3 impulse(report.impulse[0], report.impulse[1], report.impulse[2]);
         EXPECT_LT((gained - impulse).norm(), 1e-12 * (1 + impulse.norm()));
         EXPECT_GE(impulse.z(), 0);
         EXPECT_LE(impulse.head<2>().norm(), kFriction * impulse.z() + 1e-12);
         const double most = std::max(mechanical_energy(subject.model, before),
                                      mechanical_energy(subject.model, flown));
         EXPECT_LE(mechanical_energy(subject.model, by_code), most + 1e-12 * (1 + std::abs(most)));
         deepest = std::max(deepest, subject.ground.lowest(subject.model, by_code.q).depth);
       });
  EXPECT_LT(deepest, 1e-3);
}

// Only the direction of a quaternion counts, in flight and where impulses push out.
TEST(GroundStep, TakesQuaternionsOfAnyLength) {
  const Subject subject = make_quadruped();
  EmittedStep of_unit(subject.robot, subject.scene);
  EmittedStep of_two(subject.robot, subject.scene);
  fall(subject, of_unit, 3,
       [&](const State& before, const Vector& tau, const State& by_code, auto&, auto&) {
         State longer = before;
         longer.q.segment<4>(3) *= 2;
         of_two.step(kFriction, kStep, tau, longer);
         EXPECT_LT(largest(longer.q - by_code.q), 1e-12 * (1 + largest(by_code.q)));
         EXPECT_LT(largest(longer.qd - by_code.qd), 1e-10 * (1 + largest(by_code.qd)));
       });
}

TEST(GroundStep, HasTheSameBitsInC) {
  Subject subject = make_quadruped();
  EmittedStep in_cpp(subject.robot, subject.scene);
  subject.scene.language = Language::c;
  EmittedStep in_c(subject.robot, subject.scene);
  fall(subject, in_cpp, 1,
       [&](const State& before, const Vector& tau, const State& by_code, const Report& report,
           auto&) {
         State by_c = before;
         const Report of_c = in_c.step(kFriction, kStep, tau, by_c);
         EXPECT_EQ(by_c.q, by_code.q);
         EXPECT_EQ(by_c.qd, by_code.qd);
         EXPECT_EQ(of_c.contacts, report.contacts);
         EXPECT_EQ(of_c.miss, report.miss);
       });
}

// A thousand kilometres away a place has ten digits less, and velocities lose nothing.
TEST(GroundStep, DoesNotHangOnThePlace) {
  const Subject subject = make_quadruped();
  EmittedStep here(subject.robot, subject.scene);
  EmittedStep there(subject.robot, subject.scene);
  fall(subject, here, 2,
       [&](const State& before, const Vector& tau, const State& by_code, auto&, auto&) {
         State moved = before;
         moved.q[0] += 0x1p20;
         there.step(kFriction, kStep, tau, moved);
         EXPECT_LT(largest(moved.qd - by_code.qd), 1e-9 * (1 + largest(by_code.qd)));
       });
}

/// A body of 50 kg on a foot of 0.6 kg, 0.05 m before the ankle.
constexpr const char* kStanding = R"(<robot name="standing">
<link name="foot">
  <inertial><mass value="0.6"/><inertia ixx="1e-3" iyy="1e-3" izz="1e-3" ixy="0" ixz="0" iyz="0"/>
  </inertial>
</link>
<link name="body">
  <inertial><origin xyz="0.05 0 0.9"/><mass value="50"/>
    <inertia ixx="4" iyy="4" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>
</link>
<joint name="ankle" type="revolute"><parent link="foot"/><child link="body"/>
  <origin xyz="0 0 0.06"/><axis xyz="0 1 0"/><limit lower="-1" upper="1" effort="99" velocity="9"/>
</joint></robot>)";

/// The largest error of the ground's force, by the weight, in steps of `dt` of a robot that should
/// stand still: the ankle's motor carries the body, the ground the foot.
double error_of_standing(const Subject& subject, EmittedStep& emitted, double dt) {
  State by_code{Vector::Zero(subject.model.nq), Vector::Zero(subject.model.nv)};
  by_code.q[6] = 1;
  State state = by_code;
  Vector tau = Vector::Zero(subject.model.nv);
  tau[6] = -0.05 * 50 * 9.81;
  GroundAccount account;
  double worst = 0;
  for (int i = 0; i < 10; ++i) {
    const Report report = emitted.step(kFriction, dt, tau, by_code);
    subject.step(kFriction, dt, tau, state, account);
    worst = std::max(worst, std::abs(report.impulse[2] / (50.6 * 9.81 * dt) - 1));
    EXPECT_LT(std::abs(by_code.q[4]), 1e-6) << "step " << i;
    EXPECT_LT(largest(by_code.qd - state.qd), 1e-11);
  }
  return worst;
}

// In a flight the motor turns the foot by 0.025 rad in a step of 1 ms, with its heel up: what
// stands there is pushed as much as its toes. That the foot turns at all is an error of the step,
// which goes with its square.
TEST(GroundStep, LeavesALightFootOnTheGround) {
  Diagnostics diagnostics;
  const SceneTouch sole{
      "foot", {{-0.08, -0.05, 0}, {-0.08, 0.05, 0}, {0.18, -0.05, 0}, {0.18, 0.05, 0}}, 0, {}};
  const Subject subject = Subject::make(*parse_urdf(kStanding, "standing.urdf", diagnostics),
                                        "base: floating\n", {sole});
  EmittedStep emitted(subject.robot, subject.scene);
  const double coarse = error_of_standing(subject, emitted, 1e-3);
  const double fine = error_of_standing(subject, emitted, 2.5e-4);
  EXPECT_LT(coarse, 0.1);
  EXPECT_LT(fine, coarse / 10);
}

}  // namespace
}  // namespace treeline
