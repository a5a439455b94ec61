// Would catch: a robot with a warning, a wrong mass, an impossible inertia, or a scene that does
// not fit.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "load_robot.hpp"

namespace treeline {
namespace {

struct Facts {
  const char* name;
  int velocities;     ///< degrees of freedom with a fixed base
  double total_mass;  ///< kg, of the README
  std::vector<const char*> scenes;
};

void PrintTo(const Facts& facts, std::ostream* out) {
  *out << facts.name;
}

class EveryRobot : public ::testing::TestWithParam<Facts> {};

TEST_P(EveryRobot, HasTheFreedomsAndTheMassOfItsReadme) {
  const Robot robot = load_robot(GetParam().name);
  EXPECT_EQ(robot.name, GetParam().name);
  double mass = 0;
  for (const Link& link : robot.links) mass += link.inertial ? link.inertial->mass : 0;
  // Decimal figures with at most four places, at most 27 of them, so only the sum is rounded.
  EXPECT_NEAR(mass, GetParam().total_mass, 1e-12);
  EXPECT_EQ(model_from_robot<double>(robot, Scene{}).nv, GetParam().velocities);
}

TEST_P(EveryRobot, HasInertiasThatBodiesHave) {
  for (const Link& link : load_robot(GetParam().name).links) {
    if (!link.inertial) continue;
    const Inertial& i = *link.inertial;
    Eigen::Matrix3d inertia;
    inertia << i.ixx, i.ixy, i.ixz, i.ixy, i.iyy, i.iyz, i.ixz, i.iyz, i.izz;
    const Eigen::Vector3d moments =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(inertia).eigenvalues();
    EXPECT_GT(i.mass, 0) << link.name;
    EXPECT_GT(moments[0], 0) << link.name;
    EXPECT_LE(moments[2], moments[0] + moments[1]) << link.name;
  }
}

TEST_P(EveryRobot, HasLimitsOnEveryMovingJoint) {
  for (const Joint& joint : load_robot(GetParam().name).joints) {
    if (joint.type == JointType::fixed) continue;
    ASSERT_TRUE(joint.limits) << joint.name;
    EXPECT_LT(joint.limits->lower, joint.limits->upper) << joint.name;
    EXPECT_GT(joint.limits->effort, 0) << joint.name;
    EXPECT_GT(joint.limits->velocity, 0) << joint.name;
  }
}

TEST_P(EveryRobot, HasScenesThatFitIt) {
  const Robot robot = load_robot(GetParam().name);
  for (const char* file : GetParam().scenes) {
    const Scene scene = load_scene(GetParam().name, file, robot);
    EXPECT_EQ(scene.name.rfind(GetParam().name, 0), 0U) << "names its robot first";
    EXPECT_FALSE(scene.functions.empty()) << file;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Robots, EveryRobot,
    ::testing::Values(Facts{"puma560",
                            6,
                            13 + 17.4 + 4.8 + 0.82 + 0.34 + 0.09,
                            {"scene.yaml", "scene_float.yaml", "scene_contact.yaml"}},
                      Facts{"samm",
                            9,
                            150 + 13 + 17.4 + 4.8 + 0.82 + 0.34 + 0.09,
                            {"scene.yaml", "scene_base_locked.yaml"}},
                      Facts{"humanoid24", 24, 75, {"scene.yaml", "scene_floating.yaml"}},
                      Facts{"planar3r", 3, 9, {"scene.yaml"}}),
    [](const auto& robot) { return std::string(robot.param.name); });

/// The SAMM's arm is the PUMA. Would catch: a number that is corrected in one file only.
TEST(Samm, CarriesTheSamePuma) {
  const Robot puma = load_robot("puma560");
  const Robot samm = load_robot("samm");
  for (const char* link : {"link1", "link2", "link3", "link4", "link5", "link6"}) {
    const Inertial& a = *find_link(puma, link).inertial;
    const Inertial& b = *find_link(samm, link).inertial;
    EXPECT_EQ(a.mass, b.mass) << link;
    EXPECT_EQ(a.origin.xyz, b.origin.xyz) << link;
    EXPECT_EQ(a.ixx, b.ixx) << link;
    EXPECT_EQ(a.iyy, b.iyy) << link;
    EXPECT_EQ(a.izz, b.izz) << link;
    const Joint& on_puma = find_joint_of(puma, link);
    const Joint& on_samm = find_joint_of(samm, link);
    EXPECT_EQ(on_puma.origin.rpy, on_samm.origin.rpy) << link;
    EXPECT_EQ(on_puma.limits->lower, on_samm.limits->lower) << link;
    EXPECT_EQ(on_puma.limits->upper, on_samm.limits->upper) << link;
    if (std::string(link) != "link1") {
      EXPECT_EQ(on_puma.origin.xyz, on_samm.origin.xyz) << link;
    }
  }
}

}  // namespace
}  // namespace treeline
