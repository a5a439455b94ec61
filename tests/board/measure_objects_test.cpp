// Would catch: a call of a library that passes for the compiler's own arithmetic, and variables or
// constants that are not counted.
#include "board/measure_objects.hpp"

#include <gtest/gtest.h>

namespace treeline {
namespace {

TEST(MeasureObjects, KnowsArithmetic) {
  for (const char* symbol : {"__aeabi_dmul", "__aeabi_f2d", "__aeabi_ui2d", "__aeabi_cdcmple",
                             "__muldf3", "__adddf3", "__gedf2", "__extendsfdf2", "__truncdfsf2",
                             "__fixdfsi", "__floatsidf", "__udivsi3", "__ashldi3", "__divsf3"}) {
    EXPECT_TRUE(is_arithmetic(symbol)) << symbol;
  }
  for (const char* symbol : {"memcpy", "memset", "sin", "sqrtf", "__cxa_guard_acquire",
                             "__aeabi_memcpy", "__stack_chk_fail", "malloc", "_Znwj"}) {
    EXPECT_FALSE(is_arithmetic(symbol)) << symbol;
  }
}

TEST(MeasureObjects, AddsSections) {
  const SectionBytes bytes = add_sections(
      "f.o  :\nsection            size   addr\n.text                12      0\n"
      ".data                 4      0\n.bss                  8      0\n"
      ".text._ZN1f           30      0\n.rodata.cst4          16      0\n"
      ".srodata.cst8         8      0\n.comment              77      0\nTotal                "
      "155\n");
  EXPECT_EQ(bytes.text, 42);
  EXPECT_EQ(bytes.constants, 24);
  EXPECT_EQ(bytes.variables, 12);
}

TEST(MeasureObjects, ListsUndefinedSymbols) {
  EXPECT_EQ(list_undefined("         U __aeabi_dmul\n         U memset\n"),
            (std::vector<std::string>{"__aeabi_dmul", "memset"}));
}

}  // namespace
}  // namespace treeline
