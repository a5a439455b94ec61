#include <gtest/gtest.h>

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
  const auto outcome = draw(planar_ + " --motion swing.csv --pictures 6 --svg swing.svg");
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
  EXPECT_EQ(draw(files).out.find("<polyline"), std::string::npos);
  const auto outcome = draw(files + " --path tip");
  EXPECT_NE(outcome.out.find("<polyline"), std::string::npos) << outcome.err;
  const auto wrong = draw(files + " --path tipp");
  EXPECT_EQ(wrong.exit_code, 1);
  EXPECT_NE(wrong.err.find("did you mean"), std::string::npos) << wrong.err;
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
  EXPECT_EQ(draw("nowhere.urdf").exit_code, 1);
  EXPECT_EQ(draw(planar_ + " --svg /nowhere/a.svg").exit_code, 1);
}

}  // namespace
}  // namespace treeline
