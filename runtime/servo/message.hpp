#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace treeline::servo {

/// What a front end may ask of the loop. The first five concern the loop, in falling urgency; the
/// others are handed to the controller.
enum class MessageKind : std::uint8_t {
  emergency_stop,  ///< to the safe state now
  disconnect,      ///< the front end leaves: stop, then end
  stop,            ///< brake to rest
  reset,           ///< leave the fault
  start,           ///< control from the present state on
  move_point,      ///< index: point; values: position (3), rotation row-major (9); duration
  set_posture,     ///< values: advised q
  set_gains,       ///< values: kp, kv
};

inline constexpr std::size_t kMessageNumbers = 64;

/// A command of fixed size.
struct Message {
  MessageKind kind = MessageKind::stop;
  int index = 0;
  double duration = 0.0;  ///< s
  std::array<double, kMessageNumbers> values{};
};

/// Whether `a` is taken before `b` whenever both wait: the order of MessageKind up to `start`, then
/// all alike.
constexpr int urgency(const Message& message) noexcept {
  constexpr int kLeast = static_cast<int>(MessageKind::move_point);
  const int kind = static_cast<int>(message.kind);
  return kind < kLeast ? kLeast - kind : 0;
}

/// The priority queue Q of Chang fig. 9.2: the most urgent message first, equally urgent ones in
/// the order in which they came. A binary heap of fixed capacity; for one thread.
template <std::size_t capacity>
class MessageQueue {
 public:
  bool empty() const noexcept { return size_ == 0; }
  std::size_t size() const noexcept { return size_; }

  /// False when full; the message is then not taken.
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

  /// False when empty.
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

/// Ring between one writing and one reading thread; neither ever waits. `Item` is a plain value.
template <class Item, std::size_t capacity>
class Ring {
 public:
  /// False when full; the item is then not taken.
  bool push(const Item& item) noexcept {
    const std::size_t end = end_.load(std::memory_order_relaxed);
    if (end - begin_.load(std::memory_order_acquire) == capacity) {
      return false;
    }
    items_[end % capacity] = item;
    end_.store(end + 1, std::memory_order_release);
    return true;
  }
  /// False when empty.
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

/// Where the front end leaves messages for the loop.
using Mailbox = Ring<Message, 32>;

}  // namespace treeline::servo
