#pragma once

#include <cstddef>

#include "batch/workers.hpp"

namespace treeline::batch {

/// Fills the rows of a batch function's argument from states that are stored one after the other,
/// `size` numbers each: `rows[i][k] = states[(part.first + k) * size + i]`. `part.count` is from 1
/// to `lanes`. Unused lanes repeat the last state, so that their numbers are sensible.
template <class Real, int size, int lanes>
void gather(const Real* states, Part part, Real (&rows)[size][lanes]) {
  for (int k = 0; k < lanes; ++k) {
    const auto lane = static_cast<std::size_t>(k);
    const std::size_t state = part.first + (lane < part.count ? lane : part.count - 1);
    for (int i = 0; i < size; ++i) {
      rows[i][k] = states[state * size + static_cast<std::size_t>(i)];
    }
  }
}

/// Writes the rows of a batch function's result to the states of `part`: the inverse of `gather`.
/// Unused lanes are not written.
template <class Real, int size, int lanes>
void scatter(const Real (&rows)[size][lanes], Part part, Real* states) {
  for (std::size_t k = 0; k < part.count; ++k) {
    for (int i = 0; i < size; ++i) {
      states[(part.first + k) * size + static_cast<std::size_t>(i)] = rows[i][k];
    }
  }
}

}  // namespace treeline::batch
