#pragma once

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace treeline::batch {

/// So many states that stand together: `count` of them from `first` on.
struct Part {
  std::size_t first = 0;
  std::size_t count = 0;
};

/// Threads that share the states of a large batch, for sampling control and learning on a host
/// computer. They are started once and sleep between batches.
class Workers {
 public:
  /// `threads` counts the caller's own; 0 asks for as many as the machine has cores.
  explicit Workers(unsigned threads = 0);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  [[nodiscard]] unsigned threads() const { return static_cast<unsigned>(sleepers_.size()) + 1; }

  /// Calls `work` for parts of at most `part_size` (at least 1) states that together are the states
  /// 0 .. states - 1, each once, on all threads; returns when all are done. Which thread gets which
  /// part is left to chance: what `work` writes must depend on its part alone, and then results do
  /// not depend on the number of threads. An exception of `work` ends the program, as it would on a
  /// thread of its own. One batch at a time.
  void run(std::size_t states, std::size_t part_size, const std::function<void(Part)>& work);

 private:
  struct Batch {
    std::size_t states = 0, part_size = 1, next = 0;
    unsigned busy = 0;  ///< threads that have not found the batch exhausted yet
    const std::function<void(Part)>* work = nullptr;
  };

  void sleep_and_work() noexcept;
  void work_off() noexcept;
  bool take(Part& part);

  std::mutex mutex_;
  std::condition_variable wake_, finished_;
  Batch batch_;
  std::size_t batches_ = 0;
  bool ends_ = false;
  std::vector<std::thread> sleepers_;
};

}  // namespace treeline::batch
