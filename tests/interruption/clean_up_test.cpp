// In each test a signal ends a child process, and the test checks what is left.
#include "interruption/clean_up.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>

#include "../own_folder.hpp"
#include "interruption/folder_guard.hpp"

namespace treeline {
namespace {

namespace fs = std::filesystem;

/// What programs that run in the background ignore is not ignored here.
void clean_up_on_all_signals() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) ::signal(signal, SIG_DFL);
  clean_up_on_signals();
}

class CleanUp : public test::OwnFolder {
 protected:
  /// Runs `work` in a child that then waits to be ended by `signal`. Returns how it ended.
  int end_child(int signal, const std::function<void()>& work) {
    int ready[2];
    if (pipe(ready) != 0) return -1;
    const pid_t child = fork();
    if (child == 0) {
      clean_up_on_all_signals();
      work();
      (void)!::write(ready[1], "x", 1);
      for (;;) pause();
    }
    char byte = 0;
    (void)!read(ready[0], &byte, 1);
    kill(child, signal);
    int status = 0;
    waitpid(child, &status, 0);
    close(ready[0]);
    close(ready[1]);
    return status;
  }
};

// Would catch: folders that stay, and an exit that a shell takes for success or for a crash.
TEST_F(CleanUp, RemovesFoldersAndEndsByTheSignal) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const int status = end_child(signal, [&] {
      const Uninterrupted now;
      fs::create_directories(root_ / "results" / "part" / "deep");
      std::ofstream(root_ / "results" / "part" / "deep" / "file") << "text";
      remove_on_signal(root_ / "results", Removal::if_empty);
      remove_on_signal(root_ / "results" / "part", Removal::with_content);
    });
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal) << status;
    EXPECT_TRUE(fs::is_empty(root_));
  }
}

// Would catch: results, or folders to keep, that disappear with a signal.
TEST_F(CleanUp, LeavesWhatIsNotItsOwn) {
  end_child(SIGTERM, [&] {
    const Uninterrupted now;
    fs::create_directories(root_ / "results");
    std::ofstream(root_ / "results" / "file") << "text";
    remove_on_signal(root_ / "results", Removal::if_empty);
    fs::create_directories(root_ / "kept");
    remove_on_signal(root_ / "kept", Removal::with_content);
    keep_on_signal(root_ / "kept");
  });
  EXPECT_TRUE(fs::exists(root_ / "results" / "file"));
  EXPECT_TRUE(fs::exists(root_ / "kept"));
}

// Would catch: a program that ends where it wanted to brake first, or that no second signal ends.
TEST_F(CleanUp, TheFirstSignalIsAnsweredAndTheSecondEnds) {
  int ready[2];
  ASSERT_EQ(pipe(ready), 0);
  const pid_t child = fork();
  if (child == 0) {
    static int answer = ready[1];
    clean_up_on_all_signals();
    answer_signals([] { (void)!::write(answer, "a", 1); });
    (void)!::write(ready[1], "x", 1);
    for (;;) pause();
  }
  char byte = 0;
  (void)!read(ready[0], &byte, 1);
  EXPECT_EQ(byte, 'x');
  kill(child, SIGINT);
  (void)!read(ready[0], &byte, 1);
  EXPECT_EQ(byte, 'a');
  kill(child, SIGTERM);
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGTERM) << status;
  close(ready[0]);
  close(ready[1]);
}

// Would catch: a signal that interrupts a rename of several files.
TEST_F(CleanUp, WaitsForWhatMustNotBeInterrupted) {
  int ready[2];
  ASSERT_EQ(pipe(ready), 0);
  const pid_t child = fork();
  if (child == 0) {
    clean_up_on_all_signals();
    {
      const Uninterrupted now;
      (void)!::write(ready[1], "x", 1);
      for (int i = 0; i < 20; ++i) {
        std::ofstream(root_ / ("file" + std::to_string(i))) << "text";
        usleep(5000);
      }
    }
    for (;;) const Uninterrupted never;
  }
  char byte = 0;
  ASSERT_EQ(read(ready[0], &byte, 1), 1);
  kill(child, SIGTERM);
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status));
  EXPECT_TRUE(fs::exists(root_ / "file19"));
}

// Would catch: a program under nohup that a hangup ends.
TEST_F(CleanUp, IgnoredSignalsStayIgnored) {
  const pid_t child = fork();
  if (child == 0) {
    signal(SIGHUP, SIG_IGN);
    clean_up_on_signals();
    raise(SIGHUP);
    usleep(100000);
    _exit(42);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 42) << status;
}

// Would catch: a lock that two processes hold, or that outlives its process.
TEST_F(CleanUp, FoldersAreLockedByOneProcess) {
  std::string error;
  const pid_t child = fork();
  if (child == 0) {
    const auto guard = FolderGuard::try_lock(root_, error);
    std::ofstream(root_ / (guard ? "locked" : "failed")) << "";
    for (;;) pause();
  }
  while (!fs::exists(root_ / "locked") && !fs::exists(root_ / "failed")) usleep(1000);
  EXPECT_FALSE(FolderGuard::try_lock(root_, error));
  EXPECT_EQ(error, "");
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  EXPECT_TRUE(FolderGuard::try_lock(root_, error)) << error;
  EXPECT_FALSE(FolderGuard::try_lock(root_ / "locked", error));
  EXPECT_NE(error, "");  // a file
}

}  // namespace
}  // namespace treeline
