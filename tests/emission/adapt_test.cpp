#include "emission/adapt.hpp"

#include <gtest/gtest.h>

#include "emission/sample.hpp"

// Would catch: a name that keeps the prefix of the source, that is changed in the middle of another
// one, or a header that is included by the other language's name.
namespace treeline {
namespace {

constexpr const char* kRowsHeader = R"(#pragma once
// Rows, see other_rows.h.

#include <stdbool.h>
#include <stdint.h>

#include "other_rows.h"

/// At most TL_MOST_ROWS.
struct TlRowSet {
  real rows[TL_MOST_ROWS];
};
typedef struct TlRowSet TlRowSet;

TL_INLINE real tl_first_of(const TlRowSet* set) {
  return (set->rows[0] > TL_ZERO) ? set->rows[0] : unreal_tl_zero;
}
)";

std::string adapt_for(Language language, bool single_precision) {
  const EmissionContext context = test::sample_context("arm", single_precision, language);
  return adapt(kRowsHeader,
               make_adaptation(context, language == Language::c ? "arm_rows.h" : "arm_rows.hpp"));
}

TEST(Adapt, PrefixesNamesInC) {
  EXPECT_EQ(adapt_for(Language::c, true), R"(#pragma once
// Rows, see other_rows.h.
// Generated; see arm_rows.h for the contract.

#include <stdbool.h>
#include <stdint.h>

#include "other_rows.h"

/// At most ARM_MOST_ROWS.
struct arm_row_set {
  float rows[ARM_MOST_ROWS];
};
typedef struct arm_row_set arm_row_set;

static inline float arm_first_of(const arm_row_set* set) {
  return (set->rows[0] > 0.0F) ? set->rows[0] : unreal_tl_zero;
}
)");
}

TEST(Adapt, PutsNamesIntoANamespaceInCpp) {
  EXPECT_EQ(adapt_for(Language::cpp, false), R"(#pragma once
// Rows, see other_rows.hpp.
// Generated; see arm_rows.hpp for the contract.

#include <stdint.h>

#include "other_rows.hpp"

namespace arm {
namespace detail {

/// At most kMostRows.
struct RowSet {
  double rows[kMostRows];
};

inline double first_of(const RowSet* set) {
  return (set->rows[0] > 0.0) ? set->rows[0] : unreal_tl_zero;
}

}  // namespace detail
}  // namespace arm
)");
}

}  // namespace
}  // namespace treeline
