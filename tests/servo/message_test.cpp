// Order and capacity of the queue, the ring between threads, the complete table of the state
// machine. Would catch: a heap that loses or reorders equally urgent messages, a stop that waits
// behind motions, and an undocumented transition.
#include "servo/message.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <random>
#include <thread>
#include <vector>

#include "servo/state_machine.hpp"

namespace {

using namespace treeline::servo;  // NOLINT: all of it is under test

Message numbered(MessageKind kind, int index) {
  Message message;
  message.kind = kind;
  message.index = index;
  return message;
}

TEST(MessageQueue, UrgentFirstThenOrderOfArrival) {
  std::mt19937 random(5);
  std::uniform_int_distribution<int> kind(0, 7);
  for (int round = 0; round < 100; ++round) {
    MessageQueue<40> queue;
    std::vector<Message> expected;
    for (int i = 0; i < 40; ++i) {
      expected.push_back(numbered(static_cast<MessageKind>(kind(random)), i));
      ASSERT_TRUE(queue.insert(expected.back()));
    }
    EXPECT_FALSE(queue.insert(expected.back())) << "full";
    std::stable_sort(expected.begin(), expected.end(),
                     [](const Message& a, const Message& b) { return urgency(a) > urgency(b); });
    for (const Message& wanted : expected) {
      Message message;
      ASSERT_TRUE(queue.pop(message));
      EXPECT_EQ(message.index, wanted.index);
    }
    Message none;
    EXPECT_FALSE(queue.pop(none));
    EXPECT_TRUE(queue.empty());
  }
}

TEST(MessageQueue, StopsOvertakeMotions) {
  EXPECT_GT(urgency(numbered(MessageKind::emergency_stop, 0)),
            urgency(numbered(MessageKind::disconnect, 0)));
  EXPECT_GT(urgency(numbered(MessageKind::stop, 0)), urgency(numbered(MessageKind::start, 0)));
  EXPECT_GT(urgency(numbered(MessageKind::start, 0)),
            urgency(numbered(MessageKind::move_point, 0)));
  EXPECT_EQ(urgency(numbered(MessageKind::set_gains, 0)),
            urgency(numbered(MessageKind::move_point, 0)));
}

TEST(Ring, CarriesEverythingInOrderBetweenThreads) {
  auto ring = std::make_unique<Ring<int, 16>>();
  constexpr int kCount = 100000;
  std::thread writer([&] {
    for (int i = 0; i < kCount;) {
      if (ring->push(i)) {
        ++i;
      } else {
        std::this_thread::yield();
      }
    }
  });
  int received = 0;
  int wrong = 0;
  while (received < kCount) {
    int item = -1;
    if (ring->pop(item)) {
      wrong += item == received ? 0 : 1;
      ++received;
    } else {
      std::this_thread::yield();
    }
  }
  writer.join();
  EXPECT_EQ(wrong, 0);
  int none = 0;
  EXPECT_FALSE(ring->pop(none));
}

TEST(StateMachine, WholeTable) {
  using M = Mode;
  using E = Event;
  constexpr E kEvents[] = {E::start, E::stop, E::at_rest, E::fault, E::reset};
  constexpr M kTable[4][5] = {
      {M::running, M::idle, M::idle, M::faulted, M::idle},            // idle
      {M::running, M::stopping, M::running, M::faulted, M::running},  // running
      {M::stopping, M::stopping, M::idle, M::faulted, M::stopping},   // stopping
      {M::faulted, M::faulted, M::faulted, M::faulted, M::idle},      // faulted
  };
  for (int mode = 0; mode < 4; ++mode) {
    for (int event = 0; event < 5; ++event) {
      EXPECT_EQ(next_mode(static_cast<M>(mode), kEvents[event]), kTable[mode][event])
          << mode_name(static_cast<M>(mode)) << ", event " << event;
    }
  }
}

}  // namespace
