// Would catch: a picture that no program reads, since a name in it is taken for markup.
#include "report/svg.hpp"

#include <gtest/gtest.h>
#include <tinyxml2.h>

namespace treeline::report {
namespace {

TEST(Svg, IsReadAsWritten) {
  const std::string name = "a < \"b\" & 'c' > d";
  const std::string text =
      svg_page(300, 200, "font-size=\"12\"",
               svg_text_at(1, 2, "fill=\"red\"", escape_xml(name)) + svg_line(0, 0, 3, 4, "blue") +
                   svg_frame(1, 2, 30, 40, "grey") + svg_disc(5, 6, 4.5, "green", name) +
                   svg_disc(7, 8, 2, "black"));
  tinyxml2::XMLDocument document;
  ASSERT_EQ(document.Parse(text.c_str()), tinyxml2::XML_SUCCESS) << text;
  const tinyxml2::XMLElement* root = document.RootElement();
  EXPECT_STREQ(root->Name(), "svg");
  EXPECT_STREQ(root->Attribute("viewBox"), "0 0 300 200");
  EXPECT_STREQ(root->FirstChildElement("rect")->Attribute("fill"), "white");
  EXPECT_EQ(root->FirstChildElement("text")->GetText(), name);
  EXPECT_STREQ(root->FirstChildElement("line")->Attribute("y2"), "4.0");
  const tinyxml2::XMLElement* frame = root->FirstChildElement("rect")->NextSiblingElement("rect");
  EXPECT_STREQ(frame->Attribute("height"), "40.0");
  EXPECT_STREQ(frame->Attribute("fill"), "none");
  const tinyxml2::XMLElement* disc = root->FirstChildElement("circle");
  EXPECT_STREQ(disc->Attribute("r"), "4.5");
  EXPECT_EQ(disc->FirstChildElement("title")->GetText(), name);
  EXPECT_TRUE(disc->NextSiblingElement("circle")->NoChildren());
}

}  // namespace
}  // namespace treeline::report
