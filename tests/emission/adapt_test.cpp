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

// Would catch: a branch of text or code that stays for another robot, that loses its other half, or
// whose lines stand where they stood within it.
TEST(Adapt, ChoosesBranches) {
  Adaptation own = make_adaptation(test::sample_context("arm", false, Language::c), "arm.h");
  own.words["TL_SLIDING"] = "1";
  own.words["TL_BALLS"] = "0";
  EXPECT_EQ(adapt_words(R"(#if TL_BALLS
balls
#else
none
#endif
  if (TL_SLIDING) {
    if (x) {
      slide();
    } else {
      if (TL_BALLS) {
        roll();
      } else {
        rest();
      }
    }
  } else {
    (void)x;
  }
  if (TL_ZERO < x) {
  }
)",
                        own),
            R"(none
  if (x) {
    slide();
  } else {
    rest();
  }
  if (0.0 < x) {
  }
)");
}

TEST(Adapt, NamesParts) {
  for (const Language language : {Language::c, Language::cpp}) {
    Adaptation own = make_adaptation(test::sample_context("arm", false, language), "arm.h");
    own.part = "loops";
    EXPECT_EQ(adapt("#pragma once\nTlLink tl_links[TL_LINKS];\n", own),
              language == Language::c
                  ? "#pragma once\n// Generated; see arm.h for the contract.\n"
                    "arm_loops_link arm_loops_links[ARM_LOOPS_LINKS];\n"
                  : "#pragma once\n// Generated; see arm.h for the contract.\n"
                    "namespace arm {\nnamespace detail {\nnamespace loops {\n\n"
                    "Link links[kLinks];\n"
                    "\n}  // namespace loops\n}  // namespace detail\n}  // namespace arm\n");
  }
}

}  // namespace
}  // namespace treeline
