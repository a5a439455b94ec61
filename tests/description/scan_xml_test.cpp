// Would catch: a tag or an attribute's value that is found at another place than by the XML reader,
// so that a repair would change other bytes than those of the inertia.
#include "description/scan_xml.hpp"

#include <gtest/gtest.h>

namespace treeline {
namespace {

TEST(NextTag, NamesAndValues) {
  const std::string text =
      "<?xml version='1.0'?><!-- <a b='c'> --><a b = \"x > 'y'\" c='&lt;'>"
      "<![CDATA[<d>]]></a ><e/>";
  std::size_t at = 0;
  std::vector<XmlTag> tags;
  while (const auto tag = next_tag(text, at)) tags.push_back(*tag);
  ASSERT_EQ(tags.size(), 6U);
  EXPECT_EQ(tags[0].kind, XmlTag::Kind::other);
  EXPECT_EQ(tags[1].kind, XmlTag::Kind::other);
  EXPECT_EQ(tags[2].kind, XmlTag::Kind::start);
  EXPECT_EQ(tags[2].name, "a");
  ASSERT_EQ(tags[2].attributes.size(), 2U);
  EXPECT_EQ(tags[2].attributes[0].name, "b");
  EXPECT_EQ(tags[2].attributes[0].value, "x > 'y'");
  EXPECT_EQ(tags[2].attributes[1].value, "&lt;");
  EXPECT_EQ(tags[3].kind, XmlTag::Kind::other);
  EXPECT_EQ(tags[4].kind, XmlTag::Kind::end);
  EXPECT_EQ(tags[4].name, "a");
  EXPECT_EQ(tags[5].kind, XmlTag::Kind::empty);
  EXPECT_EQ(tags[5].name, "e");
}

TEST(NextTag, SpaceThatIsNoXmlButRead) {
  const std::string text = "<\r\na b='c'><\n/a>";
  std::size_t at = 0;
  const auto start = next_tag(text, at), end = next_tag(text, at);
  ASSERT_TRUE(start && end);
  EXPECT_EQ(start->name, "a");
  EXPECT_EQ(start->attributes.size(), 1U);
  EXPECT_EQ(end->kind, XmlTag::Kind::end);
}

TEST(NextTag, EndsOnDamagedText) {
  const std::string text = "<a b='c' d=\"e\"><!-- x --><![CDATA[y]]><?z?></a>";
  for (std::size_t size = 0; size <= text.size(); ++size) {
    std::size_t at = 0, tags = 0;
    const std::string cut = text.substr(0, size);
    while (next_tag(cut, at)) {
      ASSERT_LE(at, cut.size());
      ASSERT_LE(++tags, 10U);
    }
  }
}

TEST(FindInertiaTags, FirstInertiaOfFirstInertial) {
  const std::string text =
      "<robot><inertial><inertia ixx='9'/></inertial><link><visual><inertial><inertia ixx='8'/>"
      "</inertial></visual><inertial><mass/><inertia ixx='1'/><inertia ixx='7'/></inertial>"
      "<inertial><inertia ixx='6'/></inertial></link><link/><link><inertial/></link>"
      "<joint><inertial><inertia ixx='5'/></inertial></joint>"
      "<link><inertia ixx='4'/><inertial><inertia ixx='2'/></inertial></link></robot>";
  const auto tags = find_inertia_tags(text);
  ASSERT_EQ(tags.size(), 4U);
  ASSERT_TRUE(tags[0]);
  EXPECT_EQ(tags[0]->attributes[0].value, "1");
  EXPECT_FALSE(tags[1]);
  EXPECT_FALSE(tags[2]);
  ASSERT_TRUE(tags[3]);
  EXPECT_EQ(tags[3]->attributes[0].value, "2");
}

}  // namespace
}  // namespace treeline
