// Would catch: names that do not compile, and two names with characters beyond ASCII that become
// equal.
#include "text/identifier.hpp"

#include <gtest/gtest.h>

#include "text/printable.hpp"

namespace treeline {
namespace {

TEST(Identifier, AcceptsWhatCompiles) {
  for (const char* name : {"puma560", "left_hand", "A", "x1_2", "J1"}) {
    EXPECT_TRUE(is_identifier(name)) << name;
  }
}

TEST(Identifier, RefusesReservedAndForeign) {
  for (const char* name : {"", "1arm", "_arm", "left__hand", "left-hand", "a b", "class", "std",
                           "main", "j1", "arm\xC3\xA4", "co_await", "xor", "Real", "yn"}) {
    EXPECT_FALSE(is_identifier(name)) << name;
  }
}

// Would catch: a namespace that is a macro of a C header included before.
TEST(Identifier, RefusesWhatHeadersOfCDefine) {
  for (const char* name : {"EOF",
                           "NULL",
                           "errno",
                           "stdin",
                           "stdout",
                           "stderr",
                           "M_PI",
                           "INFINITY",
                           "NAN",
                           "HUGE_VAL",
                           "assert",
                           "EINVAL",
                           "SIGINT",
                           "RAND_MAX",
                           "INT_MAX",
                           "UINT8_MAX",
                           "INT64_C",
                           "PRIu64",
                           "SCNd8",
                           "LC_ALL",
                           "FILE",
                           "printf",
                           "stat",
                           "open",
                           "select",
                           "memcpy",
                           "va_list",
                           "environ",
                           "getopt",
                           "poll",
                           "pid_t",
                           "strtok_r",
                           "pthread_create",
                           "AF_INET",
                           "O_RDONLY",
                           "sincos",
                           "cosf128",
                           "f32addf64",
                           "lseek64",
                           "sched_yield",
                           "program_invocation_name"}) {
    EXPECT_FALSE(is_identifier(name)) << name;
    EXPECT_EQ(identifier_from(name), std::string(name) + "_");
  }
  for (const char* name : {"PRINTER", "INT_arm", "Eof", "UR10", "PRI", "I2", "environment",
                           "AF_arm", "arm64", "AF1", "left_l", "hand_r"}) {
    EXPECT_TRUE(is_identifier(name)) << name;
  }
}

// Would catch: a target that CMake refuses, a header that overwrites another one, and a namespace
// that one within it hides, so that code calls itself.
TEST(PackageName, LeavesCMakeAndTheRuntimeTheirs) {
  for (const char* name : {"all", "test", "install", "help", "clean", "lanes", "load_lanes",
                           "sin_cos", "calls", "detail", "eigen", "EOF"}) {
    EXPECT_FALSE(is_package_name(name)) << name;
    EXPECT_EQ(package_name_from(name), std::string(name) + "_");
    EXPECT_TRUE(is_package_name(package_name_from(name))) << name;
  }
  EXPECT_TRUE(is_identifier("test"));
  EXPECT_TRUE(is_package_name("puma560"));
}

TEST(Identifier, IsMadeFromAnyName) {
  EXPECT_EQ(identifier_from("left-hand.2"), "left_hand_2");
  EXPECT_EQ(identifier_from("2R arm"), "n2R_arm");
  EXPECT_EQ(identifier_from("a -- b"), "a_b");
  EXPECT_EQ(identifier_from("__x"), "x");
  EXPECT_EQ(identifier_from("class"), "class_");
  EXPECT_EQ(identifier_from("J\xC3\xA4ger"), "Jue4ger");
  EXPECT_EQ(identifier_from("\xE5\x85\xB3\xE8\x8A\x82"), "u5173u8282");
  EXPECT_EQ(identifier_from(""), "unnamed");
  EXPECT_EQ(identifier_from("---"), "unnamed");
  EXPECT_EQ(identifier_from("\xFF\xFE"), "unnamed");
}

TEST(Identifier, IsMadeForEveryPairOfBytes) {
  for (int a = 0; a < 256; ++a) {
    for (int b = 0; b < 256; ++b) {
      const std::string name{static_cast<char>(a), static_cast<char>(b)};
      EXPECT_TRUE(is_identifier(identifier_from(name))) << a << ' ' << b;
    }
  }
}

TEST(Utf8, IsToldFromOtherBytes) {
  EXPECT_TRUE(is_utf8("plain"));
  EXPECT_TRUE(is_utf8("\xF0\x9F\x90\xB5"));
  EXPECT_FALSE(is_utf8("\xC0\xAF"));          // overlong
  EXPECT_FALSE(is_utf8("\xE0\x80\xAF"));      // overlong
  EXPECT_FALSE(is_utf8("\xED\xA0\x80"));      // surrogate
  EXPECT_FALSE(is_utf8("\xF4\x90\x80\x80"));  // beyond the last code point
  EXPECT_FALSE(is_utf8("\xE5\x85"));          // cut off
  EXPECT_FALSE(is_utf8("\xE4"));              // Latin-1
}

}  // namespace
}  // namespace treeline
