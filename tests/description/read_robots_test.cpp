// Would catch: robots of a scene that are read from another folder, stand elsewhere or float
// unasked; faults in the list, or in the URDF of one robot, that are told without place or remedy;
// names of one robot that reach another's links.
#include "description/read_robots.hpp"

#include "../own_folder.hpp"
#include "description/read_robot_text.hpp"
#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"
#include "diagnosed.hpp"

namespace treeline {
namespace {

const std::string kArm = R"(<robot name="arm">
  <link name="base"/>
  <link name="upper"><inertial><mass value="2"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <link name="lower"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <joint name="shoulder" type="continuous"><parent link="base"/><child link="upper"/><axis xyz="0 0 1"/></joint>
  <joint name="elbow" type="continuous"><parent link="upper"/><child link="lower"/>
    <origin xyz="0.5 0 0"/><axis xyz="0 1 0"/><mimic joint="shoulder" multiplier="2"/></joint>
</robot>)";
const std::string kBox = R"(<robot name="box">
  <link name="box"><inertial><mass value="2"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>
    <visual><geometry><mesh filename="box.stl"/></geometry></visual></link>
</robot>)";
const std::string kPair = R"(robots:
  - {name: left, urdf: arm.urdf}
  - {name: right, urdf: arm.urdf, pose: {xyz: [1, 2, 0], rpy: [0, 0, 3]}}
  - {name: box, urdf: parts/box.urdf}
)";

class ReadRobots : public test::OwnFolder {
 protected:
  ReadRobots() {
    write("arm.urdf", kArm);
    std::filesystem::create_directories(root_ / "parts");
    write("parts/box.urdf", kBox);
  }
  [[nodiscard]] std::string scene() const { return (root_ / "scene.yaml").string(); }
  std::optional<SceneRobots> read(const std::string& text) {
    return read_robots(text, scene(), diagnostics_);
  }
  /// The line and element of a fault in the list.
  void expect_fault(const std::string& text, const Expected& expected) {
    diagnostics_ = {};
    EXPECT_FALSE(read(text));
    expect_diagnosed(diagnostics_, scene(), expected);
  }
  Diagnostics diagnostics_;
};

TEST_F(ReadRobots, ReadsEverySetting) {
  const auto found = read(kPair);
  ASSERT_TRUE(found) << to_string(diagnostics_);
  ASSERT_EQ(found->robots.size(), 3U);
  EXPECT_EQ(found->robots[1].name, "right");
  EXPECT_EQ(found->robots[1].pose.xyz, (std::array{1.0, 2.0, 0.0}));
  EXPECT_EQ(found->robots[1].pose.rpy, (std::array{0.0, 0.0, 3.0}));
  EXPECT_EQ(found->robots[1].base, Base::fixed);
  EXPECT_EQ(found->robots[2].base, Base::floating);  // nothing of it moves otherwise
  expect_diagnosed(diagnostics_, scene(),
                   {Severity::note, 4, "robots[2]", "which floats", "base: fixed"});
  // A file that two robots share is read once.
  ASSERT_EQ(found->files.size(), 2U);
  EXPECT_EQ(found->files[1].name, "parts/box.urdf");
  EXPECT_EQ(found->files[1].text, kBox);
  EXPECT_EQ(found->file_of_robot, (std::vector<std::size_t>{0, 0, 1}));
}

