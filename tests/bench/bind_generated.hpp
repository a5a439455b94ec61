#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>

#include "subject.hpp"

namespace treeline::bench {
namespace detail {

/// For parameter I among the references to arrays A...: the number of inputs before it, and of
/// output entries before it.
template <std::size_t I, class... A>
constexpr std::pair<std::size_t, std::size_t> places_before() {
  constexpr bool kInput[] = {std::is_const_v<std::remove_all_extents_t<A>>...};
  constexpr std::size_t kSize[] = {sizeof(A) / sizeof(double)...};
  std::pair<std::size_t, std::size_t> count{0, 0};
  for (std::size_t k = 0; k < I; ++k) {
    if (kInput[k]) {
      count.first += 1;
    } else {
      count.second += kSize[k];
    }
  }
  return count;
}

template <std::size_t I, class Array, class... A>
Array& argument(const double* const* in, double* out) {
  constexpr auto kPlaces = places_before<I, A...>();
  if constexpr (std::is_const_v<std::remove_all_extents_t<Array>>) {
    return *reinterpret_cast<Array*>(in[kPlaces.first]);
  } else {
    return *reinterpret_cast<Array*>(out + kPlaces.second);
  }
}

template <auto kFunction>
struct Bound;

template <class... A, void (*kFunction)(A&...) noexcept>
struct Bound<kFunction> {
  static void call(void*, const double* const* in, double* out) {
    call_with(in, out, std::index_sequence_for<A...>());
  }
  template <std::size_t... I>
  static void call_with(const double* const* in, double* out, std::index_sequence<I...>) {
    kFunction(argument<I, A, A...>(in, out)...);
  }
};

/// Recorded code already has the arguments of the plain call.
template <void (*kFunction)(const double* const*, double*) noexcept>
struct Bound<kFunction> {
  static void call(void*, const double* const* in, double* out) { kFunction(in, out); }
};

}  // namespace detail

/// Puts a generated function behind the plain call: inputs in their order, outputs one after the
/// other.
template <auto kFunction>
Routine bind_generated(int states = 1) {
  return {&detail::Bound<kFunction>::call, nullptr, states};
}

}  // namespace treeline::bench
