#include "description/parse_xml.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string_view>

#include "description/scan_xml.hpp"
#include "description/xml_faults.hpp"

namespace treeline {
namespace {

using tinyxml2::XMLElement;

int line_at(const std::string& text, std::size_t at) {
  const auto breaks = std::count(text.begin(), text.begin() + static_cast<long>(at), '\n');
  return 1 + static_cast<int>(breaks);
}

std::size_t start_of_line(const std::string& text, int line) {
  std::size_t at = 0;
  for (int before = 1; before < line && at < text.size(); ++before) {
    at = std::min(text.find('\n', at), text.size() - 1) + 1;
  }
  return at;
}

/// Position of the XML declaration after white space and comments; npos when there is none.
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
                   "move it there: strict readers of XML refuse the file", Minor::form});
  std::replace_if(
      text.begin() + static_cast<long>(at), text.begin() + static_cast<long>(end),
      [](char c) { return c != '\n'; }, ' ');
  return text;
}

/// Programs that write the terminator of a C string, or DOS's end of a file, leave bytes behind the
/// text that others do not read. Removes them, with a warning.
std::string without_terminator(std::string text, const std::string& file,
                               Diagnostics& diagnostics) {
  const auto last = text.find_last_not_of(std::string_view("\0\x1a", 2));
  if (last == std::string::npos || last + 1 == text.size()) return text;
  diagnostics.add({Severity::warning, file, line_at(text, last), "",
                   "a zero byte or Ctrl-Z stands behind the end of the text",
                   "remove it: strict readers of XML refuse the file", Minor::form});
  text.resize(last + 1);
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
    case tinyxml2::XML_ERROR_MISMATCHED_ELEMENT:
      return "an end tag closes nothing that is open";
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

/// The attribute that is given twice in a tag that reaches into this line; empty if none is.
std::string find_repeated_attribute(const std::string& text, int line) {
  const std::size_t begin = start_of_line(text, line), end = start_of_line(text, line + 1);
  for (std::size_t at = 0; at < end;) {
    const auto tag = next_tag(text, at);
    if (!tag) break;
    if (at <= begin) continue;
    std::set<std::string_view> names;
    for (const XmlAttribute& attribute : tag->attributes) {
      if (names.insert(attribute.name).second) continue;
      return fmt::format("the attribute \"{}\" is given twice in <{}>", attribute.name, tag->name);
    }
  }
  return {};
}

/// More exact text for the same fault that `describe` tells; empty if there is none.
std::string describe_in_text(const tinyxml2::XMLDocument& document, const std::string& text) {
  const int line = document.ErrorLineNum();
  if (document.ErrorID() == tinyxml2::XML_ERROR_PARSING_ATTRIBUTE) {
    return find_repeated_attribute(text, line);
  }
  if (document.ErrorID() != tinyxml2::XML_ERROR_PARSING_DECLARATION) return {};
  const std::size_t at = text.find("<?", start_of_line(text, line));
  const bool declares = at == std::string::npos || text.compare(at, 6, "<?xml ") == 0;
  return declares ? "" : "a processing instruction, <?...?>, stands inside an element";
}

/// Tells which tags do not fit together, with the lines of both, or where in the file the fault is.
void complain_of_xml(const tinyxml2::XMLDocument& document, const std::string& text,
                     const Complaint& complain) {
  const char* const remedy = "mend the XML, or check that this is a URDF";
  const auto id = document.ErrorID();
  const bool tags = id == tinyxml2::XML_ERROR_MISMATCHED_ELEMENT ||
                    id == tinyxml2::XML_ERROR_PARSING || id == tinyxml2::XML_ERROR_PARSING_ELEMENT;
  if (const auto unclosed = tags ? find_unclosed_element(text) : std::nullopt) {
    const std::string instead =
        unclosed->instead.empty()
            ? fmt::format("the file ends in line {}", unclosed->line)
            : fmt::format("line {} has {}", unclosed->line, unclosed->instead);
    complain(unclosed->open.line, "",
             fmt::format("<{}> is not closed: {} is open since line {}, and {}",
                         unclosed->open.name, unclosed->open.tag, unclosed->open.line, instead),
             remedy);
    return;
  }
  std::string fault = describe_in_text(document, text);
  if (fault.empty()) fault = describe(document);
  if (id != tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED && id != tinyxml2::XML_ERROR_EMPTY_DOCUMENT) {
    if (const auto open = find_open_element(text, document.ErrorLineNum())) {
      fault += fmt::format(", inside {} of line {}", open->tag, open->line);
    }
  }
  complain(document.ErrorLineNum(), "", fault, remedy);
}

/// Position of a DOCTYPE before the root element that declares entities of its own; npos: none.
std::size_t find_own_entities(std::string_view text) {
  std::size_t at = text.find('<');
  while (at != std::string_view::npos) {
    const std::string_view rest = text.substr(at);
    const bool comment = rest.starts_with("<!--");
    if (rest.starts_with("<!DOCTYPE")) {
      const std::size_t subset = rest.find_first_of("[>");
      return subset != std::string_view::npos && rest[subset] == '[' ? at : std::string_view::npos;
    }
    if (!comment && !rest.starts_with("<?")) break;
    at = text.find(comment ? "-->" : "?>", at);
    if (at != std::string_view::npos) at = text.find('<', at);
  }
  return std::string_view::npos;
}

bool check_bytes(const std::string& text, const Complaint& complain) {
  if (const auto at = text.find('\0'); at != std::string::npos) {
    complain(line_at(text, at), "", "the file holds a zero byte: it is binary or UTF-16",
             "save it as UTF-8 text");
    return false;
  }
  if (const auto stray = describe_stray_text(text)) {
    complain(1, "", stray->fault, stray->remedy);
    return false;
  }
  if (const auto at = find_own_entities(text); at != std::string::npos) {
    complain(line_at(text, at), "", "the DOCTYPE has declarations of its own, which are not read",
             "write out what its entities stand for: xmllint --noent FILE, and remove the DOCTYPE");
    return false;
  }
  if (const auto excess = find_excess(text)) {
    complain(line_at(text, excess->at), "", excess->fault,
             "name the robot's own file: no robot of the size that can be generated needs as many");
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
  if (name == "gazebo") return "this is SDF before version 1.3: let Gazebo save it again";
  if (name == "sdf" || name == "world" || name == "model") {
    return "this looks like a part of SDF: its root is <sdf>";
  }
  if (name == "mujocoinclude") return "this is a part of an MJCF: name the file that includes it";
  if (name == "COLLADA") return "this is COLLADA: name the robot's URDF";
  return "the root element of a URDF is <robot>";
}

/// The root of whatever XML it is; nothing, and an error, where it is none.
const XMLElement* parse_mended(const std::string& mended, tinyxml2::XMLDocument& document,
                               const Complaint& complain) {
  if (document.Parse(mended.data(), mended.size()) != tinyxml2::XML_SUCCESS) {
    complain_of_xml(document, mended, complain);
    return nullptr;
  }
  if (const auto misread = find_misread_tag(document, mended)) {
    complain(misread->line, "", misread->fault, misread->remedy);
    return nullptr;
  }
  return only_root(document, complain);
}

}  // namespace

std::optional<std::string> well_formed_xml(const std::string& bytes, const std::string& file,
                                           Diagnostics& diagnostics) {
  const Complaint complain{file, diagnostics};
  const std::string text = without_terminator(bytes, file, diagnostics);
  if (!check_bytes(text, complain)) return std::nullopt;
  std::string mended = without_late_declaration(text, file, diagnostics);
  tinyxml2::XMLDocument document;
  if (parse_mended(mended, document, complain) == nullptr) return std::nullopt;
  return mended;
}

const tinyxml2::XMLElement* parse_urdf_xml(const std::string& bytes, const std::string& file,
                                           tinyxml2::XMLDocument& document,
                                           Diagnostics& diagnostics) {
  const Complaint complain{file, diagnostics};
  const std::string text = without_terminator(bytes, file, diagnostics);
  if (!check_bytes(text, complain)) return nullptr;
  const std::string mended = without_late_declaration(text, file, diagnostics);
  const XMLElement* root = parse_mended(mended, document, complain);
  if (root == nullptr) return nullptr;
  if (std::string_view(root->Name()) != "robot") {
    complain(root->GetLineNum(), root->Name(),
             fmt::format("the root element is <{}>, not <robot>", root->Name()),
             other_format(root->Name()));
    return nullptr;
  }
  return root;
}

}  // namespace treeline
