#include "description/parse_xml.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "description/identifier.hpp"

namespace treeline {
namespace {

using tinyxml2::XMLElement;

int line_at(const std::string& text, std::size_t at) {
  const auto breaks = std::count(text.begin(), text.begin() + static_cast<long>(at), '\n');
  return 1 + static_cast<int>(breaks);
}

/// Where the XML declaration starts after white space and comments; npos when there is none.
std::size_t find_declaration(const std::string& text) {
  std::size_t at = text.find_first_not_of(" \t\r\n");
  while (at != std::string::npos && text.compare(at, 4, "<!--") == 0) {
    const auto end = text.find("-->", at + 4);
    if (end == std::string::npos) return end;
    at = text.find_first_not_of(" \t\r\n", end + 3);
  }
  const bool found = at != std::string::npos && text.compare(at, 5, "<?xml") == 0;
  return found ? at : std::string::npos;
}

/// XML allows nothing before its declaration, yet files with a blank line or a comment there are
/// in use. Overwrites a declaration that stands too late with blanks, with a warning.
std::string without_late_declaration(std::string text, const std::string& file,
                                     Diagnostics& diagnostics) {
  const auto at = find_declaration(text);
  if (at == 0 || at == std::string::npos) return text;
  const auto end = std::min(text.find("?>", at), text.size() - 2) + 2;
  diagnostics.add({Severity::warning, file, line_at(text, at), "",
                   "the XML declaration is not at the start of the file",
                   "move it there: strict readers of XML refuse the file"});
  std::replace_if(
      text.begin() + static_cast<long>(at), text.begin() + static_cast<long>(end),
      [](char c) { return c != '\n'; }, ' ');
  return text;
}

struct Complaint {
  const std::string& file;
  Diagnostics& diagnostics;

  void operator()(int line, std::string element, std::string fault, std::string remedy) const {
    diagnostics.add(
        {Severity::error, file, line, std::move(element), std::move(fault), std::move(remedy)});
  }
};

std::string describe(const tinyxml2::XMLDocument& document) {
  switch (document.ErrorID()) {
    case tinyxml2::XML_ERROR_EMPTY_DOCUMENT:
      return "the file holds no XML";
    case tinyxml2::XML_ERROR_MISMATCHED_ELEMENT: {
      // The library's text ends in `XMLElement name=NAME`.
      const std::string_view text = document.ErrorStr();
      const auto at = text.rfind("name=");
      if (at == std::string_view::npos) return "an element is not closed";
      return fmt::format("the element <{}> is not closed by its own end tag", text.substr(at + 5));
    }
    case tinyxml2::XML_ERROR_PARSING_ATTRIBUTE:
      return "an attribute is not of the form name=\"value\", or is given twice";
    case tinyxml2::XML_ERROR_PARSING_DECLARATION:
      return "the XML declaration is not at the start of the file";
    case tinyxml2::XML_ERROR_PARSING_COMMENT:
      return "a comment is not closed";
    case tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED:
      return "elements are nested too deeply";
    case tinyxml2::XML_ERROR_PARSING_TEXT:
      return "text stands outside every element: this is not XML";
    default:
      return "this is not well-formed XML";
  }
}

bool check_bytes(const std::string& text, const Complaint& complain) {
  if (const auto at = text.find('\0'); at != std::string::npos) {
    complain(line_at(text, at), "", "the file holds a zero byte: it is binary or UTF-16",
             "save it as UTF-8 text");
    return false;
  }
  return true;
}

/// tinyxml2 keeps everything at the top: several elements and stray text must be refused here.
const XMLElement* only_root(const tinyxml2::XMLDocument& document, const Complaint& complain) {
  const XMLElement* root = document.RootElement();
  if (root == nullptr) {
    complain(0, "", "the file holds no XML element", "a URDF has one element <robot> at the top");
    return nullptr;
  }
  for (const auto* node = document.FirstChild(); node != nullptr; node = node->NextSibling()) {
    if (node == root || node->ToComment() || node->ToDeclaration() || node->ToUnknown()) continue;
    if (const XMLElement* other = node->ToElement()) {
      complain(node->GetLineNum(), other->Name(),
               fmt::format("a second element at the top, after <{}>", root->Name()),
               "a URDF has one element <robot> at the top that holds everything");
    } else {
      complain(node->GetLineNum(), "", "text stands outside the root element", "remove it");
    }
    return nullptr;
  }
  return root;
}

std::string other_format(std::string_view name) {
  if (name == "sdf" || name == "gazebo" || name == "world" || name == "model") {
    return "this looks like SDF, which is not read: export the robot as URDF";
  }
  if (name == "mujoco") return "this is MJCF, which is not read: export the robot as URDF";
  if (name == "COLLADA") return "this is COLLADA: name the robot's URDF";
  return "the root element of a URDF is <robot>";
}

bool starts_with_xacro(std::string_view name) {
  return name.substr(0, 6) == "xacro:";
}

bool holds_macro(std::string_view text) {
  return text.find("${") != std::string_view::npos || text.find("$(") != std::string_view::npos;
}

std::string expansion_command(const std::string& file) {
  std::string output = file;
  for (const std::string_view ending : {".xacro", ".urdf"}) {
    if (output.size() > ending.size() && output.ends_with(ending)) {
      output.resize(output.size() - ending.size());
    }
  }
  if (output.empty() || output + ".urdf" == file) output += "_expanded";
  return fmt::format("expand it first: xacro {0} > {1}.urdf", file.empty() ? "FILE" : file, output);
}

/// Looks for macros outside the elements that do not matter.
class MacroCheck : public tinyxml2::XMLVisitor {
 public:
  explicit MacroCheck(const Complaint& complain) : complain_(complain) {}

