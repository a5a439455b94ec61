// Reads structs and enumerations out of a header as it is emitted.

#include "emission/list_members.hpp"

#include <gtest/gtest.h>

namespace treeline {
namespace {

// A word of a comment that goes on in the next line would be an enumerator.
TEST(ListMembers, LeavesOutWhatCommentsSay) {
  const std::string header =
      "typedef enum arm_unmet {\n"
      "  ARM_UNMET_NONE = 0,\n"
      "  ARM_UNMET_REACH = 2, /* out of reach, where a joint\n"
      "                          would become too\n"
      "                          fast */\n"
      "  ARM_UNMET_LIMIT, /* a range ends */\n"
      "  ARM_UNMET_TORQUE\n"
      "} arm_unmet;\n";
  std::string listed;
  for (const HeaderEnumerator& each : list_enumerators(header, "arm_unmet")) {
    listed += each.name + "=" + std::to_string(each.value) + " ";
  }
  EXPECT_EQ(listed, "ARM_UNMET_NONE=0 ARM_UNMET_REACH=2 ARM_UNMET_LIMIT=3 ARM_UNMET_TORQUE=4 ");
}

TEST(ListMembers, JoinsAMeaningOverLines) {
  const std::string header =
      "typedef struct arm_input {\n"
      "  arm_number q[6]; /* positions of\n"
      "                      the joints */\n"
      "  int32_t kind;\n"
      "} arm_input;\n";
  const std::vector<StructMember> members = list_members(header, "arm_input");
  ASSERT_EQ(members.size(), 2U);
  EXPECT_EQ(members[0].name, "q");
  EXPECT_TRUE(members[0].is_array);
  EXPECT_EQ(members[0].meaning, "positions of the joints");
  EXPECT_EQ(members[1].type, "int32_t");
  EXPECT_FALSE(members[1].is_array);
}

}  // namespace
}  // namespace treeline
