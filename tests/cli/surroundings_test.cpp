// The program with full disks, odd file names and other runs at the same time. Each test is an
// attack that once succeeded.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <string_view>
#include <thread>

#include "program_test.hpp"

namespace treeline {
namespace {

namespace fs = std::filesystem;
using test::Outcome;
using test::read_file;

const std::string kUrdf = TREELINE_ROBOTS "/planar3r/planar3r.urdf";
const std::string kScene = TREELINE_ROBOTS "/planar3r/scene.yaml";
const std::string kBoth = kUrdf + " " + kScene;

class Surroundings : public test::ProgramTest {
 protected:
  /// Runs with these redirections of the shell, behind those of both outputs to files.
  [[nodiscard]] Outcome run_with(const std::string& redirections,
                                 const std::string& arguments) const {
    const std::string command = "cd '" + root_.string() + "' && '" TREELINE_PROGRAM "' " +
                                arguments + " >stdout.txt 2>stderr.txt " + redirections;
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_file(root_ / "stdout.txt"),
            read_file(root_ / "stderr.txt")};
  }
};

// Would catch: half a table in a file that looks like a complete one.
TEST_F(Surroundings, FullOrClosedStandardOutputIsOne) {
  for (const std::string& arguments :
       {"inspect " + kUrdf, "inspect " + kBoth + " --json", "generate " + kBoth + " -o out",
        "generate " + kBoth + " -o out --json", "init-scene " + kUrdf,
        "generate " + kBoth + " --functions gravity --dump text",
        "simulate " + kUrdf + " --seconds 0.1 --csv -", "simulate " + kUrdf + " --seconds 0.1",
        "diff " + kUrdf + " " + kUrdf, "diff " + kUrdf + " " + kUrdf + " --json",
        std::string("--help")}) {
    for (const char* output : {">/dev/full", ">&-"}) {
      const Outcome outcome = run_with(output, arguments);
      EXPECT_EQ(outcome.exit_code, 1) << arguments << output << '\n' << outcome.err;
      EXPECT_NE(outcome.err.find("standard output: error: cannot be written"), std::string::npos)
          << arguments << output << '\n'
          << outcome.err;
    }
  }
}

// Would catch: half a table in a file. Files here may have 8 blocks of 512 bytes.
TEST_F(Surroundings, NoPartOfAFileStays) {
  const std::string script = "cd '" + root_.string() +
                             "' && trap '' XFSZ && ulimit -f 8 && '" TREELINE_PROGRAM
                             "' simulate " +
                             kUrdf + " --csv table.csv >/dev/null 2>stderr.txt";
  const int status = std::system(script.c_str());
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 1);
  const std::string err = read_file(root_ / "stderr.txt");
  EXPECT_NE(err.find("table.csv: error: cannot be written to its end"), std::string::npos) << err;
  EXPECT_FALSE(fs::exists(root_ / "table.csv"));
}

// Would catch: a robot that is lost because an option's value was left out or mistyped.
// Options refuse names of robots and scenes before they look: here they are named otherwise.
TEST_F(Surroundings, WhatWasReadIsNotWrittenOver) {
  const std::string robot = read_file(kUrdf);
  std::ofstream(root_ / "arm") << robot;
  fs::create_symlink("arm", root_ / "link");
  for (const char* arguments :
       {"simulate arm --seconds 0.1 --csv arm", "simulate arm --seconds 0.1 --svg link",
        "draw arm --svg ./arm", "inspect arm --repair arm", "convert arm -o arm",
        "init-scene arm -o arm --force", "drive arm --headless --record arm",
        "generate arm -o out --functions gravity --safety arm",
        "generate arm -o out --functions gravity --depfile arm"}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 1) << arguments;
    EXPECT_NE(outcome.err.find("is not written over"), std::string::npos) << outcome.err;
    EXPECT_EQ(read_file(root_ / "arm"), robot) << arguments;
  }
}

// Would catch: the robot of a scene that lists robots, which the command line does not name.
TEST_F(Surroundings, RobotsOfASceneAreNotWrittenOver) {
  const std::string robot = read_file(kUrdf);
  std::ofstream(root_ / "arm") << robot;
  std::ofstream(root_ / "pair.yaml") << "robots: [{name: left, urdf: arm}]\n"
                                        "functions: [gravity]\n";
  for (const char* arguments :
       {"simulate pair.yaml --seconds 0.1 --csv arm", "draw pair.yaml --svg arm",
        "bench pair.yaml --quick --svg arm", "drive pair.yaml --headless --record arm",
        "generate pair.yaml -o out --depfile arm"}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 1) << arguments;
    EXPECT_NE(outcome.err.find("is not written over"), std::string::npos) << outcome.err;
    EXPECT_EQ(read_file(root_ / "arm"), robot) << arguments;
  }
}

