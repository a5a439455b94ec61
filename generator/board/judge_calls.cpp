#include <algorithm>

#include "board/check_on_board.hpp"
#include "check/judges.hpp"

namespace treeline {
namespace {

void note_bits_on_board(const GeneratedFunction& generated, const std::vector<double>& results,
                        const FunctionReference& reference, int state, BoardFunction& function) {
  if (are_bits_of_graph(generated, results, reference)) return;
  if (function.bits_differ++ == 0) function.first_bits_differ = state;
}

void note_error_on_board(const std::vector<double>& results, const FunctionReference& reference,
                         const Bound& bound, Real real, BoardFunction& function) {
  if (reference.singular) return;
  const double error = error_in_ulp(results, reference, unit_of(real));
  function.worst = std::max(function.worst, error);
  function.beyond_bound += error <= bound.at(reference) ? 0 : 1;
}

}  // namespace

void judge_calls(std::size_t i, const GeneratedFunction& generated, const BoardCalls& calls,
                 const std::vector<StateReference>& references, Real real, bool contracted,
                 BoardFunction& function) {
  const Bound bound = contracted ? find_bound(i, generated.function, references) : Bound{};
  for (std::size_t s = 0; s < references.size(); ++s) {
    const FunctionReference& reference = references[s].functions[i];
    note_bits_on_board(generated, calls.results[s], reference, references[s].state.index, function);
    if (contracted) note_error_on_board(calls.results[s], reference, bound, real, function);
  }
  function.states = static_cast<int>(references.size());
  function.stack_seen = calls.stack_seen;
  const auto [least, most] =
      std::minmax_element(calls.instructions.begin(), calls.instructions.end());
  function.least = *least;
  function.most = *most;
  function.cycles *= static_cast<double>(*most);
  const auto [shortest, longest] = std::minmax_element(calls.cycles.begin(), calls.cycles.end());
  function.least_cycles = *shortest;
  function.most_cycles = *longest;
}

}  // namespace treeline
