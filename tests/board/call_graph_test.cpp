// Would catch: a stack figure that leaves out callees, adds up calls that are not nested, or hides
// what has no bound.
#include <gtest/gtest.h>

#include "board/measure_objects.hpp"

namespace treeline {
namespace {

std::string node(const std::string& name, const std::string& bytes) {
  return "node: { title: \"" + name + "\" label: \"void " + name + "()\\nfile.cpp:1:6" +
         (bytes.empty() ? "" : "\\n" + bytes) + "\" }\n";
}

std::string edge(const std::string& from, const std::string& to) {
  return "edge: { sourcename: \"" + from + "\" targetname: \"" + to +
         "\" label: \"file.cpp:2:4\" }\n";
}

StackUse read(const std::string& text, const std::string& root) {
  CallGraph graph;
  read_call_graph("graph: { title: \"file.cpp\"\n" + text + "}\n", graph);
  return add_stack(graph, root);
}

TEST(CallGraph, TakesTheDeepestPath) {
  const std::string text = node("f", "100 bytes (static)\\n0 dynamic objects") +
                           node("g", "40 bytes (static)") + node("h", "60 bytes (static)") +
                           node("deep", "30 bytes (dynamic,bounded)") + edge("f", "g") +
                           edge("f", "h") + edge("g", "deep");
  EXPECT_EQ(read(text, "f").bytes, 170);  // f, g, deep: beside h's 160
  EXPECT_EQ(read(text, "h").bytes, 60);
  EXPECT_TRUE(read(text, "f").unknown.empty());
}

TEST(CallGraph, JoinsFiles) {
  CallGraph graph;
  read_call_graph(node("f", "100 bytes (static)") + node("g", "") + edge("f", "g"), graph);
  EXPECT_EQ(add_stack(graph, "f").unknown, std::set<std::string>{"g"});
  read_call_graph(node("g", "40 bytes (static)"), graph);
  EXPECT_EQ(add_stack(graph, "f").bytes, 140);
  EXPECT_TRUE(add_stack(graph, "f").unknown.empty());
}

TEST(CallGraph, HasNoBoundWhereThereIsNone) {
  EXPECT_FALSE(read(node("f", "8 bytes (static)") + edge("f", "f"), "f").bytes);
  const StackUse dynamic =
      read(node("f", "8 bytes (static)") + node("g", "16 bytes (dynamic)") + edge("f", "g"), "f");
  EXPECT_EQ(dynamic.unknown, std::set<std::string>{"g"});
  EXPECT_EQ(read("", "f").unknown, std::set<std::string>{"f"});
}

}  // namespace
}  // namespace treeline
