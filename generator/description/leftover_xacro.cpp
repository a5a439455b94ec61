#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string_view>

#include "description/xml_faults.hpp"

namespace treeline {
namespace {

using tinyxml2::XMLElement;

bool is_xacro(std::string_view name) {
  return name.starts_with("xacro:");
}

bool holds_expression(std::string_view text) {
  return text.find("${") != std::string_view::npos || text.find("$(") != std::string_view::npos;
}

/// Elements that say nothing of masses and motion.
bool is_irrelevant(std::string_view name) {
  constexpr std::array<std::string_view, 8> kNames = {"visual",       "collision",    "gazebo",
                                                      "transmission", "ros2_control", "sensor",
                                                      "material",     "mujoco"};
  return std::find(kNames.begin(), kNames.end(), name) != kNames.end();
}

std::string expansion_command(const std::string& file) {
  std::string output = file;
  for (const std::string_view ending : {".xacro", ".urdf"}) {
    if (output.size() > ending.size() && output.ends_with(ending)) {
      output.resize(output.size() - ending.size());
    }
  }
  if (output.empty() || output + ".urdf" == file) output += "_expanded";
  return fmt::format("expand it, or the file that includes it: xacro {0} > {1}.urdf",
                     file.empty() ? "FILE" : file, output);
}

/// Whether links or joints stand somewhere inside.
bool holds_mechanism(const XMLElement& element) {
  for (const auto* child = element.FirstChildElement(); child != nullptr;
       child = child->NextSiblingElement()) {
    const std::string_view name = child->Name();
    if (name == "link" || name == "joint") return true;
    if (!is_irrelevant(name) && holds_mechanism(*child)) return true;
  }
  return false;
}

class Search {
 public:
  Search(const std::string& file, Diagnostics& diagnostics)
      : diagnostics_(diagnostics), file_(file) {}

  void read_robot(const XMLElement& robot) {
    collect_definitions(robot);
    read_attributes(robot);
    for (const auto* child = robot.FirstChildElement(); child != nullptr;
         child = child->NextSiblingElement()) {
      const std::string_view name = child->Name();
      if (is_xacro(name)) {
        read_xacro(*child);
      } else if (name == "link" || name == "joint") {
        read_part(*child);
      }
    }
  }

  [[nodiscard]] LeftoverXacro found() const {
    LeftoverXacro result = first_;
    std::string list;
    for (const auto& [what, times] : passed_over_) {
      list += (list.empty() ? "" : ", ") + what + (times > 1 ? fmt::format(" ({})", times) : "");
    }
    result.fault = list;
    result.remedy = expansion_command(file_);
    return result;
  }

 private:
  /// Names that `${...}` may stand for by what the file says, and macros that add links or joints.
  void collect_definitions(const XMLElement& robot) {
    for (const auto* child = robot.FirstChildElement(); child != nullptr;
         child = child->NextSiblingElement()) {
      const std::string_view name = child->Name();
      const char* const defined = child->Attribute("name");
      if (defined == nullptr) continue;
      if (name == "xacro:property" || name == "xacro:arg") defined_.insert(defined);
      if (name == "xacro:macro" && holds_mechanism(*child)) {
        adding_.insert(std::string("xacro:") + defined);
      }
    }
  }

  void read_xacro(const XMLElement& element) {
    const std::string_view name = element.Name();
    const bool adds = name != "xacro:macro" && (adding_.contains(name) || holds_mechanism(element));
    if (adds) {
      refuse(element, fmt::format("<{}> would add links or joints", name));
    } else {
      pass_over(element, fmt::format("<{}>", name));
    }
  }

  /// A link, a joint, or what in them is about masses and motion.
  void read_part(const XMLElement& element) {
    read_attributes(element);
    for (const auto* child = element.FirstChildElement(); child != nullptr;
         child = child->NextSiblingElement()) {
      if (is_xacro(child->Name())) {
        refuse(*child, fmt::format("<{}> inside <{}>", child->Name(), element.Name()));
      } else if (!is_irrelevant(child->Name())) {
        read_part(*child);
      }
    }
  }

  void read_attributes(const XMLElement& element) {
    for (const auto* attribute = element.FirstAttribute(); attribute != nullptr;
         attribute = attribute->Next()) {
      if (!holds_expression(attribute->Value())) continue;
      const std::string_view name = attribute->Name();
      const bool is_name = name == "name" || name == "link" || name == "joint";
      if (is_name && is_defined(attribute->Value())) {
        pass_over(element, "expressions in names, which stay as they are written");
      } else {
        refuse(element, fmt::format("{}=\"{}\"", name, attribute->Value()));
      }
    }
  }

  /// Whether every expression in a name is one that the file gives a value. Then the name is a
  /// label as good as any other.
  [[nodiscard]] bool is_defined(std::string_view text) const {
    while (holds_expression(text)) {
      const std::size_t open = std::min(text.find("${"), text.find("$("));
      const std::size_t close = text.find(text[open + 1] == '{' ? '}' : ')', open);
      if (close == std::string_view::npos) return false;
      std::string_view name = text.substr(open + 2, close - open - 2);
      if (name.starts_with("arg ")) name.remove_prefix(4);
      if (!defined_.contains(name)) return false;
      text.remove_prefix(close + 1);
    }
    return true;
  }

  void pass_over(const XMLElement& element, const std::string& what) {
    if (first_.line == 0) {
      first_.line = element.GetLineNum();
      first_.element = element.Name();
    }
    ++passed_over_[what];
  }

  void refuse(const XMLElement& element, const std::string& what) {
    if (!refused_) {
      diagnostics_.add({Severity::error, file_, element.GetLineNum(), element.Name(),
                        fmt::format("this is xacro text, not yet a URDF: {}", what),
                        expansion_command(file_)});
    }
    refused_ = true;
  }

  Diagnostics& diagnostics_;
  std::string file_;
  std::set<std::string, std::less<>> defined_, adding_;
  std::map<std::string, int> passed_over_;
  LeftoverXacro first_;
  bool refused_ = false;
};

}  // namespace

LeftoverXacro find_leftover_xacro(const tinyxml2::XMLElement& robot, const std::string& file,
                                  Diagnostics& diagnostics) {
  Search search(file, diagnostics);
  search.read_robot(robot);
  return search.found();
}

}  // namespace treeline
