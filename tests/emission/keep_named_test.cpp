#include "emission/keep_named.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

// Would catch: a function or type that is left out though something that stays names it, and one
// that stays since its name begins another's, since it names itself or since a comment names it.
namespace treeline {
namespace {

constexpr const char* kHeader = R"(#pragma once
// All of it (and more).

#include <stdint.h>

/// A pair of tl_turn's.
struct TlPair {
  real x;
};
typedef struct TlPair TlPair;

TL_SIZES

typedef TlPair TlTwo;

TL_INLINE void tl_turn_back(real x) {
  tl_turn_back(x);
}

/// Turns, see tl_turn_back.
TL_INLINE void tl_turn(TlPair* pair) {
}

TL_INLINE void tl_move(
    TlPair* pair) {
  tl_turn(pair);
}
)";

std::string keep_for(std::vector<NameSet> users) {
  return keep_named(kHeader, users);
}

TEST(KeepNamed, KeepsWhatIsNamedInTurn) {
  const std::string kept = keep_for({NameSet{"tl_move"}});
  for (const char* text : {"#include <stdint.h>", "TL_SIZES", "struct TlPair {", "typedef struct",
                           "void tl_turn(", "void tl_move("}) {
    EXPECT_NE(kept.find(text), std::string::npos) << text;
  }
  for (const char* text : {"TlTwo", "void tl_turn_back("}) {
    EXPECT_EQ(kept.find(text), std::string::npos) << text;
  }
}

TEST(KeepNamed, KeepsNothingThatOnlyItselfNames) {
  const std::string kept = keep_for({NameSet{"tl_turns", "Tl"}});
  EXPECT_EQ(kept, "#pragma once\n// All of it (and more).\n\n#include <stdint.h>\n\nTL_SIZES\n\n");
  EXPECT_EQ(keep_for({NameSet{"TlTwo"}}).find("void"), std::string::npos);
}

// Would catch: what two users share as the own of one.
TEST(KeepNamed, MarksWhatOneUserHasAlone) {
  const std::string kept = keep_for({NameSet{"tl_move"}, NameSet{"tl_turn"}});
  EXPECT_NE(kept.find("\n\nTL_OWN_INLINE void tl_move("), std::string::npos) << kept;
  EXPECT_NE(kept.find("see tl_turn_back.\nTL_INLINE void tl_turn("), std::string::npos);
}

}  // namespace
}  // namespace treeline
