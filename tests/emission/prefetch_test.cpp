#include <gtest/gtest.h>

#include <cstdint>

#include "sample_c_double/sample_c_double.h"
#include "sample_c_double/sample_c_double_prefetch.h"
#include "sample_double/sample_double.hpp"
#include "sample_double/sample_double_prefetch.hpp"

extern "C" {
extern const char __start_treeline_sample_double_inverse_dynamics[];
extern const char __stop_treeline_sample_double_inverse_dynamics[];
extern const char __start_treeline_sample_c_double_inverse_dynamics[];
extern const char __stop_treeline_sample_c_double_inverse_dynamics[];
}

// Would catch: code that is loaded from where another function is or none, and a name that does not
// link. Whether it pays is measured: tests/bench/README.md.
namespace treeline {
namespace {

template <class Function>
void expect_within(const char* begin, const char* end, Function* function) {
  const auto address = reinterpret_cast<std::uintptr_t>(function);
  EXPECT_GE(address, reinterpret_cast<std::uintptr_t>(begin));
  EXPECT_LT(address, reinterpret_cast<std::uintptr_t>(end));
  EXPECT_LT(end - begin, 4096);  // no other function is in the section
}

TEST(Prefetch, LoadsTheFunctionsOwnSection) {
  expect_within(__start_treeline_sample_double_inverse_dynamics,
                __stop_treeline_sample_double_inverse_dynamics, &sample_double::inverse_dynamics);
  expect_within(__start_treeline_sample_c_double_inverse_dynamics,
                __stop_treeline_sample_c_double_inverse_dynamics,
                &sample_c_double_inverse_dynamics);
  sample_double::prefetch_inverse_dynamics();
  sample_double::prefetch_corner_cases();
  sample_c_double_prefetch_inverse_dynamics();
  sample_c_double_prefetch_corner_cases();
}

}  // namespace
}  // namespace treeline