TEST_F(Surroundings, DashIsStandardOutput) {
  for (const char* command : {"init-scene", "convert", "draw"}) {
    const Outcome plain = run(std::string(command) + " " + kUrdf);
    const std::string option = command == std::string("draw") ? " --svg -" : " --output -";
    const Outcome dash = run(std::string(command) + " " + kUrdf + option);
    EXPECT_EQ(dash.exit_code, 0) << command << '\n' << dash.err;
    EXPECT_EQ(dash.out, plain.out) << command;
    EXPECT_FALSE(fs::exists(root_ / "-")) << command;
  }
}

// Would catch: a message that nobody can be told and that ends the program, and one that goes into
// a file which took the place of a closed standard error.
TEST_F(Surroundings, FullOrClosedStandardErrorChangesNothing) {
  const std::string simulation = "simulate " + kUrdf + " --seconds 0.1 --json --csv table.csv";
  const Outcome told = run(simulation);
  ASSERT_NE(told.err, "");
  const std::string table = read_file(root_ / "table.csv");
  for (const char* errors : {"2>/dev/full", "2>&-"}) {
    const Outcome untold = run_with(errors, simulation);
    EXPECT_EQ(untold.exit_code, 0) << errors;
    EXPECT_EQ(untold.out, told.out) << errors;
    EXPECT_EQ(read_file(root_ / "table.csv"), table) << errors;
    EXPECT_EQ(run_with(errors, "inspect nowhere.urdf").exit_code, 1) << errors;
    EXPECT_EQ(run_with(errors, "inspect --nothing").exit_code, 2) << errors;
  }
}

// Would catch: a fault of the user's machine that is reported as one of the program.
TEST_F(Surroundings, MissingTemporaryFolderIsOne) {
  const std::string command = "check " + kBoth + " --functions gravity --states 5";
  const std::string script = "cd '" + root_.string() + "' && TMPDIR=/nonexistent '" +
                             TREELINE_PROGRAM + "' " + command + " 2>stderr.txt >stdout.txt";
  const int status = std::system(script.c_str());
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 1);
  const std::string err = read_file(root_ / "stderr.txt");
  EXPECT_NE(err.find("TMPDIR"), std::string::npos) << err;
  EXPECT_EQ(err.find("internal"), std::string::npos) << err;
}

// Would catch: an empty TMPDIR that counts as a folder without a name.
TEST_F(Surroundings, EmptyNameOfTheTemporaryFolderIsNone) {
  const std::string script = "cd '" + root_.string() + "' && TMPDIR= '" + TREELINE_PROGRAM +
                             "' check " + kBoth +
                             " --functions gravity --states 5 2>stderr.txt >stdout.txt";
  EXPECT_EQ(std::system(script.c_str()), 0) << read_file(root_ / "stderr.txt");
}

TEST_F(Surroundings, OutputWithoutANameIsOne) {
  const Outcome outcome = run("generate " + kBoth + " -o ''");
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  EXPECT_NE(outcome.err.find("Name the folder"), std::string::npos) << outcome.err;
  EXPECT_EQ(std::distance(fs::directory_iterator(root_), {}), 2);  // stdout.txt, stderr.txt
}

TEST_F(Surroundings, UnwritableFilesAreOne) {
  EXPECT_EQ(run("simulate " + kUrdf + " --seconds 0.1 --csv no/such/folder.csv").exit_code, 1);
  EXPECT_EQ(run("simulate " + kUrdf + " --seconds 0.1 --svg /dev/full").exit_code, 1);
  EXPECT_EQ(run("init-scene " + kUrdf + " -o /dev/full --force").exit_code, 1);
  std::ofstream(root_ / "file") << "mine";
  const Outcome file = run("generate " + kBoth + " -o file");
  EXPECT_EQ(file.exit_code, 1);
  EXPECT_NE(file.err.find("this is a file, not a folder"), std::string::npos) << file.err;
  const Outcome name = run("generate " + kBoth + " -o out --name " + std::string(300, 'a'));
  EXPECT_EQ(name.exit_code, 1);
  EXPECT_NE(name.err.find("File name too long"), std::string::npos) << name.err;
  EXPECT_EQ(run("generate " + kBoth + " -o file/deep").exit_code, 1);
  EXPECT_EQ(read_file(root_ / "file"), "mine");
}

