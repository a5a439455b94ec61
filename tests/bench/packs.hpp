#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "case.hpp"
#include "subject.hpp"

namespace treeline::bench {

/// An array of numbers that begins at a cache line.
class Aligned {
 public:
  explicit Aligned(std::size_t size) : room_(size + kLine, 0.0), size_(size) {
    const auto at = reinterpret_cast<std::uintptr_t>(room_.data()) / sizeof(double);
    offset_ = (kLine - at % kLine) % kLine;
  }
  Aligned(Aligned&&) = default;
  Aligned& operator=(Aligned&&) = default;
  Aligned(const Aligned&) = delete;
  Aligned& operator=(const Aligned&) = delete;
  ~Aligned() = default;

  double* data() { return room_.data() + offset_; }
  [[nodiscard]] const double* data() const { return room_.data() + offset_; }
  [[nodiscard]] std::size_t size() const { return size_; }
  double& operator[](std::size_t i) { return data()[i]; }
  double operator[](std::size_t i) const { return data()[i]; }

 private:
  static constexpr std::size_t kLine = 8;  // doubles
  std::vector<double> room_;
  std::size_t size_, offset_ = 0;
};

/// Inputs of one call that takes all of `states`: element i of input k of state s is [k][i *
/// states.size() + s].
std::vector<Aligned> pack_inputs(Function function, std::span<const State> states);

/// Results of one call for all of `states`: the output for each state, as in the contract.
std::vector<std::vector<double>> evaluate(const Routine& routine, Function function,
                                          const Case& robot, std::span<const State> states);

}  // namespace treeline::bench
