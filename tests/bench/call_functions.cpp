// Calls the generated functions of ROBOT, compiled for x86-64-v3, in 64 states.
// count_instructions.sh counts the instructions.
#include <iostream>

#include "case.hpp"
#include "generated_subjects.hpp"

int main(int count, char** arguments) {
  using namespace treeline::bench;
  const auto robot = count == 2 ? read_case(arguments[1]) : std::nullopt;
  if (!robot) {
    std::cerr << "usage: treeline_bench_calls ROBOT\n";
    return 2;
  }
  const auto states = random_states(*robot, 64, 1);
  for (const Subject& subject : generated_subjects(arguments[1])) {
    if (subject.implementation.find("x86-64-v3") == std::string::npos) continue;
    for (const auto& [function, routine] : subject.routines) {
      std::vector<double> output(static_cast<std::size_t>(output_size(function, *robot)));
      for (const State& state : states) {
        std::vector<const double*> inputs;
        for (const auto* input : inputs_of(function, state)) inputs.push_back(input->data());
        routine(inputs.data(), output.data());
      }
    }
  }
  return 0;
}
