#include "emission/c/translate_loops.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "emission/core_headers.hpp"

// Would catch: loops over links that C gets otherwise than C++ has them, and a part of C++ that is
// passed on to C unread. Whether C computes the same is for `check`: link_loops_test.cpp there.
namespace treeline {
namespace {

EmissionContext arm() {
  EmissionContext context;
  context.name = "arm";
  context.single_precision = true;
  return context;
}

std::string in_c(const std::string& declarations, bool given_sines = false,
                 const c::LoopTable& table = {}) {
  c::LoopTranslator translator(arm(), table, given_sines);
  std::string text;
  for (const LoopItem& item : parse_loops("namespace treeline::core::loops {\n" + declarations +
                                          "}  // namespace treeline::core::loops\n")) {
    text += translator.translate(item);
  }
  return text;
}

const std::string kPair =
    "template <class Real>\n"
    "struct Pair {\n"
    "  Real c, s;  ///< of an angle\n"
    "};\n";

TEST(TranslateLoops, NamesTypesAndSizesOfTheRobot) {
  EXPECT_EQ(in_c(kPair + "/// Work space.\n"
                         "template <class Real, int links>\n"
                         "struct Turns {\n"
                         "  Pair<Real> pairs[2 * links];\n"
                         "  int rows = 0;\n"
                         "};\n"),
            "typedef struct {\n"
            "  float c, s;  ///< of an angle\n"
            "} arm_loops_pair;\n"
            "/// Work space.\n"
            "typedef struct {\n"
            "  arm_loops_pair pairs[2 * ARM_LOOPS_LINKS];\n"
            "  int rows;\n"
            "} arm_loops_turns;\n");
}

TEST(TranslateLoops, MakesReferencesPointers) {
  EXPECT_EQ(
      in_c(kPair + "template <int power, class Real>\n"
                   "inline void turn(const Pair<Real>& r, const Real& by, Real& x) noexcept {\n"
                   "  static_assert(power > 0, \"\");\n"
                   "  if constexpr (power == 2) x = x * by;\n"
                   "  x = r.c * x -\n"
                   "      r.s;  // once\n"
                   "}\n"
                   "template <class Real>\n"
                   "void twice(Pair<Real>& r, Real (&v)[3]) noexcept {\n"
                   "  Real& first = v[0];\n"
                   "  turn<2>(r, Real(2.0), first);\n"
                   "  turn<3, Real>(r, first, r.s);\n"
                   "}\n"),
      "typedef struct {\n"
      "  float c, s;  ///< of an angle\n"
      "} arm_loops_pair;\n"
      "static inline void arm_loops_turn(int power, const arm_loops_pair* r, float by, "
      "float* x) {\n"
      "  if (power == 2) *x = *x * by;\n"
      "  *x = r->c * *x - r->s;  // once\n"
      "}\n"
      "static inline void arm_loops_twice(arm_loops_pair* r, float v[3]) {\n"
      "  float* const first = &v[0];\n"
      "  arm_loops_turn(2, r, 2.0F, first);\n"
      "  arm_loops_turn(3, r, *first, &r->s);\n"
      "}\n");
}

TEST(TranslateLoops, TakesSinesWhereTheyAreGiven) {
  const std::string place =
      kPair +
      "template <class Real>\n"
      "void take_sines(int i, int at, const Real& q, const Real& s, const Real& c,\n"
      "                Pair<Real>& turn) noexcept {\n"
      "  if constexpr (Table::kOwnSines) {\n"
      "    sin_cos(q, turn.s, turn.c);\n"
      "  }\n"
      "}\n"
      "template <class Real, class Sines>\n"
      "void place(int i, const Real& q, const Sines& sines, Pair<Real>& r) noexcept {\n"
      "  sines(i, i, 2 * i, q, r);\n"
      "}\n";
  EXPECT_THAT(in_c(place, false, {.own_sines = true}),
              ::testing::AllOf(::testing::HasSubstr("  arm_sin_cos_of(q, &turn->s, &turn->c);\n"),
                               ::testing::HasSubstr("place(int i, float q, arm_loops_pair* r) {\n"
                                                    "  arm_sin_cos_of(q, &r->s, &r->c);\n")));
  EXPECT_THAT(
      in_c(place, true),
      ::testing::AllOf(::testing::Not(::testing::HasSubstr("sin_cos_of")),
                       ::testing::HasSubstr(
                           "  arm_loops_take_sines(i, i, q, sin_q[2 * i], cos_q[2 * i], r);\n")));
}

// Would catch: a reference to a struct as a result that C has as a copy.
TEST(TranslateLoops, GivesStructsByPointers) {
  EXPECT_EQ(in_c(kPair + "template <class Real>\n"
                         "const Pair<Real>& pick(const Pair<Real>* pairs, int16_t i) noexcept {\n"
                         "  const Pair<Real>* pair = &pairs[i];\n"
                         "  return *pair;\n"
                         "}\n"),
            in_c(kPair) +
                "static inline const arm_loops_pair* arm_loops_pick(const arm_loops_pair* pairs, "
                "int16_t i) {\n"
                "  const arm_loops_pair* pair = &pairs[i];\n"
                "  return pair;\n"
                "}\n");
}

// Would catch: a branch for other robots in the code of this one, which compilers of C see as a
// condition on a constant, and one of this robot that is lost.
TEST(TranslateLoops, ChoosesTheBranchesOfTheRobot) {
  const std::string place =
      "template <class Table>\n"
      "int place(int i) noexcept {\n"
      "  if constexpr (Table::kFloats) {\n"
      "    if (i > 0) {\n"
      "      i = i + 5;\n"
      "    }\n"
      "  } else {\n"
      "    static_cast<void>(i);\n"
      "  }\n"
      "  return i;\n"
      "}\n";
  const std::string head = "static inline int arm_loops_place(int i) {\n";
  EXPECT_EQ(in_c(place, false, {true, false, false}), head +
                                                          "  if (i > 0) {\n"
                                                          "    i = i + 5;\n"
                                                          "  }\n"
                                                          "  return i;\n"
                                                          "}\n");
  EXPECT_EQ(in_c(place, false, {false, true, true}), head +
                                                         "  (void)i;\n"
                                                         "  return i;\n"
                                                         "}\n");
}

TEST(TranslateLoops, RefusesWhatItDoesNotUnderstand) {
  const auto function = [](const std::string& body) {
    return "template <class Real>\nvoid f(Real& x) noexcept {\n" + body + "}\n";
  };
  EXPECT_NO_THROW(in_c(function("  x = x + x;\n")));
  EXPECT_THROW(in_c(function("  x = std::abs(x);\n")), std::logic_error);
  EXPECT_THROW(in_c(function("  auto y = x;\n")), std::logic_error);
  EXPECT_THROW(in_c(function("  f(x, x);\n")), std::logic_error);
  EXPECT_THROW(in_c(function("  if constexpr (Table::kFlies) {\n    x = x;\n  }\n")),
               std::logic_error);
  EXPECT_THROW(in_c(function("  x = Table::kFloats ? x : x;\n")), std::logic_error);
  EXPECT_THROW(in_c("void f(std::span<double> x) noexcept {\n}\n"), std::logic_error);
  EXPECT_THROW(in_c("double f(int i) {\n}\n"), std::logic_error);
  EXPECT_THROW(parse_loops("namespace treeline::core {\n}\n"), std::logic_error);
}

// Every header, as emitted: nothing of it is lost.
TEST(TranslateLoops, HasEveryFunctionOfTheHeaders) {
  c::LoopTranslator translator(arm(), {}, false);
  constexpr std::string_view kFunction = ") noexcept {\n";
  for (const std::string_view header :
       {core_headers::kLinkVectors, core_headers::kLinkTable, core_headers::kLinkPose,
        core_headers::kLinkFactors, core_headers::kLinkFriction, core_headers::kLinkMotion,
        core_headers::kLinkInertia, core_headers::kLinkMatrix, core_headers::kLinkArticulation,
        core_headers::kLinkRows, core_headers::kLinkFunctions, core_headers::kLinkInputs}) {
    int expected = 0;
    int found = 0;
    for (std::size_t at = 0; (at = header.find(kFunction, at)) != header.npos; ++at) ++expected;
    for (const LoopItem& item : parse_loops(header)) {
      found += translator.translate(item).find("static ") != std::string::npos ? 1 : 0;
    }
    EXPECT_GT(expected, 2) << header.substr(0, 100);
    EXPECT_EQ(found, expected) << header.substr(0, 100);
  }
}

}  // namespace
}  // namespace treeline
