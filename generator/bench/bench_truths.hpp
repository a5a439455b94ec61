#pragma once

#include <vector>

#include "bench/bench.hpp"
#include "bench/variant.hpp"
#include "oracle/reference.hpp"

namespace treeline {

/// The states at which a robot's variants are measured, with the truth there. Without a quaternion
/// in q all have the same, whose numbers float has exactly. With one, variants in double have
/// states of which every other quaternion has unit length as well as double has it, and the rest as
/// well as float; variants in float have what float can hold; peers, who take a quaternion for one
/// of unit length, have the states of double where it is.
class BenchTruths {
 public:
  /// The first functions of the references are `functions`.
  BenchTruths(const Robot& robot, const Scene& scene,
              const std::vector<GeneratedFunction>& functions, const BenchOptions& options);

  [[nodiscard]] const std::vector<StateReference>& of(const Variant& variant) const;
  /// Those whose numbers float has exactly.
  [[nodiscard]] const std::vector<StateReference>& in_float() const { return in_float_; }
  [[nodiscard]] bool has_quaternions() const { return has_quaternions_; }

 private:
  std::vector<StateReference> in_float_;
  std::vector<StateReference> in_double_, of_unit_length_;  ///< with a quaternion in q
  bool has_quaternions_ = false;
};

/// Whether a truth is to be compared with: the matrix solved with is regular in float too, so that
/// float and double answer the same questions.
bool is_comparable(const FunctionReference& truth);

}  // namespace treeline