// Would catch: a file name that runs as code in the header, in its command, or on the terminal.
TEST_F(Surroundings, FileNamesCannotInject) {
  const std::string name = "p\r#error pwn\r\x1b[2J'$(touch pwned)\\.urdf";
  fs::copy_file(kUrdf, root_ / name);
  const std::string word = "$(printf 'p\\r#error pwn\\r\\033[2J\\047$(touch pwned)\\\\.urdf')";
  const Outcome outcome =
      run("generate \"" + word + "\" " + kScene + " --functions gravity -o out");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto is_odd = [](char c) { return (c >= 0 && c < ' ' && c != '\n') || c == 0x7F; };
  for (const auto& entry : fs::directory_iterator(root_ / "out")) {
    const std::string text = read_file(entry.path());
    EXPECT_FALSE(std::any_of(text.begin(), text.end(), is_odd)) << entry.path();
  }
  const std::string compile = "c++ -std=c++17 -Wall -Wextra -Werror -fsyntax-only '" +
                              (root_ / "out" / "gravity.cpp").string() + "'";
  EXPECT_EQ(std::system(compile.c_str()), 0);
  // The command in the header, run by bash, reproduces the folder.
  const std::string contract = read_file(root_ / "out" / "planar3r.hpp");
  const auto at = contract.find("treeline generate ");
  ASSERT_NE(at, std::string::npos);
  const std::string line = contract.substr(at, contract.find('\n', at) - at);
  std::ofstream(root_ / "again.sh") << "cd '" << root_.string() << "'\ncp " << kScene
                                    << " .\ntreeline() { '" TREELINE_PROGRAM "' \"$@\"; }\n"
                                    << line << " --compare >again.txt\n";
  fs::rename(root_ / "out", root_ / "planar3r");
  EXPECT_EQ(std::system(("bash '" + (root_ / "again.sh").string() + "'").c_str()), 0)
      << line << '\n'
      << read_file(root_ / "again.txt");
  EXPECT_FALSE(fs::exists(root_ / "pwned"));
  // A message about it does not affect the terminal.
  const Outcome missing = run("inspect \"" + word + "x\"");
  EXPECT_EQ(missing.exit_code, 1);
  EXPECT_FALSE(std::any_of(missing.err.begin(), missing.err.end(), is_odd)) << missing.err;
  const Outcome usage = run("inspect " + kUrdf + " \"$(printf -- '--\\033[2J')\"");
  EXPECT_EQ(usage.exit_code, 2);
  EXPECT_FALSE(std::any_of(usage.err.begin(), usage.err.end(), is_odd)) << usage.err;
}

// Would catch: right-to-left text in the sources, which makes comments look like code.
TEST_F(Surroundings, MarksOfDirectionStayOutOfSources) {
  std::string text = read_file(kUrdf);
  const std::string mark = "\xE2\x80\xAE";
  const auto at = text.find("name=\"") + 6;
  text.insert(at, mark);
  std::ofstream(root_ / "r.urdf") << text;
  ASSERT_EQ(run("generate r.urdf -o out --functions gravity").exit_code, 0);
  for (const auto& entry : fs::directory_iterator(root_ / "out")) {
    EXPECT_EQ(read_file(entry.path()).find(mark), std::string::npos) << entry.path();
  }
  EXPECT_EQ(run("inspect r.urdf").out.find(mark), std::string::npos);
  EXPECT_EQ(run("inspect r.urdf --json").out.find(mark), std::string::npos);
  EXPECT_EQ(run("init-scene r.urdf").out.find(mark), std::string::npos);
}

// Would catch: a folder that is a mixture of two runs.
TEST_F(Surroundings, ASecondWriterWaits) {
  fs::create_directories(root_ / "out");
  const int folder = open((root_ / "out").c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  ASSERT_EQ(flock(folder, LOCK_EX), 0);
  const pid_t child = fork();
  if (child == 0) {
    close(folder);  // released when its last descriptor is closed
    const Outcome outcome = run("generate " + kBoth + " --functions gravity -o out");
    _exit(outcome.exit_code);
  }
  // As long as the lock is held nothing appears, however long the test waits.
  for (int i = 0; i < 50; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    EXPECT_TRUE(fs::is_empty(root_ / "out"));
  }
  close(folder);
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), 0) << read_file(root_ / "stderr.txt");
  EXPECT_TRUE(fs::exists(root_ / "out" / "gravity.cpp"));
}

