#pragma once

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace treeline::batch {

/// A contiguous range of states: `count` states beginning with `first`.
struct Part {
  std::size_t first = 0;
  std::size_t count = 0;
};

/// Threads that share the states of a large batch, for sampling-based control and learning on a
/// host computer. They are started once and sleep between batches.
class Workers {
 public:
  /// `threads` includes the calling thread; 0 means as many as the machine has cores.
  explicit Workers(unsigned threads = 0);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  [[nodiscard]] unsigned threads() const { return static_cast<unsigned>(sleepers_.size()) + 1; }

  /// Calls `work` on all threads for parts of at most `part_size` (at least 1) states, which
  /// together are the states 0 .. states - 1, each once. Returns when all are done. Any thread may
  /// get any part, so `work` must write only what depends on its part; the results then do not
  /// depend on the number of threads. An exception in `work` ends the program, as in any thread.
  /// One batch at a time.
  void run(std::size_t states, std::size_t part_size, const std::function<void(Part)>& work);

 private:
  struct Batch {
    std::size_t states = 0, part_size = 1, next = 0;
    unsigned busy = 0;  ///< threads that may still find work in the batch
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
