#include "description/parse_yaml.hpp"

#include <yaml-cpp/eventhandler.h>

#include <sstream>

#include "text/printable.hpp"

namespace treeline {
namespace {

// Scenes have some kilobytes; the library takes hundreds of bytes for each one of a list's.
constexpr std::size_t kLargestScene = std::size_t{1} << 20U;

/// Notes where documents start, and the first tag of an application's own, such as `!degrees`.
class Outline : public YAML::EventHandler {
 public:
  void OnDocumentStart(const YAML::Mark& mark) override { starts.push_back(mark.line + 1); }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
  void OnAlias(const YAML::Mark&, YAML::anchor_t) override {}
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t,
                const std::string&) override {
    note(mark, tag);
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {
    note(mark, tag);
  }
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t,
                  YAML::EmitterStyle::value) override {
    note(mark, tag);
  }
  void OnMapEnd() override {}

  std::vector<int> starts;
  std::string own_tag;
  int tag_line = 0;

 private:
  /// "?" and "!" are the library's, of values without a tag.
  void note(const YAML::Mark& mark, const std::string& found) {
    const bool own = found.size() > 1 && found.rfind("tag:yaml.org,2002:", 0) != 0;
    if (!own || !own_tag.empty()) return;
    own_tag = found;
    tag_line = mark.line + 1;
  }
};

/// Asks for two documents at most: yaml-cpp 0.7 finds them without end in a text that starts with a
/// comma, so `LoadAll` cannot be used.
Outline read_outline(const std::string& text) {
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  Outline outline;
  while (outline.starts.size() < 2 && parser.HandleNextDocument(outline)) {
  }
  return outline;
}

/// Whether a document begins in this line without `---`: the library takes a line for one that is
/// indented less than the first.
bool is_outdented(const std::string& text, int number) {
  std::istringstream stream(text);
  std::string line;
  for (int i = 0; i < number; ++i) std::getline(stream, line);
  return number > 1 && line.rfind("---", 0) != 0;
}

/// First line that a tab indents; 0: none.
int find_tab(const std::string& text) {
  std::istringstream stream(text);
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    const auto first = line.find_first_not_of(" \t");
    if (first != std::string::npos && line.find('\t') < first) return number;
  }
  return 0;
}

}  // namespace

std::optional<YAML::Node> parse_yaml(const std::string& text, const std::string& file,
                                     Diagnostics& diagnostics) {
  const auto report = [&](int line, std::string fault, std::string remedy) {
    diagnostics.add({Severity::error, file, line, "", std::move(fault), std::move(remedy)});
    return std::nullopt;
  };
  if (text.size() > kLargestScene) {
    return report(0, "the scene has " + std::to_string(text.size()) + " bytes, more than 1 MiB",
                  "name the scene's own file");
  }
  if (!is_utf8(text)) return report(0, "the file is not UTF-8 text", "save it as UTF-8 text");
  if (const std::size_t begin = text.find_first_not_of("\xef\xbb\xbf \t\r\n");
      begin != text.npos && text.compare(begin, 1, "<") == 0 && text.compare(begin, 2, "<<") != 0) {
    return report(0, "this is XML, as a robot's file is, and no scene",
                  "name one robot and one scene; a scene lists several robots under robots:");
  }
  try {
    const Outline outline = read_outline(text);
    if (outline.starts.size() > 1) {
      const int line = outline.starts[1];
      if (is_outdented(text, line)) {
        return report(line, "this line is indented less than the first",
                      "begin all keys of a map in the same column");
      }
      return report(line, "there is more than one document", "keep one of them");
    }
    if (!outline.own_tag.empty()) {
      return report(outline.tag_line, "the tag " + outline.own_tag + " has no meaning here",
                    "write the value without a tag, angles in radians");
    }
    const YAML::Node document = YAML::Load(text);
    return document.IsNull() ? YAML::Node(YAML::NodeType::Map) : document;
  } catch (const YAML::Exception& exception) {
    if (const int line = find_tab(text)) {
      return report(line, "a tab indents this line, which YAML does not allow", "indent by spaces");
    }
    return report(exception.mark.line + 1, "this is not well-formed YAML: " + exception.msg,
                  "mend the YAML");
  }
}

}  // namespace treeline
