#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "random_mechanism.hpp"

namespace treeline::tests {

/// A small fault planted into a generated source.
enum class Mutation {
  constant,  ///< a literal is 1 % larger
  hair,      ///< a literal is 1e-9 larger
  sign,      ///< a plus for a minus or the other way round, or a value negated
  index,     ///< another element of an array is read or written
  name,      ///< another value that was computed before is used
};
inline constexpr std::array kMutations = {Mutation::constant, Mutation::hair, Mutation::sign,
                                          Mutation::index, Mutation::name};
const char* mutation_name(Mutation mutation);

/// A text with one fault, and a description of the fault.
struct Mutant {
  Mutation mutation{};
  std::string text;         ///< of the whole file
  std::string description;  ///< the line before and after
};

/// Lists all places in the function's statements where a fault of this kind is possible. Comments,
/// signature and the call for sine and cosine are excluded.
std::vector<Mutant> mutants_of(const std::string& source, Mutation mutation, Rng& rng);

}  // namespace treeline::tests
