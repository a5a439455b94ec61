#pragma once

#include <vector>

#include "bench/bench.hpp"
#include "bench/variant.hpp"
#include "oracle/reference.hpp"

namespace treeline {

/// The states at which the variants of a robot are measured, with their references. If q has no
/// quaternion, all variants have the same states, with numbers that are exact in float. With
/// quaternions, variants in double have states in which every other quaternion has unit length as
/// exactly as double permits, the others as exactly as float does. Variants in float have numbers
/// that float can hold. Peers, which take a quaternion to be of unit length, have those states of
/// double where it is. If the scene holds rows, states of double keep its constraints, because
/// there alone all libraries mean the same, and all quaternions have unit length.
class BenchTruths {
 public:
  /// The references begin with those of `functions`.
  BenchTruths(const Robot& robot, const Scene& scene,
              const std::vector<GeneratedFunction>& functions, const BenchOptions& options);

  [[nodiscard]] const std::vector<StateReference>& of(const Variant& variant) const;
  /// References at states whose numbers are exact in float.
  [[nodiscard]] const std::vector<StateReference>& in_float() const { return in_float_; }
  [[nodiscard]] bool has_quaternions() const { return has_quaternions_; }
  /// Whether the scene holds rows and no state was found that keeps its constraints. Then variants
  /// in double have the states of float, and peers cannot be compared.
  [[nodiscard]] bool lacks_held_states() const { return holds_rows_ && in_double_.empty(); }
  /// References at the states at which calls are timed.
  [[nodiscard]] const std::vector<StateReference>& timed() const {
    return holds_rows_ && !in_double_.empty() ? in_double_ : in_float_;
  }

 private:
  std::vector<StateReference> in_float_;
  /// Only with a quaternion in q, or with rows held.
  std::vector<StateReference> in_double_, of_unit_length_;
  bool has_quaternions_ = false;
  bool holds_rows_ = false;
};

/// Whether a reference can be compared. The matrix of its solve must also be regular in float, so
/// that float and double are compared at the same states.
bool is_comparable(const FunctionReference& truth);

}  // namespace treeline
