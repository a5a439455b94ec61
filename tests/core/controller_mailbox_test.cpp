#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <thread>

// Would catch: a command that is torn between two, one that comes after a newer one, and a reader
// or a writer that waits for the other. Interrupts are calls in the middle of a copy.
namespace treeline::core {
namespace {

constexpr int kNumbers = 24;

/// A command whose copy can be interrupted after each number.
struct Interrupted {
  uint32_t numbers[kNumbers] = {};

  Interrupted() = default;
  explicit Interrupted(uint32_t value) {
    for (uint32_t& number : numbers) number = value;
  }
  static inline std::function<void(int)> between;
};

void copy(const Interrupted& from, Interrupted& to) {
  for (int i = 0; i < kNumbers; ++i) {
    to.numbers[i] = from.numbers[i];
    if (!Interrupted::between) continue;
    const std::function<void(int)> once = Interrupted::between;
    Interrupted::between = nullptr;  // an interrupt is not interrupted
    once(i);
    Interrupted::between = once;
  }
}

struct Plain {
  uint32_t numbers[kNumbers] = {};
};

void copy(const Plain& from, Plain& to) {
  to = from;
}

template <class Command>
struct Mailbox {
  Command places[4];
  uint32_t newest[2] = {};
  uint32_t latest = 0;
  uint32_t reading = 0;
};

#define TL_INLINE static inline

/// Everything of runtime/emitted/controller_mailbox.h.
template <class Command>
struct Emitted {
  using TlCommand = Command;
  using TlMailbox = Mailbox<Command>;
  static void tl_copy_command(const Command* from, Command* to) { copy(*from, *to); }
#include "emitted/controller_mailbox.h"
};

#undef TL_INLINE

template <class Command>
void post(Mailbox<Command>& mailbox, const Command& command) {
  Emitted<Command>::tl_leave_command(&command, &mailbox);
}
template <class Command>
void fetch(Mailbox<Command>& mailbox, Command& command) {
  Emitted<Command>::tl_take_newest(&mailbox, &command);
}

template <class Command>
void expect_whole(const Command& command, uint32_t least, uint32_t most) {
  for (const uint32_t number : command.numbers) ASSERT_EQ(number, command.numbers[0]);
  EXPECT_GE(command.numbers[0], least);
  EXPECT_LE(command.numbers[0], most);
}

TEST(ControllerMailbox, GivesWhatWasLeftLast) {
  Mailbox<Interrupted> mailbox;
  Interrupted command(7);
  fetch(mailbox, command);
  expect_whole(command, 0, 0);
  for (uint32_t i = 1; i < 10; ++i) {
    for (uint32_t k = 0; k < i % 4; ++k) post(mailbox, Interrupted(10 * i + k));
    if (i % 4 == 0) continue;
    fetch(mailbox, command);
    expect_whole(command, 10 * i + i % 4 - 1, 10 * i + i % 4 - 1);
  }
}

// The control loop is the interrupt, in the middle of a post.
TEST(ControllerMailbox, StepsMayInterruptAPost) {
  Mailbox<Interrupted> mailbox;
  post(mailbox, Interrupted(1));
  for (uint32_t i = 2; i < 20; ++i) {
    Interrupted::between = [&](int) {
      Interrupted taken;
      fetch(mailbox, taken);
      expect_whole(taken, i - 1, i - 1);
    };
    post(mailbox, Interrupted(i));
    Interrupted::between = nullptr;
  }
}

// Commands come by an interrupt, several in the middle of a fetch.
TEST(ControllerMailbox, PostsMayInterruptAFetch) {
  Mailbox<Interrupted> mailbox;
  uint32_t posted = 1;
  post(mailbox, Interrupted(posted));
  for (int at = 0; at < kNumbers; ++at) {
    const uint32_t before = posted;
    Interrupted::between = [&](int i) {
      for (int k = 0; i == at && k < 5; ++k) post(mailbox, Interrupted(++posted));
    };
    Interrupted taken;
    fetch(mailbox, taken);
    Interrupted::between = nullptr;
    expect_whole(taken, before, posted);
    fetch(mailbox, taken);
    expect_whole(taken, posted, posted);
  }
}

TEST(ControllerMailbox, ThreadsShareIt) {
  Mailbox<Plain> mailbox;
  constexpr uint32_t kPosts = 200000;
  std::thread writer([&] {
    for (uint32_t i = 1; i <= kPosts; ++i) {
      Plain command;
      for (uint32_t& number : command.numbers) number = i;
      post(mailbox, command);
    }
  });
  uint32_t last = 0;
  while (last < kPosts) {
    Plain taken;
    fetch(mailbox, taken);
    expect_whole(taken, last, kPosts);
    if (::testing::Test::HasFailure()) break;
    last = taken.numbers[0];
  }
  writer.join();
}

}  // namespace
}  // namespace treeline::core
