#include <gtest/gtest.h>

#include "../own_folder.hpp"
#include "drawing/recorded_motion.hpp"

// Would catch: a table that is read wrongly or refused without a reason, a column that moves
// another joint, and a record whose lines of commands are taken for states.
namespace treeline {
namespace {

class ReadMotion : public test::OwnFolder {
 protected:
  std::optional<RecordedMotion> read(const std::string& text) {
    write("motion", text);
    return read_motion((root_ / "motion").string(), {"base", "base", "elbow"}, {7, 8, 9},
                       diagnostics_);
  }

  [[nodiscard]] std::string fault() const {
    return diagnostics_.list().empty() ? "" : to_string(diagnostics_.list().back());
  }

  Diagnostics diagnostics_;
};

TEST_F(ReadMotion, TakesColumnsByName) {
  const auto motion = read("time,energy,q_elbow\n0,5,1.5\n0.1, 5 ,-2e-3\n\n");
  ASSERT_TRUE(motion) << fault();
  EXPECT_EQ(motion->times, (std::vector<double>{0, 0.1}));
  EXPECT_EQ(motion->q, (std::vector<std::vector<double>>{{7, 8, 1.5}, {7, 8, -2e-3}}));
}

TEST_F(ReadMotion, TakesColumnsByNumber) {
  const auto motion = read("time_s,q1,q2,qd2\n3,4,5,6\n");
  ASSERT_TRUE(motion) << fault();
  EXPECT_EQ(motion->q.front(), (std::vector<double>{7, 4, 5}));
}

// Would catch: a table that `simulate` wrote for a robot with fewer coordinates, whose columns
// would all be taken for those of other joints.
TEST_F(ReadMotion, RefusesTheStateOfAnotherRobot) {
  EXPECT_FALSE(read("time_s,q0,q1,qd0,qd1,energy_J\n0,1,2,3,4,5\n"));
  EXPECT_NE(fault().find("2 coordinates, this one has 3"), std::string::npos) << fault();
  EXPECT_TRUE(read("time_s,q0,q1,q2,qd0,qd1,qd2\n0,1,2,3,4,5,6\n")) << fault();
}

// As the page of `treeline drive` saves them: with units, names behind numbers, cells without a
// value.
TEST_F(ReadMotion, TakesColumnsWithUnits) {
  const auto motion = read(
      "time [s],mode,q1 base.y [m],error_elbow [rad],q_elbow [rad],qd_elbow [rad/s]\n"
      "0.5,idle,4,,1.5,9\n");
  ASSERT_TRUE(motion) << fault();
  EXPECT_EQ(motion->times.front(), 0.5);
  EXPECT_EQ(motion->q.front(), (std::vector<double>{7, 4, 1.5}));
  EXPECT_FALSE(read("time,q3 base.x [m]\n1,1\n"));
  EXPECT_NE(fault().find("no coordinate `q3"), std::string::npos) << fault();
}

TEST_F(ReadMotion, TakesStatesOfARecord) {
  const auto motion = read(
      "{\"type\":\"hello\"}\n{\"time\":0.5,\"q\":[1,2,3]}\n{\"time\":1,\"command\":\"stop\"}\n"
      "{\"time\":1.5,\"q\":[4,5,6]}\n");
  ASSERT_TRUE(motion) << fault();
  EXPECT_EQ(motion->times, (std::vector<double>{0.5, 1.5}));
  EXPECT_EQ(motion->q.back(), (std::vector<double>{4, 5, 6}));
}

TEST_F(ReadMotion, NamesTheLineThatIsWrong) {
  for (const char* row : {"0.1", "0.1,x", "0.1,2,3", "-1,2", "0.1,nan"}) {
    EXPECT_FALSE(read(std::string("time,q2\n0,1\n") + row + "\n")) << row;
    EXPECT_NE(fault().find("motion:3: error"), std::string::npos) << fault();
  }
  EXPECT_FALSE(read("{\"time\":0,\"q\":[1]}\n"));
  EXPECT_NE(fault().find("has to be 3 numbers"), std::string::npos) << fault();
  EXPECT_FALSE(read("{\"time\":0,"));
  EXPECT_NE(fault().find("not JSON"), std::string::npos) << fault();
}

TEST_F(ReadMotion, SaysWhatIsMissing) {
  EXPECT_FALSE(read(""));
  EXPECT_NE(fault().find("no row"), std::string::npos) << fault();
  EXPECT_FALSE(read("q2\n1\n"));
  EXPECT_NE(fault().find("no column `time`"), std::string::npos) << fault();
  EXPECT_FALSE(read("time,qd3,q_base\n1,1,1\n"));  // two coordinates are called base
  EXPECT_NE(fault().find("no column is a coordinate"), std::string::npos) << fault();
  EXPECT_FALSE(read("time,q1,q2,q3\n1,1,1,1\n"));  // counted from 1, or of another robot
  EXPECT_NE(fault().find("no coordinate `q3`: the robot has 3"), std::string::npos) << fault();
}

}  // namespace
}  // namespace treeline
