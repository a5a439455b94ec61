#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "bounds/trig_polynomial.hpp"
#include "program/hash_word.hpp"

namespace treeline::bounds {

/// Remembers values by sequences of words. There are very many, which go all at once: they lie one
/// after the other in memory that is returned as a whole.
template <class Value>
class WordMemo {
 public:
  using Words = std::span<const std::uint64_t>;

  WordMemo() = default;
  WordMemo(const WordMemo&) = delete;
  WordMemo& operator=(const WordMemo&) = delete;

  /// The value of these words; null if there is none. Valid as long as this object.
  [[nodiscard]] const Value* find(Words words) const {
    const auto found = values_.find(words);
    return found == values_.end() ? nullptr : &found->second;
  }
  /// Remembers a value of words that have none.
  const Value& add(Words words, Value value) {
    std::pmr::polymorphic_allocator<std::uint64_t> allocator(&memory_);
    std::uint64_t* const kept = allocator.allocate(words.size());
    std::copy(words.begin(), words.end(), kept);
    return values_.emplace(Words(kept, words.size()), std::move(value)).first->second;
  }

 private:
  struct Hash {
    std::size_t operator()(Words words) const {
      std::uint64_t hash = words.size();
      for (const std::uint64_t word : words) hash = hash_word(hash, word);
      return static_cast<std::size_t>(hash);
    }
  };
  struct Equal {
    bool operator()(Words a, Words b) const {
      return std::equal(a.begin(), a.end(), b.begin(), b.end());
    }
  };

  std::pmr::monotonic_buffer_resource memory_;
  std::pmr::unordered_map<Words, Value, Hash, Equal> values_{&memory_};
};

/// Remembers norms of matrices. The same matrices recur because a joint turns many vectors in the
/// same way.
class NormMemo {
 public:
  struct Norms {
    std::vector<double> columns;  ///< see `column_norms`
    double scaled = 0;            ///< see `operator_norm`, with these columns as scale
  };

  const Norms& of(const TrigMatrix& A);

 private:
  WordMemo<Norms> found_;
  std::vector<std::uint64_t> key_;  ///< everything that the norms asked for depend on
};

}  // namespace treeline::bounds