  bool VisitEnter(const XMLElement& element, const tinyxml2::XMLAttribute* first) override {
    const std::string_view name = element.Name();
    if (starts_with_xacro(name)) return refuse_macro(element, fmt::format("<{}>", name));
    const bool irrelevant = name == "visual" || name == "collision" || name == "gazebo" ||
                            name == "transmission" || name == "ros2_control";
    if (irrelevant) return false;
    for (const auto* attribute = first; attribute != nullptr; attribute = attribute->Next()) {
      if (holds_macro(attribute->Value())) {
        return refuse_macro(element,
                            fmt::format("{}=\"{}\"", attribute->Name(), attribute->Value()));
      }
    }
    return !found_macro_;
  }

  [[nodiscard]] bool ok() const { return !found_macro_; }

 private:
  bool refuse_macro(const XMLElement& element, const std::string& what) {
    if (!found_macro_) {
      complain_(element.GetLineNum(), element.Name(),
                fmt::format("this is xacro text, not yet a URDF: {}", what),
                expansion_command(complain_.file));
    }
    found_macro_ = true;
    return false;
  }

  const Complaint& complain_;
  bool found_macro_ = false;
};

}  // namespace

const tinyxml2::XMLElement* parse_urdf_xml(const std::string& text, const std::string& file,
                                           tinyxml2::XMLDocument& document,
                                           Diagnostics& diagnostics) {
  const Complaint complain{file, diagnostics};
  if (!check_bytes(text, complain)) return nullptr;
  const std::string mended = without_late_declaration(text, file, diagnostics);
  if (document.Parse(mended.data(), mended.size()) != tinyxml2::XML_SUCCESS) {
    complain(document.ErrorLineNum(), "", describe(document),
             "mend the XML, or check that this is a URDF");
    return nullptr;
  }
  const XMLElement* root = only_root(document, complain);
  if (root == nullptr) return nullptr;
  MacroCheck check(complain);
  root->Accept(&check);
  if (!check.ok()) return nullptr;
  if (std::string_view(root->Name()) != "robot") {
    complain(root->GetLineNum(), root->Name(),
             fmt::format("the root element is <{}>, not <robot>", root->Name()),
             other_format(root->Name()));
    return nullptr;
  }
  return root;
}

}  // namespace treeline
