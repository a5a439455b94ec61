#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "drive_fixture.hpp"

// Would catch: an exit status of 0 where the script was cut, the robot has gone or is faulted, or
// the record is not whole; a robot that ends because nobody reads its record.

namespace treeline {
namespace {

const std::string kPlanar = kRobots + "/planar3r/planar3r.urdf";

/// How a shell ended, and what the drive has said.
struct End {
  int exit_code = 0;
  std::string said;
  json state;
};

class DriveEnds : public DriveTest {
 protected:
  /// Runs a drive in the background, does `then` once it has said `word`, and waits for it. Signals
  /// are those of a shell that is not in the background.
  [[nodiscard]] End run_and(const std::string& options, const std::string& word,
                            const std::string& then) const {
    const std::string command =
        "cd " + root_.string() +
        " && { env --default-signal=INT,HUP,QUIT '" TREELINE_PROGRAM "' drive " + kPlanar +
        " --headless --warnings none " + options +
        " >end.json 2>end.txt & } && drive=$!; i=0; until grep -qs '" + word +
        "' end.txt || [ $i -gt 1200 ]; do sleep 0.05; i=$((i+1)); done; " + then + "; wait $drive";
    End end;
    end.exit_code = WEXITSTATUS(std::system(command.c_str()));
    end.said = test::read_file(root_ / "end.txt");
    end.state = json::parse(test::read_file(root_ / "end.json"), nullptr, false);
    return end;
  }
};

TEST_F(DriveEnds, AScriptThatASignalCutsHasFailed) {
  write("script.txt", "start\nwait 1000 s\nhold\n");
  for (const std::string signal : {"INT", "TERM", "HUP"}) {
    const End end =
        run_and("--real-time --script script.txt", "begins", "kill -" + signal + " $drive");
    EXPECT_EQ(end.exit_code, 1) << signal << '\n' << end.said;
    EXPECT_EQ(end.said.find("fault"), std::string::npos) << end.said;
    EXPECT_EQ(end.state["mode"], "idle") << "it has braked to rest";
    std::filesystem::remove(root_ / "end.txt");
  }
}

TEST_F(DriveEnds, ARobotThatIsFaultedHasFailed) {
  for (const char* input : {"start\nstop\n", "start\nstop\nwait\nreset\nwait\n"}) {
    write("input.txt", input);
    const Outcome outcome =
        test::run_program(root_, "drive " + kPlanar + " --headless --warnings none < input.txt");
    const bool faulted = json::parse(outcome.out)["mode"] == "faulted";
    EXPECT_EQ(outcome.exit_code, faulted ? 3 : 0) << outcome.err;
    EXPECT_EQ(faulted, std::string(input).find("reset") == std::string::npos);
  }
}

// Would catch: a script whose lines behind its own emergency stop are passed over without a word.
TEST_F(DriveEnds, AScriptMayStopAndReset) {
  write("script.txt", "start\nwait\nstop\nwait\nreset\nstart\nwait\njoint joint1 to 0.2\nwait\n");
  const Outcome reset = run_drive("--headless --script script.txt");
  EXPECT_EQ(reset.exit_code, 0) << reset.err;
  EXPECT_NEAR(json::parse(reset.out)["q"][0].get<double>(), 0.2, 1e-3) << reset.err;
  write("script.txt", "start\nwait\nstop\nwait\n");
  EXPECT_EQ(run_drive("--headless --script script.txt").exit_code, 3);
}

TEST_F(DriveEnds, ARobotThatVanishesHasFailed) {
  const std::string address = "127.0.0.1:" + std::to_string(20000 + ::getpid() % 20000);
  write("script.txt", "start\njoint joint1 to 0.5 in 60 s\nwait\n");
  write("secret.txt", "a secret of both sides\n");
  const std::string start =
      "cd " + root_.string() + " && { '" TREELINE_PROGRAM "' drive " + kPlanar +
      " --act-as-robot " + address +
      " --robot-secret secret.txt >robot.txt 2>&1 & echo $! >robot.pid; } && i=0; until grep -qs "
      "listens robot.txt || [ $i -gt 1200 ]; do sleep 0.05; i=$((i+1)); done";
  ASSERT_EQ(std::system(start.c_str()), 0);
  const End end =
      run_and("--robot udp:" + address + " --robot-secret secret.txt --script script.txt", "joint1",
              "sleep 0.2; kill -KILL $(cat robot.pid)");
  EXPECT_EQ(end.exit_code, 3) << end.said << test::read_file(root_ / "robot.txt");
  EXPECT_NE(end.said.find("fault"), std::string::npos) << end.said;
  EXPECT_EQ(end.state["mode"], "faulted");
  EXPECT_EQ(test::read_file(root_ / "robot.txt").find("warning"), std::string::npos);
}

TEST_F(DriveEnds, SecretsThatCanBeGuessedAreRefused) {
  write("secret.txt", "short\n");
  const Outcome outcome = run_drive("--act-as-robot 127.0.0.1:9 --robot-secret secret.txt");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("5 characters can be guessed"), std::string::npos) << outcome.err;
}

TEST_F(DriveEnds, ARecordThatIsNotWholeHasFailed) {
  write("script.txt", "start\njoint joint1 to 0.5 in 2 s\nwait\n");
  const Outcome full = run_drive("--headless --script script.txt --record /dev/full");
  EXPECT_EQ(full.exit_code, 1);
  EXPECT_NE(full.err.find("/dev/full"), std::string::npos) << full.err;
  // A reader that goes away after 50 kB of 200.
  ASSERT_EQ(::mkfifo((root_ / "pipe").c_str(), 0600), 0);
  const std::string command = "cd " + root_.string() +
                              " && { sh -c 'exec 3<>pipe; head -c 50000 <&3 >/dev/null' & } && '" +
                              TREELINE_PROGRAM "' drive " + kPlanar +
                              " --headless --script script.txt --record pipe >end.json 2>end.txt";
  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 1);
  EXPECT_NE(test::read_file(root_ / "end.txt").find("record cannot be written any more"),
            std::string::npos);
  const json state = json::parse(test::read_file(root_ / "end.json"));
  EXPECT_NEAR(state["q"][0].get<double>(), 0.5, 1e-2) << "the robot goes on without its record";
}

// Would catch: a drive that is busy with nothing but its input, so that nothing else is heard.
TEST_F(DriveEnds, AnInputWithoutEndHoldsNothing) {
  const std::string command =
      "cd " + root_.string() +
      " && mkfifo go && { yes hold > go 2>/dev/null & } && { '" TREELINE_PROGRAM "' drive " +
      kPlanar +
      " --headless --real-time --warnings none <go >end.json 2>end.txt & } && drive=$!; i=0; until "
      "grep -qs 'start. first' end.txt || [ $i -gt 1200 ]; do sleep 0.05; i=$((i+1)); done; kill "
      "-TERM "
      "$drive; wait $drive";
  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 1) << "lines are left";
  EXPECT_EQ(json::parse(test::read_file(root_ / "end.json"))["mode"], "idle");
}

}  // namespace
}  // namespace treeline
