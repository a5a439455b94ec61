#pragma once

#include <array>
#include <atomic>
#include <cstddef>

#include "core/message_queue.hpp"
#include "core/mode.hpp"

namespace treeline::servo {

using core::MessageKind;

inline constexpr std::size_t kMessageNumbers = 64;

/// A command of fixed size.
struct Message {
  MessageKind kind = MessageKind::stop;
  int index = 0;
  double duration = 0.0;  ///< s
  std::array<double, kMessageNumbers> values{};
};

/// A message that is nothing but its kind, such as `start`.
inline Message message_of(MessageKind kind) noexcept {
  Message message;
  message.kind = kind;
  return message;
}

/// Urgency of a message, see `core::urgency`.
constexpr int urgency(const Message& message) noexcept {
  return core::urgency(message.kind);
}

template <std::size_t capacity>
using MessageQueue = core::MessageQueue<Message, capacity>;

/// Ring buffer between one writing and one reading thread, neither of which ever waits. `Item` is a
/// plain value.
template <class Item, std::size_t capacity>
class Ring {
 public:
  /// Appends an item. Returns false, and does not append it, if the ring is full.
  bool push(const Item& item) noexcept {
    const std::size_t end = end_.load(std::memory_order_relaxed);
    if (end - begin_.load(std::memory_order_acquire) == capacity) {
      return false;
    }
    items_[end % capacity] = item;
    end_.store(end + 1, std::memory_order_release);
    return true;
  }
  /// Removes the oldest item. Returns false if the ring is empty.
  bool pop(Item& item) noexcept {
    const std::size_t begin = begin_.load(std::memory_order_relaxed);
    if (begin == end_.load(std::memory_order_acquire)) {
      return false;
    }
    item = items_[begin % capacity];
    begin_.store(begin + 1, std::memory_order_release);
    return true;
  }

 private:
  static constexpr std::size_t kCacheLine = 64;
  std::array<Item, capacity> items_{};
  alignas(kCacheLine) std::atomic<std::size_t> begin_{0};
  alignas(kCacheLine) std::atomic<std::size_t> end_{0};
};

/// Mailbox in which the front end leaves messages for the loop.
using Mailbox = Ring<Message, 32>;

}  // namespace treeline::servo
