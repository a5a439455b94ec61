#include "timing/call_arguments.hpp"

#include <algorithm>

#include "oracle/reference.hpp"

namespace treeline {

std::vector<State> draw_timing_states(const Robot& robot, const Scene& scene,
                                      const Mechanism& mechanism,
                                      const std::vector<GeneratedFunction>& functions, int count,
                                      std::uint64_t seed) {
  const StateSpace space = make_state_space(robot, scene, mechanism, functions, seed);
  std::vector<State> states;
  for (int index = 0; static_cast<int>(states.size()) < count; ++index) {
    if (class_of_state(index) == StateClass::random) states.push_back(draw_state(space, index));
  }
  return states;
}

CallArguments::CallArguments(const GeneratedFunction& function, const std::vector<State>& states,
                             Real real) {
  if (real == Real::float32) {
    lay_out<float>(function, states);
  } else {
    lay_out<double>(function, states);
  }
}

std::vector<std::span<const std::byte>> CallArguments::bytes_of(std::size_t call) const {
  std::vector<std::span<const std::byte>> bytes;
  const std::size_t arguments = in_[call].size();
  const std::size_t results = in_.size() * arguments;
  for (std::size_t i = 0; i < arrays_.size(); ++i) {
    const bool is_read = i >= call * arguments && i < (call + 1) * arguments;
    if (is_read || i >= results) bytes.push_back(std::as_bytes(std::span(arrays_[i])));
  }
  return bytes;
}

template <class T>
void CallArguments::lay_out(const GeneratedFunction& function, const std::vector<State>& states) {
  const auto batch = static_cast<std::size_t>(std::max(function.batch, 1));
  const auto make_array = [&](std::size_t entries) {
    arrays_.emplace_back((entries * batch * sizeof(T) + sizeof(Line) - 1) / sizeof(Line), Line{});
    return reinterpret_cast<T*>(arrays_.back().data());
  };
  for (std::size_t call = 0; call < states.size(); ++call) {
    std::vector<const void*>& in = in_.emplace_back();
    for (const Argument& argument : function.program.arguments) {
      in.push_back(make_array(static_cast<std::size_t>(argument.rows * argument.cols)));
    }
    for (std::size_t k = 0; k < batch; ++k) {
      const auto values = arguments_of(function.program, states[(call + k) % states.size()]);
      for (std::size_t a = 0; a < values.size(); ++a) {
        T* const entries = const_cast<T*>(static_cast<const T*>(in[a]));
        for (std::size_t i = 0; i < values[a]->size(); ++i) {
          entries[i * batch + k] = static_cast<T>((*values[a])[i]);
        }
      }
    }
  }
  for (const Result& result : function.program.results)
    out_.push_back(make_array(result.values.size()));
}

}  // namespace treeline
