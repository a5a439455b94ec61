// Would catch: answers that programs cannot tell apart, numbers of another layout or of another
// robot than was asked for, and requests that are not understood and yet answered.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "program_test.hpp"

namespace treeline {
namespace {

using test::Outcome;

constexpr double kMass = 2, kReach = 0.2, kGravity = 9.81;

class InterpretTest : public test::ProgramTest {
 protected:
  InterpretTest() {
    write("arm.urdf", R"(<robot name="arm">
  <link name="base"/>
  <joint name="elbow" type="revolute"><parent link="base"/><child link="forearm"/>
    <axis xyz="0 1 0"/><limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
  <link name="forearm"><inertial><origin xyz="0.2 0 0"/><mass value="2"/>
    <inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/></inertial></link>
</robot>
)");
  }

  /// The program's run on these requests.
  [[nodiscard]] Outcome ask(const std::string& requests) const {
    write("requests", requests);
    return run("interpret arm.urdf <requests");
  }
};

std::string bytes_of(const std::vector<double>& numbers) {
  std::string bytes(numbers.size() * sizeof(double), '\0');
  std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

std::vector<double> read_numbers(std::istream& stream, std::size_t count) {
  std::vector<double> numbers(count);
  stream.read(reinterpret_cast<char*>(numbers.data()),
              static_cast<std::streamsize>(count * sizeof(double)));
  return numbers;
}

nlohmann::json read_line(std::istream& stream) {
  std::string line;
  std::getline(stream, line);
  return nlohmann::json::parse(line);
}

// Of a pendulum: m g r cos q, and the torque that (I + m r^2) qdd adds to it.
TEST_F(InterpretTest, AnswersCallsOfManyStates) {
  const std::vector<double> angles{0, 0.5, -1};
  const Outcome outcome = ask("describe inverse_dynamics\ncall gravity 3\n" + bytes_of(angles) +
                              "call inverse_dynamics 1\n" + bytes_of({0.5, 0, 3}));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  std::istringstream answers(outcome.out);
  const nlohmann::json robot = read_line(answers);
  EXPECT_EQ(robot["name"], "arm");
  EXPECT_EQ(robot["coordinates"][0]["joint"], "elbow");
  EXPECT_EQ(robot["coordinates"][0]["upper"], 1);
  EXPECT_EQ(robot["velocities"][0]["effort"], 1);
  const nlohmann::json described = read_line(answers);
  ASSERT_EQ(described["arguments"].size(), 3U);
  EXPECT_EQ(described["arguments"][2]["name"], "qdd");
  EXPECT_EQ(described["results"][0]["rows"], 1);
  ASSERT_EQ(read_line(answers)["numbers"], 3);
  const std::vector<double> weights = read_numbers(answers, 3);
  constexpr double kRounding = 1e-15;  // of a few operations with numbers of about 4
  for (std::size_t i = 0; i < angles.size(); ++i) {
    EXPECT_NEAR(-weights[i], kMass * kGravity * kReach * std::cos(angles[i]), 4 * kRounding);
  }
  ASSERT_EQ(read_line(answers)["numbers"], 1);
  const double inertia = 0.1 + kMass * kReach * kReach;
  EXPECT_NEAR(read_numbers(answers, 1)[0], weights[1] + inertia * 3, 4 * kRounding);
}

// In the first moment a torque accelerates by what it has beyond the weight. What a longer motion
// is: tests/python/step_test.py.
TEST_F(InterpretTest, MovesOnByATorque) {
  const double torque = 1;
  const Outcome outcome =
      ask("describe step\ncall step 1 1e-6 1 false\n" + bytes_of({0, 0, torque}));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  std::istringstream answers(outcome.out);
  read_line(answers);
  EXPECT_EQ(read_line(answers)["results"].size(), 4U);
  ASSERT_EQ(read_line(answers)["numbers"], 6);
  const std::vector<double> moved = read_numbers(answers, 6);
  const double inertia = 0.1 + kMass * kReach * kReach;
  const double qdd = (torque + kMass * kGravity * kReach) / inertia;  // the weight pulls with it
  EXPECT_NEAR(moved[1], 1e-6 * qdd, 1e-15);
  EXPECT_NEAR(moved[0], 1e-12 * qdd / 2, 1e-20);
}

TEST_F(InterpretTest, EndsAtWhatItDoesNotUnderstand) {
  for (const char* request :
       {"call gravity many\n", "call gravity -1\n", "call gravity\n", "call gravity 99999999999\n",
        "describe jacobian\n", "stop\n", "\n", "call step 1 1e-3 1 false\n",
        "describe step\ncall step 1\n", "describe step\ncall step 1 0 1 false\n",
        "describe step\ncall step 1 1e-3 0 false\n", "describe step\ncall step 1 inf 1 false\n"}) {
    const Outcome outcome = ask(request);
    EXPECT_EQ(outcome.exit_code, 1) << request;
    EXPECT_NE(outcome.out.find("cannot be understood"), std::string::npos) << outcome.out;
  }
  const Outcome cut = ask("call gravity 2\n12345678");
  EXPECT_EQ(cut.exit_code, 1);
  EXPECT_EQ(cut.out.find("numbers"), std::string::npos) << cut.out;
}

TEST_F(InterpretTest, RefusesRobotsAsAllCommandsDo) {
  const Outcome outcome = run("interpret nothing.urdf </dev/null");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.out, "");
  EXPECT_NE(outcome.err.find("nothing.urdf: error"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace treeline
