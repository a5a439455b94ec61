#include <gtest/gtest.h>

#include <filesystem>

#include "program_test.hpp"

// Would catch: an option that is not heeded, a file that another command writes and this one cannot
// read, and a fault that is not said.
namespace treeline {
namespace {

const std::string kRobots = TREELINE_ROBOTS;

class DrawTest : public test::OwnFolder {
 protected:
  [[nodiscard]] test::Outcome draw(const std::string& arguments) const {
    return test::run_program(root_, "draw " + arguments);
  }

  static std::size_t pictures(const std::string& svg) {
    std::size_t count = 0;
    for (auto at = svg.find("<svg x="); at != std::string::npos; at = svg.find("<svg x=", at + 1))
      ++count;
    return count;
  }

  const std::string planar_ = kRobots + "/planar3r/planar3r.urdf";
};

TEST_F(DrawTest, DrawsTheRobotAtRest) {
  const auto outcome = draw(planar_);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(outcome.out.starts_with("<svg "));
  EXPECT_EQ(pictures(outcome.out), 1U);
  EXPECT_NE(draw(planar_ + " --q 1,0,0").out, outcome.out);
  EXPECT_NE(draw(planar_ + " --azimuth 0").out, outcome.out);
}

TEST_F(DrawTest, DrawsWhatSimulateHasWritten) {
  ASSERT_EQ(
      test::run_program(root_, "simulate " + planar_ + " --seconds 1 --csv swing.csv").exit_code,
      0);
  const auto outcome = draw(planar_ + " --motion swing.csv --pictures 6 --output swing.svg");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  const std::string svg = test::read_file(root_ / "swing.svg");
  EXPECT_EQ(pictures(svg), 6U);
  EXPECT_NE(svg.find(">1 s</text>"), std::string::npos);
  EXPECT_EQ(pictures(draw(planar_ + " --motion swing.csv --times 0,0.5").out), 2U);
}

TEST_F(DrawTest, DrawsThePathOfAPoint) {
  write("motion.csv", "time,q0\n0,0\n1,1\n");
  const std::string scene = kRobots + "/planar3r/scene.yaml";
  const std::string files = planar_ + " " + scene + " --motion motion.csv";
  EXPECT_EQ(draw(files).out.find("stroke-dasharray"), std::string::npos);
  const auto outcome = draw(files + " --path tip");
  EXPECT_NE(outcome.out.find("stroke-dasharray"), std::string::npos) << outcome.err;
  const auto both = draw(files + " --path tip,link3").out;  // of a point, and of a link
  EXPECT_NE(both.find("stroke-dasharray"), both.rfind("stroke-dasharray"));
  const auto wrong = draw(files + " --path tipp");
  EXPECT_EQ(wrong.exit_code, 1);
  EXPECT_NE(wrong.err.find("did you mean"), std::string::npos) << wrong.err;
}

TEST_F(DrawTest, AnimatesAMotion) {
  write("motion.csv", "time,q0\n0,0\n1,1\n2,0\n");
  const std::string files = planar_ + " --motion motion.csv --animate";
  const auto outcome = draw(files + " -o film.svg");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string svg = test::read_file(root_ / "film.svg");
  EXPECT_EQ(pictures(svg), 21U);  // 2 s, ten a second, and the first
  EXPECT_NE(svg.find("2.5 s, 10 frames a second"), std::string::npos);
  EXPECT_EQ(pictures(draw(files + " --times 0,1 --fps 20").out), 21U);
  EXPECT_EQ(pictures(draw(files + " --seconds 1").out), 11U);
  const auto turned = draw(planar_ + " --animate --q 0,0,0 --to 1,0.5,0 --seconds 3");
  EXPECT_EQ(pictures(turned.out), 31U) << turned.err;
  EXPECT_EQ(draw(files).out, svg);
  EXPECT_EQ(draw(planar_ + " --animate").exit_code, 2);
  EXPECT_EQ(draw(planar_ + " --animate --to 1").exit_code, 1);
  EXPECT_EQ(draw(files + " --pictures 3").exit_code, 2);
  EXPECT_EQ(draw(files + " --seconds 600").exit_code, 1);  // 6000 pictures
  EXPECT_NE(draw(files + " --fps 60 --seconds 10 --width 2000").err.find("the animation has"),
            std::string::npos);
}

// A tetrahedron of 1 m, in mm, in a folder of its own, by all kinds of names. Would catch: a mesh
// that is not found or not scaled, a missing one that is not told, or told of each by itself, and a
// link that is not seen where its mesh is missing.
TEST_F(DrawTest, DrawsMeshes) {
  std::filesystem::create_directories(root_ / "arm/meshes");
  write("arm/meshes/a b.obj",
        "v 0 0 0\nv 1000 0 0\nv 0 1000 0\nv 0 0 1000\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  write("arm/meshes/cut.stl", "solid\nfacet\nvertex 0 0 0\n");
  const auto with = [&](const std::string& mesh) {
    write("arm/arm.urdf",
          "<robot name='arm'><link name='base'/><joint name='j' type='continuous'>"
          "<parent link='base'/><child link='a'/></joint><link name='a'>"
          "<inertial><mass value='1'/></inertial><visual><geometry>" +
              mesh +
              "</geometry></visual><collision><geometry><sphere radius='0.1'/>"
              "</geometry></collision></link></robot>");
    return draw("arm/arm.urdf --mesh-folder arm");
  };
  const auto named = [&](const std::string& name) {
    return with("<mesh scale='0.001 0.001 0.001' filename='" + name + "'/>");
  };
  const auto plain = named("meshes/a b.obj");
  EXPECT_EQ(plain.err, "");
  EXPECT_NE(plain.out.find("z\"/>"), std::string::npos);
  EXPECT_EQ(plain.out.find("<circle color"), std::string::npos);
  for (const std::string& name : {std::string("package://arm/meshes/a b.obj"),
                                  "file://" + (root_ / "arm/meshes/a%20b.obj").string(),
                                  (root_ / "arm/meshes/a b.obj").string()}) {
    const auto other = named(name);
    EXPECT_EQ(other.out, plain.out) << name << '\n' << other.err;
  }
  EXPECT_NE(with("<mesh filename='meshes/a b.obj' scale='0.001 0.001 0.002'/>").out, plain.out);
  for (const char* name : {"meshes/cut.stl", "meshes/gone.stl"}) {
    const auto missing = named(name);
    EXPECT_EQ(missing.exit_code, 0);
    EXPECT_TRUE(
        missing.err.starts_with(std::string("warning: ") + name + ": this mesh is not shown: "))
        << missing.err;
    EXPECT_NE(missing.out.find("<circle color"), std::string::npos);  // the sphere stands in
  }
}

TEST_F(DrawTest, SaysWhatIsWrong) {
  const auto few = draw(planar_ + " --q 1,2");
  EXPECT_EQ(few.exit_code, 1);
  EXPECT_NE(few.err.find("2 numbers are given, the robot has 3"), std::string::npos) << few.err;
  EXPECT_EQ(draw(planar_ + " --motion nowhere.csv").exit_code, 1);
  EXPECT_EQ(draw(planar_ + " --times 1").exit_code, 2);
  write("motion.csv", "\xEF\xBB\xBFtime,q0\n0,0\n1,1\n");
  EXPECT_EQ(draw(planar_ + " --motion motion.csv --times 0,1").exit_code, 0);
  EXPECT_EQ(draw(planar_ + " --motion motion.csv --q 0,0,0").exit_code, 2);
  const auto beyond = draw(planar_ + " --motion motion.csv --times 0,5");
  EXPECT_EQ(beyond.exit_code, 1);
  EXPECT_NE(beyond.err.find("5 s is not in the motion, which goes from 0 to 1 s"),
            std::string::npos)
      << beyond.err;
  EXPECT_NE(draw(planar_ + " --close-up link9").err.find("there is no link `link9`"),
            std::string::npos);
  EXPECT_EQ(draw("nowhere.urdf").exit_code, 1);
  EXPECT_EQ(draw(planar_ + " --svg /nowhere/a.svg").exit_code, 1);
}

}  // namespace
}  // namespace treeline
