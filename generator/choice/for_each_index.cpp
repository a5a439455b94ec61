#include "choice/for_each_index.hpp"

#include <algorithm>
#include <atomic>
#include <future>
#include <thread>
#include <vector>

namespace treeline {

void for_each_index(std::size_t count, const std::function<void(std::size_t)>& work, int threads) {
  const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
  const std::size_t wanted = threads > 0 ? static_cast<std::size_t>(threads) : cores;
  std::atomic<std::size_t> next = 0;
  const auto work_on = [&] {
    for (std::size_t i = next++; i < count; i = next++) work(i);
  };
  std::vector<std::future<void>> others;
  for (std::size_t i = 1; i < std::min(wanted, count); ++i) {
    others.push_back(std::async(std::launch::async, work_on));
  }
  work_on();
  for (auto& other : others) other.get();
}

}  // namespace treeline
