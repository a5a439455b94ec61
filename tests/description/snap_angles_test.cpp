// Would catch: an angle that is taken for a quarter turn although its author meant it as written,
// is replaced without a message, or is farther off than the scene permits; and snapping that was
// not requested.
#include "description/snap_angles.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"

namespace treeline {
namespace {

const double kPi = std::acos(-1.0);

TEST(RoundedQuarterTurns, AreThoseWrittenWithRoundedOrCutOffDigits) {
  for (const double angle : {1.5708, 1.570796, 1.57079632679, 1.57079633}) {
    EXPECT_EQ(rounded_quarter_turns(angle, kWidestSnap), kPi / 2) << angle;
    EXPECT_EQ(rounded_quarter_turns(-angle, kWidestSnap), -kPi / 2) << angle;
  }
  EXPECT_EQ(rounded_quarter_turns(3.14159, kWidestSnap), kPi);
  EXPECT_EQ(rounded_quarter_turns(3.1416, kWidestSnap), kPi);
  EXPECT_EQ(rounded_quarter_turns(4.712389, kWidestSnap), 3 * kPi / 2);
  EXPECT_EQ(rounded_quarter_turns(6.123e-17, kWidestSnap), 0);
}

TEST(RoundedQuarterTurns, AreNotAnglesOfTheirOwn) {
  for (const double angle : {1.57, 1.571, 1.570795, 1.5707963259, 1.5707, 3.14, 3.1415, 0.785398,
                             1e-11, 0.0, kPi, kPi / 2, 1.570796326794897, -3 * kPi}) {
    EXPECT_EQ(rounded_quarter_turns(angle, kWidestSnap), std::nullopt) << angle;
  }
}

TEST(RoundedQuarterTurns, AreWithinTheTolerance) {
  EXPECT_EQ(rounded_quarter_turns(1.5708, 3e-6), std::nullopt);
  EXPECT_EQ(rounded_quarter_turns(1.5708, 4e-6), kPi / 2);
  EXPECT_EQ(rounded_quarter_turns(1.57079632679, 0), std::nullopt);
}

TEST(RoundedQuarterTurns, HaveNames) {
  EXPECT_EQ(name_quarter_turns(0), "0");
  EXPECT_EQ(name_quarter_turns(-kPi / 2), "-pi/2");
  EXPECT_EQ(name_quarter_turns(3 * kPi / 2), "3 pi/2");
  EXPECT_EQ(name_quarter_turns(-2 * kPi), "-2 pi");
}

constexpr const char* kUrdf = R"(<robot name="arm">
  <link name="base"/>
  <joint name="first" type="continuous">
    <origin rpy="1.5708 0 1.57"/><parent link="base"/><child link="upper"/></joint>
  <link name="upper"><inertial><origin rpy="0 3.14159265 0"/><mass value="1"/>
    <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
  <joint name="second" type="continuous">
    <origin rpy="-1.5708 1.5708 0"/><parent link="upper"/><child link="hand"/></joint>
  <link name="hand"><inertial><mass value="1"/>
    <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
</robot>)";

struct Parsed {
  Robot robot;
  std::optional<Scene> scene;
  Diagnostics diagnostics;
};

Parsed parse(const std::string& scene) {
  Parsed parsed;
  Diagnostics of_urdf;
  parsed.robot = parse_urdf(kUrdf, "arm.urdf", of_urdf).value();
  parsed.scene = parse_scene(scene, "scene.yaml", parsed.robot, parsed.diagnostics);
  return parsed;
}

TEST(SnapAngles, SaysEachValueOnceWithItsPlace) {
  const Parsed parsed = parse(
      "snap_angles: 1e-5\n"
      "operational_points: [{name: tip, link: hand, origin: {rpy: [0, 0, 3.1416]}, rows: [x]}]\n");
  ASSERT_TRUE(parsed.scene);
  const auto& notes = parsed.diagnostics.list();
  ASSERT_EQ(notes.size(), 4U);
  EXPECT_EQ(notes[0].severity, Severity::note);
  EXPECT_EQ(notes[0].file, "arm.urdf");
  EXPECT_EQ(notes[0].line, 5);
  EXPECT_EQ(notes[0].element, "robot/link[upper]/inertial/origin");
  EXPECT_EQ(notes[1].line, 4);
  EXPECT_EQ(notes[1].fault, "the angle 1.5708 is taken as pi/2, 3.7e-06 rad off (and 1 more)");
  EXPECT_NE(notes[1].remedy.find("leave it out"), std::string::npos);
  EXPECT_EQ(notes[3].file, "scene.yaml");
  EXPECT_EQ(notes[3].line, 2);
  EXPECT_EQ(parsed.scene->operational_points[0].origin.rpy[2], kPi);
}

TEST(SnapAngles, TakesExactAnglesOnlyWhereAskedTo) {
  const Robot as_read = parse("").robot;
  const Robot snapped = with_snapped_angles(as_read, 1e-5);
  EXPECT_EQ(snapped.joints[0].origin.rpy, (std::array{kPi / 2, 0.0, 1.57}));
  EXPECT_EQ(snapped.joints[1].origin.rpy, (std::array{-kPi / 2, kPi / 2, 0.0}));
  EXPECT_EQ(snapped.links[1].inertial->origin.rpy[1], kPi);
  EXPECT_EQ(with_snapped_angles(as_read, 0).joints[0].origin.rpy, as_read.joints[0].origin.rpy);
}

TEST(SnapAngles, IsSuggestedOnceWhereNotAskedFor) {
  const Parsed parsed = parse("name: arm\n");
  ASSERT_TRUE(parsed.scene);
  EXPECT_EQ(parsed.scene->snap_angles, 0);
  ASSERT_EQ(parsed.diagnostics.list().size(), 1U);
  const Diagnostic& note = parsed.diagnostics.list()[0];
  EXPECT_EQ(note.severity, Severity::note);
  EXPECT_EQ(note.fault.substr(0, 9), "4 angles ");
  EXPECT_EQ(note.remedy.substr(0, 20), "`snap_angles: 4e-06`");
}

TEST(SnapAngles, RefusesMoreThanRounding) {
  for (const char* scene : {"snap_angles: 1e-3\n", "snap_angles: -1e-6\n", "snap_angles: yes\n"}) {
    const Parsed parsed = parse(scene);
    EXPECT_FALSE(parsed.scene) << scene;
    EXPECT_TRUE(parsed.diagnostics.has_errors());
  }
}

}  // namespace
}  // namespace treeline
