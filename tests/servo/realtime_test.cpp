// What the kernel says of a thread that asked for real time. Would catch: a thread that is pinned
// while others share its core, a core that threads started later get back, and a refusal that is
// not told.
#include "servo/realtime.hpp"

#include <gtest/gtest.h>
#include <sched.h>

#include <atomic>
#include <thread>

namespace {

cpu_set_t cores_of_this_thread() {
  cpu_set_t cores;
  CPU_ZERO(&cores);
  EXPECT_EQ(sched_getaffinity(0, sizeof(cores), &cores), 0);
  return cores;
}

int last_of(const cpu_set_t& cores) {
  int core = CPU_SETSIZE - 1;
  while (core >= 0 && !CPU_ISSET(core, &cores)) --core;
  return core;
}

/// Gives the test's thread its cores back.
class Restore {
 public:
  Restore() : cores_(cores_of_this_thread()) {}
  ~Restore() { sched_setaffinity(0, sizeof(cores_), &cores_); }
  Restore(const Restore&) = delete;
  Restore& operator=(const Restore&) = delete;
  [[nodiscard]] const cpu_set_t& cores() const { return cores_; }

 private:
  cpu_set_t cores_;
};

TEST(RealTime, TheThreadHasTheLastCoreForItself) {
  const Restore before;
  std::atomic<bool> asked{false};
  cpu_set_t own, inherited;
  int policy = -1;
  std::string refused;
  std::thread bystander([&] {
    while (!asked) std::this_thread::yield();
    inherited = cores_of_this_thread();
  });
  std::thread servo([&] {
    refused = treeline::servo::request_realtime();
    policy = sched_getscheduler(0);
    own = cores_of_this_thread();
    asked = true;
  });
  servo.join();
  bystander.join();
  if (policy != SCHED_FIFO) {
    EXPECT_NE(refused.find("no real-time scheduling"), std::string::npos) << refused;
    EXPECT_NE(refused.find("not pinned"), std::string::npos) << refused;
    EXPECT_TRUE(CPU_EQUAL(&own, &before.cores()));
    return;
  }
  if (CPU_COUNT(&before.cores()) < 2) {
    EXPECT_NE(refused.find("one core"), std::string::npos) << refused;
    return;
  }
  const int core = last_of(before.cores());
  EXPECT_EQ(CPU_COUNT(&own), 1);
  EXPECT_TRUE(CPU_ISSET(core, &own));
  EXPECT_FALSE(CPU_ISSET(core, &inherited));
  cpu_set_t later;
  std::thread([&] { later = cores_of_this_thread(); }).join();
  EXPECT_FALSE(CPU_ISSET(core, &later));
  EXPECT_EQ(CPU_COUNT(&later), CPU_COUNT(&before.cores()) - 1);
}

}  // namespace
