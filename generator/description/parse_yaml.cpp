#include "description/parse_yaml.hpp"

#include <yaml-cpp/eventhandler.h>

#include <sstream>

#include "description/code_point.hpp"

namespace treeline {
namespace {

// Scenes have some kilobytes; the library takes hundreds of bytes for each one of a list's.
constexpr std::size_t kLargestScene = std::size_t{1} << 20U;

/// Notes where documents start and passes over everything inside them.
class DocumentStarts : public YAML::EventHandler {
 public:
  void OnDocumentStart(const YAML::Mark& mark) override { lines.push_back(mark.line + 1); }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
  void OnAlias(const YAML::Mark&, YAML::anchor_t) override {}
  void OnScalar(const YAML::Mark&, const std::string&, YAML::anchor_t,
                const std::string&) override {}
  void OnSequenceStart(const YAML::Mark&, const std::string&, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {}
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark&, const std::string&, YAML::anchor_t,
                  YAML::EmitterStyle::value) override {}
  void OnMapEnd() override {}

  std::vector<int> lines;
};

/// Asks for two documents at most: yaml-cpp 0.7 finds them without end in a text that starts with a
/// comma, so `LoadAll` cannot be used.
std::vector<int> find_documents(const std::string& text) {
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  DocumentStarts starts;
  while (starts.lines.size() < 2 && parser.HandleNextDocument(starts)) {
  }
  return starts.lines;
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
  try {
    const std::vector<int> starts = find_documents(text);
    if (starts.size() > 1) {
      return report(starts[1], "there is more than one document", "keep one of them");
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