TEST_F(ReadRobots, JoinsThemAtTheWorld) {
  const auto found = read(kPair);
  ASSERT_TRUE(found);
  const Robot joined = join_robots(found->robots, scene());
  EXPECT_EQ(joined.name, "left_right_box");
  ASSERT_EQ(joined.links.size(), 8U);
  EXPECT_EQ(joined.links[0].name, "world");
  EXPECT_EQ(joined.links[5].name, "right/upper");
  ASSERT_EQ(joined.joints.size(), 7U);
  const Joint& base = joined.joints[3];
  EXPECT_EQ(base.name, "right");
  EXPECT_EQ(base.type, JointType::fixed);
  EXPECT_EQ(base.parent, joined.root);
  EXPECT_EQ(joined.links[static_cast<std::size_t>(base.child)].name, "right/base");
  EXPECT_EQ(base.origin.xyz, (std::array{1.0, 2.0, 0.0}));
  const Joint& elbow = joined.joints[5];
  EXPECT_EQ(elbow.name, "right/elbow");
  ASSERT_TRUE(elbow.mimic);
  EXPECT_EQ(joined.joints[static_cast<std::size_t>(elbow.mimic->joint)].name, "right/shoulder");
  EXPECT_EQ(joined.joints[6].type, JointType::floating);
  EXPECT_EQ(file_of(joined, "box/box"), (root_ / "parts/box.urdf").string());
  EXPECT_EQ(file_of(joined, "world"), scene());
}

// What is drawn is the same robot: the one text of all gives the tree that `join_robots` makes.
TEST_F(ReadRobots, OneTextOfAllIsTheSameTree) {
  const auto found = read(kPair);
  ASSERT_TRUE(found);
  const Robot joined = join_robots(found->robots, scene());
  const std::string text = print_joined_urdf(*found);
  const auto again = parse_urdf(text, "joined.urdf", diagnostics_);
  ASSERT_TRUE(again) << to_string(diagnostics_) << text;
  ASSERT_EQ(again->links.size(), joined.links.size());
  ASSERT_EQ(again->joints.size(), joined.joints.size());
  for (const Joint& joint : joined.joints) {
    const auto same = std::find_if(again->joints.begin(), again->joints.end(),
                                   [&](const Joint& other) { return other.name == joint.name; });
    ASSERT_NE(same, again->joints.end()) << joint.name;
    EXPECT_EQ(same->type, joint.type);
    EXPECT_EQ(same->origin.xyz, joint.origin.xyz);
    EXPECT_EQ(same->origin.rpy, joint.origin.rpy);
    EXPECT_EQ(again->links[static_cast<std::size_t>(same->child)].name,
              joined.links[static_cast<std::size_t>(joint.child)].name);
    EXPECT_EQ(same->mimic.has_value(), joint.mimic.has_value());
  }
  EXPECT_EQ(again->links.front().name, "world");
  EXPECT_NE(text.find("filename=\"box/box.stl\""), std::string::npos);
}

TEST_F(ReadRobots, TellsFaultsOfTheList) {
  expect_fault("robots: []", {Severity::error, 1, "robots", "no robot is listed", "write {name"});
  expect_fault("robots: {left: arm.urdf}",
               {Severity::error, 1, "robots", "a list is expected", ""});
  expect_fault("robots: [{urdf: arm.urdf}]",
               {Severity::error, 1, "robots[0]", "\"name\" is missing", "write {name: left"});
  expect_fault("robots: [{name: left}]",
               {Severity::error, 1, "robots[0]", "\"urdf\" is missing", "write {name: left"});
  expect_fault("robots: [{name: a b, urdf: arm.urdf}]",
               {Severity::error, 1, "robots[0]/name", "cannot be a name", "write a_b"});
  expect_fault("robots: [{name: world, urdf: arm.urdf}]",
               {Severity::error, 1, "robots[0]/name", "all robots stand in", "another name"});
  expect_fault("robots:\n- {name: arm, urdf: arm.urdf}\n- {name: arm, urdf: arm.urdf}",
               {Severity::error, 3, "robots[1]/name", "already taken", "a name of its own"});
  expect_fault("robots: [{name: a, urdf: '-'}]",
               {Severity::error, 1, "robots[0]/urdf", "standard input", "relative"});
  expect_fault("robots: [{name: a, urdf: arm.urdf, bsae: fixed}]",
               {Severity::error, 1, "robots[0]/bsae", "unknown", "base"});
  expect_fault("robots: [{name: a, urdf: arm.urdf, base: floating, pose: {xyz: [0, 0, 1]}}]",
               {Severity::error, 1, "robots[0]/pose", "has its pose in q", "leave out pose"});
}

