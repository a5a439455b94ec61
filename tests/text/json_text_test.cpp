// Would catch: a report that ends the program, since a file's name has bytes that are not UTF-8.
#include "text/json_text.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace treeline {
namespace {

TEST(JsonText, TakesAnyBytes) {
  const nlohmann::ordered_json json = {{"robot", "arm\xE4"}, {"links", {1, 2}}};
  EXPECT_EQ(json_line(json), "{\"robot\":\"arm\xEF\xBF\xBD\",\"links\":[1,2]}");
  const std::string text = json_text(json);
  EXPECT_EQ(text.back(), '\n');
  EXPECT_EQ(nlohmann::ordered_json::parse(text).at("links"), json.at("links"));
}

}  // namespace
}  // namespace treeline
