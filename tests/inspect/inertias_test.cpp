// Would catch: an impossible inertia without effect on the motion that is called harmful, or one
// with an effect that is not reported; a patch that changes other bytes than the moments, or that
// cannot be applied.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <random>

#include "description/read_urdf.hpp"
#include "inspect/inspect_robot.hpp"
#include "interpreter/instances.hpp"
#include "oracle/model_from_robot.hpp"
#include "sample.hpp"

namespace treeline {
namespace {

std::string link(const std::string& name, const std::string& moments, const std::string& mass = "1",
                 const std::string& center = "0.1 0.2 0.3") {
  return "<link name=\"" + name + "\"><inertial><origin xyz=\"" + center + "\"/><mass value=\"" +
         mass + "\"/>\n<inertia " + moments + "/></inertial></link>\n";
}

std::string joint(const std::string& name, const std::string& parent, const std::string& child,
                  const std::string& axis, const std::string& type = "continuous") {
  return "<joint name=\"" + name + "\" type=\"" + type + "\"><parent link=\"" + parent +
         "\"/><child link=\"" + child + "\"/><origin xyz=\"0.1 0 0.2\"/><axis xyz=\"" + axis +
         "\"/></joint>\n";
}

const std::string kSound = "ixx=\"0.1\" ixy=\"0\" ixz=\"0\" iyy=\"0.1\" iyz=\"0\" izz=\"0.1\"";
/// Sigma = diag(0.2, 0.2, -0.1), and permuted for the other axes.
const std::string kBadZ = "ixx=\"0.1\" ixy=\"0\" ixz=\"0\" iyy=\"0.1\" iyz=\"0\" izz=\"0.4\"";
const std::string kBadX = "ixx=\"0.4\" ixy=\"0\" ixz=\"0\" iyy=\"0.1\" iyz=\"0\" izz=\"0.1\"";

std::string robot(const std::string& parts) {
  return "<robot name=\"r\">\n" + parts + "</robot>\n";
}

/// Names of the links whose impossible inertia affects the motion.
std::string felt(const std::string& parts, Base base = Base::fixed) {
  Diagnostics diagnostics;
  const auto read = parse_urdf(robot(parts), "felt.urdf", diagnostics);
  EXPECT_TRUE(read);
  Scene scene;
  scene.base = base;
  std::string names;
  for (const LinkReport& l : inspect_robot(*read, scene).links) {
    if (l.felt) names += l.name + " ";
    EXPECT_TRUE(!l.felt || l.unphysical) << l.name;
  }
  return names;
}

TEST(FeltInertia, OneJointFeelsOnlyTheMomentAboutIt) {
  // About z the moment is that of a possible body, whatever the others are.
  EXPECT_EQ(felt(link("a", kSound) + link("b", kBadZ) + joint("j", "a", "b", "0 0 1")), "");
  EXPECT_EQ(felt(link("a", kSound) + link("b", kBadX) + joint("j", "a", "b", "0 0 1")), "");
  // A negative moment about the axis itself affects the motion.
  const std::string negative = "ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" izz=\"-0.5\"";
  EXPECT_EQ(felt(link("a", kSound) + link("b", negative) + joint("j", "a", "b", "0 0 1")), "b ");
}

TEST(FeltInertia, FreeBodyFeelsAll) {
  EXPECT_EQ(felt(link("a", kBadZ), Base::floating), "a ");
  EXPECT_EQ(
      felt(link("a", kBadX) + link("b", kSound) + joint("j", "a", "b", "0 0 1"), Base::floating),
      "a ");
}

TEST(FeltInertia, RestingAndSlidingLinksFeelNone) {
  EXPECT_EQ(felt(link("a", kBadZ) + link("b", kSound) + joint("j", "a", "b", "0 0 1")), "");
  EXPECT_EQ(felt(link("a", kSound) + link("b", kBadZ) + joint("j", "a", "b", "1 0 0", "prismatic")),
            "");
}

TEST(FeltInertia, HiddenBehindAFixedJoint) {
  const std::string large = "ixx=\"5\" ixy=\"0\" ixz=\"0\" iyy=\"5\" iyz=\"0\" izz=\"5\"";
  EXPECT_EQ(felt(link("a", large) + link("b", kBadZ) + joint("j", "a", "b", "0 0 1", "fixed"),
                 Base::floating),
            "");
}

TEST(FeltInertia, WhatRegroupingMovesToABodyThatCanBearIt) {
  const std::string large = "ixx=\"5\" ixy=\"0\" ixz=\"0\" iyy=\"5\" iyz=\"0\" izz=\"5\"";
  // Negative along its own joint axis: the parent absorbs this part.
  EXPECT_EQ(
      felt(link("a", large) + link("b", kBadZ) + joint("j", "a", "b", "0 0 1"), Base::floating),
      "");
  // Negative across it: no neighbour can absorb that.
  EXPECT_EQ(
      felt(link("a", large) + link("b", kBadX) + joint("j", "a", "b", "0 0 1"), Base::floating),
      "b ");
}

TEST(FeltInertia, SampleOfInspect) {
  const Report report = inspect_sample();
  for (const LinkReport& l : report.links) {
    EXPECT_FALSE(l.felt) << l.name << " turns about one axis only";
    EXPECT_EQ(l.nearest.has_value(), l.unphysical.has_value()) << l.name;
  }
}

/// Draws the numbers of a chain of three links, some with impossible inertias.
std::string draw_chain(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto moments = [&] {
    const bool bad = random() % 2 == 0;
    std::string text;
    for (const char* name : {"ixx", "iyy", "izz"}) {
      const double value = bad ? 0.5 * unit(random) + 0.3 : 0.5 + 0.1 * unit(random);
      text += std::string(name) + "=\"" + std::to_string(value) + "\" ";
    }
    return text + "ixy=\"0\" ixz=\"0\" iyz=\"0\"";
  };
  const auto axis = [&] { return random() % 2 == 0 ? "0 0 1" : "0 1 0"; };
  const auto type = [&] { return random() % 4 == 0 ? "prismatic" : "continuous"; };
  return link("a", moments(), "1", "0.1 0 0") + link("b", moments(), "0.5", "0 0.1 0") +
         link("c", moments(), "0.2", "0 0 0.1") + joint("j", "a", "b", axis(), type()) +
         joint("k", "b", "c", axis(), type());
}

// The mass matrix as an independent criterion: what moves like possible bodies never has a negative
// kinetic energy.
TEST(FeltInertia, HiddenOnesLeaveTheMassMatrixPositive) {
  std::mt19937_64 random(11);
  int hidden = 0, negative = 0;
  for (int k = 0; k < 200; ++k) {
    Diagnostics diagnostics;
    const auto read = parse_urdf(robot(draw_chain(random)), "chain.urdf", diagnostics);
    ASSERT_TRUE(read);
    Scene scene;
    scene.base = k % 2 == 0 ? Base::fixed : Base::floating;
    bool faulty = false, is_felt = false;
    for (const LinkReport& l : inspect_robot(*read, scene).links) {
      faulty = faulty || l.nearest;
      is_felt = is_felt || l.felt;
    }
    const auto model = model_from_robot<double>(*read, scene);
    double least = 1;
    for (int i = 0; i < 50; ++i) {
      interpreter::Vector<double> q = interpreter::Vector<double>::Random(model.nq);
      if (scene.base == Base::floating) q.segment<4>(3).normalize();
      const Eigen::MatrixXd M = interpreter::mass_matrix<double>(model, q);
      least = std::min(least, Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(M).eigenvalues()[0]);
    }
    // As far below zero as the tolerance of figures permits.
    EXPECT_TRUE(is_felt || least >= -1e-3) << "chain " << k << ": eigenvalue " << least;
    hidden += faulty && !is_felt ? 1 : 0;
    negative += least < -1e-3 ? 1 : 0;
  }
  EXPECT_GT(hidden, 10);
  EXPECT_GT(negative, 10);
}

struct Repaired {
  std::string before, after, patch;
};

Repaired repair(const std::string& text, Base base = Base::floating) {
  Diagnostics diagnostics;
  const auto read = parse_urdf(text, "felt.urdf", diagnostics);
  EXPECT_TRUE(read);
  Scene scene;
  scene.base = base;
  const auto repairs = list_repairs(*read, inspect_robot(*read, scene));
  const auto edits = edit_inertias(*read, text, repairs);
  return {text, apply_edits(text, edits), print_patch("felt.urdf", text, edits)};
}

TEST(Repair, ChangesTheMomentsAndNothingElse) {
  const std::string odd =
      "<!-- ixx=\"0.1\" -->\r\n<robot name='r'>\t<link name='a'><inertial>\n<mass value='1'/>\r\n"
      "<inertia izz='0.4'  ixx=\n'0.1' iyy=\"0.1\" ixy='0' ixz = '0' iyz='0' iyx='0'/>"
      "</inertial></link></robot>";
  const Repaired repaired = repair(odd);
  EXPECT_EQ(repaired.after,
            "<!-- ixx=\"0.1\" -->\r\n<robot name='r'>\t<link name='a'><inertial>\n<mass "
            "value='1'/>\r\n<inertia izz='0.4'  ixx=\n'0.2' iyy=\"0.2\" ixy='0' ixz = '0' iyz='0' "
            "iyx='0'/></inertial></link></robot>");
  EXPECT_EQ(
      repaired.patch,
      "--- felt.urdf\n+++ felt.urdf\n@@ -2,4 +2,4 @@\n <robot name='r'>\t<link "
      "name='a'><inertial>\n <mass value='1'/>\r\n <inertia izz='0.4'  ixx=\n-'0.1' "
      "iyy=\"0.1\" ixy='0' ixz = '0' iyz='0' iyx='0'/></inertial></link></robot>\n\\ No newline "
      "at end of file\n+'0.2' iyy=\"0.2\" ixy='0' ixz = '0' iyz='0' "
      "iyx='0'/></inertial></link></robot>\n\\ No newline at end of file\n");
}

TEST(Repair, LeavesTheRestOfTheRobot) {
  const std::string text = robot(link("a", kBadX) + link("b", kSound) + link("c", kBadX) +
                                 joint("j", "a", "b", "0 0 1") + joint("k", "b", "c", "0 1 0"));
  const Repaired repaired = repair(text);
  Diagnostics diagnostics;
  const auto before = parse_urdf(text, "felt.urdf", diagnostics);
  const auto after = parse_urdf(repaired.after, "felt.urdf", diagnostics);
  ASSERT_TRUE(before && after);
  for (std::size_t i = 0; i < before->links.size(); ++i) {
    EXPECT_EQ(before->links[i].name, after->links[i].name);
    EXPECT_EQ(before->links[i].inertial->mass, after->links[i].inertial->mass);
    EXPECT_EQ(before->links[i].inertial->origin.xyz, after->links[i].inertial->origin.xyz);
  }
  Scene scene;
  scene.base = Base::floating;
  for (const LinkReport& l : inspect_robot(*after, scene).links) EXPECT_FALSE(l.felt) << l.name;
}

TEST(Repair, NothingToDo) {
  const Repaired repaired = repair(robot(link("a", kSound)));
  EXPECT_EQ(repaired.before, repaired.after);
  EXPECT_EQ(repaired.patch, "");
}

// Separate hunks, with lines before and after them.
TEST(Repair, PatchOfSeveralPlaces) {
  std::string filler;
  for (int i = 0; i < 20; ++i) filler += "<material name=\"m\"/>\n";
  const std::string bad = link("a", kBadZ);
  Diagnostics diagnostics;
  const std::string text = robot(bad + filler + link("b", kBadX) + joint("j", "a", "b", "0 0 1"));
  const auto read = parse_urdf(text, "f", diagnostics);
  ASSERT_TRUE(read);
  Inertial sound = *read->links[0].inertial;
  sound.ixx = 0.25;
  const auto edits = edit_inertias(*read, text, {{1, sound}, {0, sound}});
  const std::string patch = print_patch("f", text, edits);
  EXPECT_NE(patch.find("@@ -1,6 +1,6 @@\n"), std::string::npos) << patch;
  EXPECT_NE(patch.find("@@ -22,6 +22,6 @@\n"), std::string::npos) << patch;
  EXPECT_NE(patch.find("-<inertia ixx=\"0.1\""), std::string::npos) << patch;
  EXPECT_NE(patch.find("+<inertia ixx=\"0.25\""), std::string::npos) << patch;
}

TEST(PrintedInertias, TextAndJson) {
  Diagnostics diagnostics;
  const auto read = parse_urdf(robot(link("a", kBadZ) +
                                     link("rod",
                                          "ixx=\"0\" ixy=\"0\" ixz=\"0\" "
                                          "iyy=\"1\" iyz=\"0\" izz=\"1\"") +
                                     joint("j", "a", "rod", "0 0 1")),
                               "felt.urdf", diagnostics);
  Scene scene;
  scene.base = Base::floating;
  const Report report = inspect_robot(read.value(), scene);
  const std::string text = print_text(report);
  for (const char* part : {"the motion feels it", "--repair FILE", "a rod", "Frobenius"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
  }
  const std::string json = print_json(report);
  for (const char* part : {"\"felt\": true", "\"nearest\": {", "\"flat\": \"a rod\""}) {
    EXPECT_NE(json.find(part), std::string::npos) << part;
  }
}

}  // namespace
}  // namespace treeline
