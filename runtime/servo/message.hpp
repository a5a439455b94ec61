#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace treeline::servo {

/// Requests of a front end. The first five concern the loop, in order of decreasing urgency. The
/// others are passed to the controller.
enum class MessageKind : std::uint8_t {
  emergency_stop,  ///< go to the safe state now
  disconnect,      ///< the front end leaves: stop, then end the loop
  stop,            ///< brake to rest
  reset,           ///< leave the faulted mode
  start,           ///< begin to control from the present state
  move_point,      ///< index: point; values: position (3), row-major rotation (9); duration
  set_posture,     ///< values: desired posture q
  set_gains,       ///< values: kp, kv
  instruction,     ///< for controllers with messages of their own; index: which
};

inline constexpr std::size_t kMessageNumbers = 64;

/// A command of fixed size.
struct Message {
  MessageKind kind = MessageKind::stop;
  int index = 0;
  double duration = 0.0;  ///< s
  std::array<double, kMessageNumbers> values{};
};

/// Urgency of a message. Of two waiting messages the more urgent one is applied first. The order is
/// that of MessageKind up to `start`; all later kinds are equally urgent.
constexpr int urgency(const Message& message) noexcept {
  constexpr int kLeast = static_cast<int>(MessageKind::move_point);
  const int kind = static_cast<int>(message.kind);
  return kind < kLeast ? kLeast - kind : 0;
}

/// Priority queue Q of Chang fig. 9.2: the most urgent message first, equally urgent ones in the
/// order of their arrival. A binary heap of fixed capacity, for a single thread.
template <std::size_t capacity>
class MessageQueue {
 public:
  bool empty() const noexcept { return size_ == 0; }
  std::size_t size() const noexcept { return size_; }

  /// Inserts a message. Returns false, and does not insert it, if the queue is full.
  bool insert(const Message& message) noexcept {
    if (size_ == capacity) {
      return false;
    }
    std::size_t place = size_++;
    entries_[place] = {message, arrivals_++};
    while (place > 0 && before(entries_[place], entries_[(place - 1) / 2])) {
      swap(place, (place - 1) / 2);
      place = (place - 1) / 2;
    }
    return true;
  }

  /// Removes the first message. Returns false if the queue is empty.
  bool pop(Message& message) noexcept {
    if (size_ == 0) {
      return false;
    }
    message = entries_[0].message;
    entries_[0] = entries_[--size_];
    sift_down();
    return true;
  }

 private:
  struct Entry {
    Message message;
    std::uint64_t arrival = 0;
  };

  static bool before(const Entry& a, const Entry& b) noexcept {
    const int difference = urgency(a.message) - urgency(b.message);
    return difference > 0 || (difference == 0 && a.arrival < b.arrival);
  }
  void swap(std::size_t i, std::size_t j) noexcept {
    const Entry entry = entries_[i];
    entries_[i] = entries_[j];
    entries_[j] = entry;
  }
  void sift_down() noexcept {
    std::size_t place = 0;
    for (std::size_t child = 1; child < size_; child = 2 * place + 1) {
      if (child + 1 < size_ && before(entries_[child + 1], entries_[child])) {
        ++child;
      }
      if (!before(entries_[child], entries_[place])) {
        return;
      }
      swap(place, child);
      place = child;
    }
  }

  std::array<Entry, capacity> entries_{};
  std::size_t size_ = 0;
  std::uint64_t arrivals_ = 0;
};

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
