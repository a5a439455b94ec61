#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <sstream>
#include <vector>

#include "description/parse_yaml.hpp"

namespace treeline {
namespace {

/// Follows the document, with the place of each value as `SceneElement` writes it.
class AliasFinder : public YAML::EventHandler {
 public:
  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override { take(""); }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
    if (!is_key()) lines.emplace(place(), mark.line + 1);
    take("");
  }
  void OnScalar(const YAML::Mark&, const std::string&, YAML::anchor_t,
                const std::string& value) override {
    take(value);
  }
  void OnSequenceStart(const YAML::Mark&, const std::string&, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {
    open(false);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark&, const std::string&, YAML::anchor_t,
                  YAML::EmitterStyle::value) override {
    open(true);
  }
  void OnMapEnd() override { close(); }

  std::map<std::string, int> lines;

 private:
  struct Collection {
    std::string place;
    bool is_map = false;
    bool awaits_key = false;  ///< of a map
    std::string key;          ///< of a map, the last one
    std::size_t taken = 0;    ///< of a list
  };

  [[nodiscard]] bool is_key() const { return !open_.empty() && open_.back().awaits_key; }

  /// Path of the value that comes next in the document.
  [[nodiscard]] std::string place() const {
    if (open_.empty()) return "";
    const Collection& within = open_.back();
    if (!within.is_map) return fmt::format("{}[{}]", within.place, within.taken);
    return within.place.empty() ? within.key : within.place + "/" + within.key;
  }

  /// A key, or a value, is over.
  void take(const std::string& text) {
    if (open_.empty()) return;
    Collection& within = open_.back();
    if (within.awaits_key) within.key = text;
    within.awaits_key = within.is_map && !within.awaits_key;
    ++within.taken;
  }

  void open(bool is_map) { open_.push_back({place(), is_map, is_map, "", 0}); }

  void close() {
    open_.pop_back();
    take("");
  }

  std::vector<Collection> open_;
};

}  // namespace

std::map<std::string, int> alias_lines(const std::string& text) {
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  AliasFinder finder;
  (void)parser.HandleNextDocument(finder);
  return std::move(finder.lines);
}

}  // namespace treeline
