#include <console_bridge/console.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <sdf/Console.hh>
#include <sdf/ParserConfig.hh>
#include <sstream>
#include <string_view>

#include "description/sdf/flatten_model.hpp"

namespace treeline {
namespace {

namespace fs = std::filesystem;

/// Places in which `model://NAME` and `package://NAME` are searched.
std::vector<std::string> list_places(const std::string& path) {
  const fs::path folder = fs::absolute(path == "-" ? "." : path).lexically_normal().parent_path();
  std::vector<std::string> places{folder.string(), folder.parent_path().string()};
  for (const char* variable :
       {"SDF_PATH", "GZ_SIM_RESOURCE_PATH", "IGN_GAZEBO_RESOURCE_PATH", "GAZEBO_MODEL_PATH"}) {
    const char* value = std::getenv(variable);  // NOLINT(concurrency-mt-unsafe): nobody sets it
    std::istringstream list(value == nullptr ? "" : value);
    for (std::string place; std::getline(list, place, ':');) {
      if (!place.empty()) places.push_back(place);
    }
  }
  return places;
}

sdf::ParserConfig make_configuration(const std::string& path) {
  sdf::ParserConfig configuration;
  for (const std::string& place : list_places(path)) {
    configuration.AddURIPath("model://", place);
    configuration.AddURIPath("package://", place);
  }
  configuration.SetFindCallback([path](const std::string& name) {
    for (const std::string& place : list_places(path)) {
      std::error_code ignored;
      if (fs::exists(fs::path(place) / name, ignored)) return (fs::path(place) / name).string();
    }
    return std::string();
  });
  configuration.SetWarningsPolicy(sdf::EnforcementPolicy::ERR);
  configuration.SetUnrecognizedElementsPolicy(sdf::EnforcementPolicy::ERR);
  configuration.SetDeprecatedElementsPolicy(sdf::EnforcementPolicy::LOG);
  return configuration;
}

/// Whether an error of libsdformat can be ignored, since no motion depends on it: elements that SDF
/// does not have, and faults in what is seen, touched or sensed.
bool is_passed_over(const sdf::Error& error) {
  if (error.Code() == sdf::ErrorCode::ELEMENT_INCORRECT_TYPE ||
      error.Code() == sdf::ErrorCode::ATTRIBUTE_INCORRECT_TYPE) {
    return true;
  }
  const std::string place = error.XmlPath().value_or("") + error.Message();
  constexpr std::array<std::string_view, 8> kUnmoving = {
      "/visual", "/collision", "/sensor", "/plugin", "/light", "<script>", "<material>", "<mesh>"};
  return std::any_of(kUnmoving.begin(), kUnmoving.end(),
                     [&](std::string_view part) { return place.find(part) != std::string::npos; });
}

/// Keeps urdfdom quiet for as long as it lives. libsdformat lets it try what is no SDF, and tells
/// itself what is wrong.
class QuietUrdfdom {
 public:
  QuietUrdfdom() : level_(console_bridge::getLogLevel()) {
    console_bridge::setLogLevel(console_bridge::CONSOLE_BRIDGE_LOG_NONE);
  }
  ~QuietUrdfdom() { console_bridge::setLogLevel(level_); }
  QuietUrdfdom(const QuietUrdfdom&) = delete;
  QuietUrdfdom& operator=(const QuietUrdfdom&) = delete;

 private:
  console_bridge::LogLevel level_;
};

void report(const sdf::Errors& errors, const std::string& shown, Diagnostics& diagnostics) {
  for (const sdf::Error& error : errors) {
    if (error.Code() == sdf::ErrorCode::LINK_INERTIA_INVALID) continue;
    const std::string from = error.FilePath().value_or("");
    const bool is_text = from.empty() || from.front() == '<';
    const std::string message = error.Message();
    diagnostics.add({is_passed_over(error) ? Severity::warning : Severity::error,
                     is_text ? shown : from, error.LineNumber().value_or(0),
                     error.XmlPath().value_or(""),
                     "libsdformat: " + message.substr(0, message.find('\n')),
                     is_passed_over(error) ? "it is passed over" : "mend the file",
                     is_passed_over(error) ? Minor::element : Minor::none});
  }
}

}  // namespace

std::optional<sdf::Root> load_sdf(const SdfText& text, Diagnostics& diagnostics) {
  sdf::Console::Instance()->SetQuiet(true);
  const QuietUrdfdom quiet;
  sdf::Root root;
  Diagnostics found;
  try {
    report(root.LoadSdfString(text.text, make_configuration(text.path)), text.shown, found);
  } catch (const std::exception& fault) {  // libsdformat throws for some malformed numbers
    found.add({Severity::error, text.shown, 0, "", std::string("libsdformat: ") + fault.what(),
               "mend the file"});
  }
  for (const Diagnostic& each : found.list()) diagnostics.add(each);
  if (found.has_errors()) return std::nullopt;
  return root;
}

}  // namespace treeline
