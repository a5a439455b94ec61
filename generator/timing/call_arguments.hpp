#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "generation/generate_code.hpp"
#include "oracle/draw_state.hpp"

namespace treeline {

/// Draws states of a robot for timing: anywhere within its limits, at ordinary velocities. Equal
/// seeds give equal states. `functions` determine which arguments are needed; they may be those of
/// all builds to compare or of one of them.
std::vector<State> draw_timing_states(const Robot& robot, const Scene& scene,
                                      const Mechanism& mechanism,
                                      const std::vector<GeneratedFunction>& functions,
                                      int count = 64, std::uint64_t seed = 1);

/// Arguments of a compiled function at several states, in its Real, aligned to 64 bytes, and memory
/// for its results. Each call of a batch function takes as many states as the batch has, in turn.
/// One object serves every build of the function. Each call overwrites the results of earlier ones.
class CallArguments {
 public:
  CallArguments(const GeneratedFunction& function, const std::vector<State>& states, Real real);
  CallArguments(CallArguments&&) = default;
  CallArguments& operator=(CallArguments&&) = default;
  CallArguments(const CallArguments&) = delete;  // `in_` and `out_` point into `arrays_`
  CallArguments& operator=(const CallArguments&) = delete;
  ~CallArguments() = default;

  /// Number of different calls, one for each state.
  [[nodiscard]] std::size_t calls() const { return in_.size(); }
  [[nodiscard]] const void* const* in(std::size_t call) const { return in_[call].data(); }
  [[nodiscard]] void* const* out() const { return out_.data(); }
  /// Memory that a call reads and writes.
  [[nodiscard]] std::vector<std::span<const std::byte>> bytes_of(std::size_t call) const;

 private:
  struct alignas(64) Line {
    unsigned char bytes[64];
  };
  using Array = std::vector<Line>;

  template <class T>
  void lay_out(const GeneratedFunction& function, const std::vector<State>& states);

  std::vector<Array> arrays_;  ///< of all calls: argument by argument, then results
  std::vector<std::vector<const void*>> in_;
  std::vector<void*> out_;
};

}  // namespace treeline
