#pragma once
// Queue of a loop's waiting messages, for a single thread. C++17, freestanding, fixed size.

#include <stddef.h>
#include <stdint.h>

#include "core/mode.hpp"

namespace treeline::core {

/// Priority queue Q of Chang fig. 9.2: the most urgent message first, equally urgent ones in the
/// order of their arrival. A binary heap of fixed capacity. `Message` has a member `kind`.
template <class Message, size_t capacity>
class MessageQueue {
 public:
  bool empty() const noexcept { return size_ == 0; }
  size_t size() const noexcept { return size_; }

  /// Inserts a message. Returns false, and does not insert it, if the queue is full.
  bool insert(const Message& message) noexcept {
    if (size_ == capacity) {
      return false;
    }
    size_t place = size_++;
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
    uint64_t arrival = 0;
  };

  static bool before(const Entry& a, const Entry& b) noexcept {
    const int difference = urgency(a.message.kind) - urgency(b.message.kind);
    return difference > 0 || (difference == 0 && a.arrival < b.arrival);
  }
  void swap(size_t i, size_t j) noexcept {
    const Entry entry = entries_[i];
    entries_[i] = entries_[j];
    entries_[j] = entry;
  }
  void sift_down() noexcept {
    size_t place = 0;
    for (size_t child = 1; child < size_; child = 2 * place + 1) {
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

  Entry entries_[capacity] = {};
  size_t size_ = 0;
  uint64_t arrivals_ = 0;
};

}  // namespace treeline::core