/// Starts the program directly, without a shell, in a folder with these environment variables.
pid_t start(const fs::path& folder, const std::vector<std::string>& arguments,
            const std::vector<std::pair<std::string, std::string>>& variables) {
  const pid_t child = fork();
  if (child != 0) return child;
  fs::current_path(folder);
  for (const auto& [name, value] : variables) setenv(name.c_str(), value.c_str(), 1);
  (void)!freopen("stdout.txt", "w", stdout);
  (void)!freopen("stderr.txt", "w", stderr);
  std::vector<char*> words{const_cast<char*>(TREELINE_PROGRAM)};
  for (const std::string& word : arguments) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  execv(TREELINE_PROGRAM, words.data());
  _exit(127);
}

void wait_for_file(const fs::path& path) {
  while (!fs::exists(path) || fs::file_size(path) == 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}

bool is_running(pid_t process) {
  const std::string state = read_file("/proc/" + std::to_string(process) + "/stat");
  return !state.empty() && state.find(") Z ") == std::string::npos;
}

// Would catch: temporary folders and compilers that survive Ctrl-C or TERM.
TEST_F(Surroundings, SignalsLeaveNothingBehind) {
  // A compiler that starts another process, as compilers do, and never ends.
  std::ofstream(root_ / "cxx") << "#!/bin/sh\n[ \"$1\" = --version ] && exit 0\n"
                                  "sleep 1000 &\necho $! $$ >\"$PIDS.new\"\n"
                                  "mv \"$PIDS.new\" \"$PIDS\"\nwait\n";
  fs::permissions(root_ / "cxx", fs::perms::owner_all);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const fs::path temporary = root_ / ("tmp" + std::to_string(signal));
    const fs::path pids = root_ / ("pids" + std::to_string(signal));
    fs::create_directories(temporary);
    const pid_t program =
        start(root_, {"check", kUrdf, kScene, "--functions", "gravity", "--states", "5"},
              {{"TMPDIR", temporary.string()},
               {"CXX", (root_ / "cxx").string()},
               {"PIDS", pids.string()}});
    wait_for_file(pids);
    EXPECT_FALSE(fs::is_empty(temporary));
    kill(program, signal);
    int status = 0;
    waitpid(program, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal) << status;
    EXPECT_TRUE(fs::is_empty(temporary)) << "signal " << signal;
    std::ifstream list(pids);
    for (pid_t process = 0; list >> process;) EXPECT_FALSE(is_running(process)) << process;
  }
}

// Would catch: files that a killed run has left and that nothing ever removes, and a run that
// removes files that another one is still using.
TEST_F(Surroundings, TheNextRunRemovesWhatAKilledOneLeft) {
  const fs::path temporary = root_ / "tmp";
  fs::create_directories(temporary / "treeline-check-notours");
  std::ofstream(root_ / "cxx") << "#!/bin/sh\n[ \"$1\" = --version ] && exit 0\n"
                                  "echo $$ >\"$PIDS.new\"\nmv \"$PIDS.new\" \"$PIDS\"\n"
                                  "exec sleep 1000\n";
  fs::permissions(root_ / "cxx", fs::perms::owner_all);
  const auto entries = [&] { return std::distance(fs::directory_iterator(temporary), {}); };
  const std::vector<std::string> command = {"check", kUrdf, kScene, "--functions", "gravity"};
  const auto start_stuck = [&](const std::string& pids) {
    const pid_t program = start(root_, command,
                                {{"TMPDIR", temporary.string()},
                                 {"CXX", (root_ / "cxx").string()},
                                 {"PIDS", (root_ / pids).string()}});
    wait_for_file(root_ / pids);
    return program;
  };
  const pid_t killed = start_stuck("first");
  EXPECT_EQ(entries(), 2);
  kill(killed, SIGKILL);
  waitpid(killed, nullptr, 0);
  EXPECT_EQ(entries(), 2);
  const pid_t second = start_stuck("second");
  EXPECT_EQ(entries(), 2);  // its own instead of the first one's
  const pid_t third = start_stuck("third");
  EXPECT_EQ(entries(), 3);  // beside the second one's
  for (const pid_t program : {second, third}) {
    kill(program, SIGTERM);
    waitpid(program, nullptr, 0);
  }
  EXPECT_EQ(entries(), 1);
  pid_t compiler = 0;
  std::ifstream(root_ / "first") >> compiler;
  kill(compiler, SIGKILL);
}

}  // namespace
}  // namespace treeline
