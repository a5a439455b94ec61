// SPDX-License-Identifier: 0BSD
#ifndef TREELINE_UR10E_DAMPED_SIZES_HPP
#define TREELINE_UR10E_DAMPED_SIZES_HPP
// Sizes of arrays that damped_solve.hpp computes in.
// Generated; see ur10e_damped.hpp for the contract.

#include <stdint.h>

#include "ur10e.hpp"

namespace ur10e {
namespace detail {

inline constexpr int32_t kSweeps = 20;  // of QL, as many as any matrix of this size takes
inline constexpr int32_t kRotations = 200;  // numbers that describe them, at least one

}  // namespace detail
}  // namespace ur10e

#endif  // TREELINE_UR10E_DAMPED_SIZES_HPP
