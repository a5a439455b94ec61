#include <gtest/gtest.h>

#include <cstdint>

#include "sample_c_double/sample_c_double.h"
#include "sample_c_double/sample_c_double_batch.h"
#include "sample_c_double/sample_c_double_prefetch.h"
#include "sample_double/sample_double.hpp"
#include "sample_double/sample_double_batch.h"
#include "sample_double/sample_double_batch.hpp"
#include "sample_double/sample_double_prefetch.h"
#include "sample_double/sample_double_prefetch.hpp"

extern "C" {
extern const char __start_treeline_sample_double_inverse_dynamics[];
extern const char __stop_treeline_sample_double_inverse_dynamics[];
extern const char __start_treeline_sample_c_double_inverse_dynamics[];
extern const char __stop_treeline_sample_c_double_inverse_dynamics[];
extern const char __start_treeline_sample_double_batch_inverse_dynamics[];
extern const char __stop_treeline_sample_double_batch_inverse_dynamics[];
extern const char __start_treeline_sample_c_double_batch_inverse_dynamics[];
extern const char __stop_treeline_sample_c_double_batch_inverse_dynamics[];
}

// Would catch: code that is loaded from where another function is or none, and a name that does not
// link. Whether it pays is measured: tests/bench/README.md.
namespace treeline {
namespace {

template <class Function>
bool is_within(const char* begin, const char* end, Function* function) {
  const auto address = reinterpret_cast<std::uintptr_t>(function);
  return address >= reinterpret_cast<std::uintptr_t>(begin) &&
         address < reinterpret_cast<std::uintptr_t>(end);
}

template <class Function>
void expect_within(const char* begin, const char* end, Function* function) {
  EXPECT_TRUE(is_within(begin, end, function));
  EXPECT_LT(end - begin, 4096);  // no other function is in the section
}

/// Code of batches may be long: `other` are functions that are elsewhere.
template <class Function, class... Other>
void expect_alone(const char* begin, const char* end, Function* function, Other*... other) {
  EXPECT_TRUE(is_within(begin, end, function));
  EXPECT_FALSE((is_within(begin, end, other) || ...));
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
  sample_double_prefetch_inverse_dynamics();  // C++ called as C
}

TEST(Prefetch, LoadsBatches) {
  expect_alone(__start_treeline_sample_double_batch_inverse_dynamics,
               __stop_treeline_sample_double_batch_inverse_dynamics,
               &sample_double::batch::inverse_dynamics, &sample_double::inverse_dynamics,
               &sample_double::batch::corner_cases, &sample_double_batch_inverse_dynamics);
  expect_alone(__start_treeline_sample_c_double_batch_inverse_dynamics,
               __stop_treeline_sample_c_double_batch_inverse_dynamics,
               &sample_c_double_batch_inverse_dynamics, &sample_c_double_inverse_dynamics,
               &sample_c_double_batch_corner_cases);
  sample_double::prefetch_batch_inverse_dynamics();
  sample_double_prefetch_batch_corner_cases();
  sample_c_double_prefetch_batch_inverse_dynamics();
}

}  // namespace
}  // namespace treeline