// Also that a short list of one large file does not fill the memory.
TEST_F(ReadRobots, RefusesMoreLinksThanARobotMayHave) {
  std::string scene = "robots:\n";
  for (int i = 0; i < 2000; ++i) {
    scene += "- {name: arm" + std::to_string(i) + ", urdf: arm.urdf}\n";
  }
  expect_fault(scene, {Severity::error, 1367, "robots[1365]", "4098 links, more than 4095",
                       "list fewer robots"});
}

TEST_F(ReadRobots, TellsFaultsOfOneRobotsFile) {
  write("bad.urdf", "<robot name='bad'>\n<link name='a'/>\n<link name='a'/></robot>");
  EXPECT_FALSE(read("robots: [{name: a, urdf: arm.urdf}, {name: b, urdf: bad.urdf}]"));
  expect_diagnosed(diagnostics_, (root_ / "bad.urdf").string(),
                   {Severity::error, 3, "robot/link[a]", "of this name", "a name of its own"});
  expect_diagnosed(diagnostics_, scene(),
                   {Severity::error, 1, "robots[1]/urdf", "cannot be read", "folder of the scene"});
  expect_fault("robots: [{name: a, urdf: none.urdf}]",
               {Severity::error, 1, "robots[0]/urdf", "cannot be read", "folder of the scene"});
}

TEST_F(ReadRobots, ScenesReachEveryRobotByItsName) {
  const auto found = read(kPair);
  ASSERT_TRUE(found);
  const Robot joined = join_robots(found->robots, scene());
  const auto scene_of = [&](const std::string& rest) {
    diagnostics_ = {};
    return parse_scene(kPair + rest, "s.yaml", joined, diagnostics_);
  };
  const auto good = scene_of(
      "operational_points: [{name: hand, link: right/lower}]\nlocked: {left/shoulder: 0.5}\n");
  ASSERT_TRUE(good) << to_string(diagnostics_);
  EXPECT_EQ(good->name, "left_right_box");
  EXPECT_EQ(good->base, Base::fixed);
  EXPECT_FALSE(scene_of("operational_points: [{name: hand, link: lower}]\n"));
  expect_diagnosed(
      diagnostics_, "s.yaml",
      {Severity::error, 5, "operational_points[0]/link", "no link \"lower\"", "lower"});
  EXPECT_FALSE(scene_of("base: floating\n"));
  expect_diagnosed(diagnostics_, "s.yaml",
                   {Severity::error, 5, "base", "a base of its own", "list robots"});
}

TEST_F(ReadRobots, AUrdfBesideAListOfRobotsIsRefused) {
  const auto arm = parse_urdf(kArm, "arm.urdf", diagnostics_);
  ASSERT_TRUE(arm);
  EXPECT_FALSE(parse_scene(kPair, "s.yaml", *arm, diagnostics_));
  expect_diagnosed(diagnostics_, "s.yaml",
                   {Severity::error, 2, "robots", "lists its robots itself", "the scene alone"});
}

TEST(SceneText, IsToldFromUrdf) {
  EXPECT_TRUE(is_scene_text("# a scene\nname: pair\n"));
  EXPECT_FALSE(is_scene_text(kArm));
  EXPECT_FALSE(is_scene_text("\xef\xbb\xbf<robot/>"));
  EXPECT_FALSE(is_scene_text(""));
  EXPECT_FALSE(is_scene_text("name: [1"));
  EXPECT_TRUE(lists_robots(kPair));
  EXPECT_FALSE(lists_robots("name: pair\n"));
  EXPECT_FALSE(lists_robots(kArm));
}

}  // namespace
}  // namespace treeline
