#include "packs.hpp"

namespace treeline::bench {

std::vector<Aligned> pack_inputs(Function function, std::span<const State> states) {
  std::vector<Aligned> packed;
  for (std::size_t s = 0; s < states.size(); ++s) {
    const auto inputs = inputs_of(function, states[s]);
    for (std::size_t k = 0; k < inputs.size(); ++k) {
      if (s == 0) packed.emplace_back(inputs[k]->size() * states.size());
      for (std::size_t i = 0; i < inputs[k]->size(); ++i) {
        packed[k][i * states.size() + s] = (*inputs[k])[i];
      }
    }
  }
  return packed;
}

std::vector<std::vector<double>> evaluate(const Routine& routine, Function function,
                                          const Case& robot, std::span<const State> states) {
  const auto size = static_cast<std::size_t>(output_size(function, robot));
  const auto packed = pack_inputs(function, states);
  std::vector<const double*> inputs;
  for (const auto& input : packed) inputs.push_back(input.data());
  Aligned output(size * states.size());
  routine(inputs.data(), output.data());
  if (routine.finish != nullptr) routine.finish(routine.solver.get(), output.data());
  std::vector<std::vector<double>> result(states.size(), std::vector<double>(size));
  for (std::size_t s = 0; s < states.size(); ++s) {
    for (std::size_t i = 0; i < size; ++i) result[s][i] = output[i * states.size() + s];
  }
  return result;
}

}  // namespace treeline::bench
