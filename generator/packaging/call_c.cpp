#include "packaging/call_c.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <sstream>

#include "target/target.hpp"

namespace treeline {
namespace {

/// Code that a scene may ask for and the package does not call.
struct NotCalled {
  const char* key;  ///< of the scene
  bool (*is_asked_for)(const Scene& scene);
  const char* what;
  std::string_view called_by = {};  ///< the language that calls it all the same
};
constexpr auto kNotCalled = std::to_array<NotCalled>({
    {"torque_limits", [](const Scene& scene) { return scene.has_limits(); },
     "limited_control_torque", "Python"},
    {"batch", [](const Scene& scene) { return scene.batch > 0; },
     "the functions of several states, only those of one"},
    {"selftest", [](const Scene& scene) { return scene.selftest > 0; }, "the self-test"},
    {"controller", [](const Scene& scene) { return scene.controller.has_value(); },
     "the controller", "Python"},
});

std::string describe(const NotCalled& that, std::string_view caller) {
  return fmt::format("{} does not call {}: it is in src, for C", caller, that.what);
}

}  // namespace

void note_not_called(const PackageKind* kind, const Scene& scene, Diagnostics& diagnostics) {
  const std::string_view caller = kind == nullptr ? "" : kind->caller;
  for (const NotCalled& each : kNotCalled) {
    if (caller.empty() || caller == each.called_by || !each.is_asked_for(scene)) continue;
    diagnostics.add({Severity::note, scene.file, 0, each.key, describe(each, caller), ""});
  }
}

std::string describe_not_called(const Scene& scene, std::string_view caller) {
  std::string text;
  for (const NotCalled& each : kNotCalled) {
    if (caller == each.called_by || !each.is_asked_for(scene)) continue;
    text += describe(each, caller) + ".\n";
  }
  return text;
}

std::vector<GeneratedFunction> list_functions(const Generation& generation) {
  std::vector<GeneratedFunction> functions = generation.functions;
  if (generation.damped) functions.push_back(*generation.damped);
  return functions;
}

std::string find_comment(const std::vector<GeneratedFile>& files, const std::string& function) {
  std::string comment;
  for (const GeneratedFile& file : files) {
    if (!file.name.ends_with(".h")) continue;
    std::istringstream lines(file.text);
    for (std::string line; std::getline(lines, line);) {
      if (line.find(" " + function + "(") != line.npos && !line.starts_with("//")) return comment;
      if (!line.starts_with("///")) comment.clear();
      if (line.starts_with("///"))
        comment += line.substr(std::min<std::size_t>(line.size(), 4)) + "\n";
    }
  }
  return {};
}

std::string quote_flags(const PackageFacts& facts, const Scene& scene) {
  const Target* const target = find_target(scene.target);
  std::string text = facts.at("quoted_flags");
  if (target == nullptr || *target->prefix != '\0') return text;
  std::istringstream words(target->flags);
  for (std::string word; words >> word;) text += fmt::format(", \"{}\"", word);
  return text;
}

}  // namespace treeline
