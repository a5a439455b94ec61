#include <gtest/gtest.h>

#include <atomic>
#include <numeric>
#include <vector>

#include "batch/transpose.hpp"
#include "batch/workers.hpp"

namespace treeline::batch {
namespace {

// Would catch: a state that is left out or computed twice at the end of a batch, and a thread that
// misses a batch or works on one that is over.
TEST(Workers, DoEachStateOnce) {
  for (const unsigned threads : {1U, 2U, 5U}) {
    Workers workers(threads);
    EXPECT_EQ(workers.threads(), threads);
    for (std::size_t states = 0; states < 200; ++states) {
      std::vector<std::atomic<int>> done(states);
      workers.run(states, 8, [&](Part part) {
        EXPECT_GE(part.count, 1U);
        EXPECT_LE(part.count, 8U);
        for (std::size_t k = 0; k < part.count; ++k) ++done[part.first + k];
      });
      for (const auto& count : done) ASSERT_EQ(count, 1) << states << " states";
    }
  }
}

TEST(Workers, AtLeastOneThread) {
  EXPECT_GE(Workers().threads(), 1U);
}

// Would catch: rows and states that are mixed up, and unused lanes that are written back.
TEST(Transpose, ThereAndBack) {
  constexpr int kSize = 3;
  constexpr int kLanes = 4;
  std::vector<double> states(kSize * 10);
  std::iota(states.begin(), states.end(), 1);
  std::vector<double> back(states.size(), 0);
  for (const Part part : {Part{0, 4}, Part{4, 4}, Part{8, 1}}) {
    double rows[kSize][kLanes];
    gather(states.data(), part, rows);
    for (int i = 0; i < kSize; ++i) {
      for (std::size_t k = 0; k < kLanes; ++k) {
        const std::size_t state = part.first + std::min(k, part.count - 1);
        EXPECT_EQ(rows[i][k], states[state * kSize + static_cast<std::size_t>(i)]);
      }
    }
    scatter(rows, part, back.data());
  }
  for (std::size_t i = 0; i < states.size(); ++i) {
    EXPECT_EQ(back[i], i < 9 * kSize ? states[i] : 0);
  }
}

}  // namespace
}  // namespace treeline::batch
