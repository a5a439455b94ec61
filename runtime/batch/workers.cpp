#include "batch/workers.hpp"

#include <algorithm>

namespace treeline::batch {

Workers::Workers(unsigned threads) {
  const unsigned wanted = threads > 0 ? threads : std::max(1U, std::thread::hardware_concurrency());
  for (unsigned i = 1; i < wanted; ++i) {
    sleepers_.emplace_back([this] { sleep_and_work(); });
  }
}

Workers::~Workers() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  wake_.notify_all();
  for (std::thread& sleeper : sleepers_) {
    sleeper.join();
  }
}

void Workers::run(std::size_t states, std::size_t part_size,
                  const std::function<void(Part)>& work) {
  {
    const std::lock_guard lock(mutex_);
    batch_ = {states, std::max<std::size_t>(part_size, 1), 0, threads(), &work};
    ++batches_;
  }
  wake_.notify_all();
  work_off();
  std::unique_lock lock(mutex_);
  finished_.wait(lock, [this] { return batch_.busy == 0; });
}

void Workers::sleep_and_work() noexcept {
  for (std::size_t seen = 0;; ++seen) {
    {
      std::unique_lock lock(mutex_);
      wake_.wait(lock, [&] { return ends_ || batches_ > seen; });
      if (ends_) return;
    }
    work_off();
  }
}

void Workers::work_off() noexcept {
  for (Part part; take(part);) {
    (*batch_.work)(part);
  }
  const std::lock_guard lock(mutex_);
  if (--batch_.busy == 0) finished_.notify_one();
}

bool Workers::take(Part& part) {
  const std::lock_guard lock(mutex_);
  if (batch_.next >= batch_.states) return false;
  part.first = batch_.next;
  part.count = std::min(batch_.part_size, batch_.states - batch_.next);
  batch_.next += part.count;
  return true;
}

}  // namespace treeline::batch
