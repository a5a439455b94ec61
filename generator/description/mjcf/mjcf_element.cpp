#include "description/mjcf/mjcf_element.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include "description/parse_xml.hpp"
#include "description/read_number.hpp"
#include "text/read_text_file.hpp"

namespace treeline {
namespace {

namespace fs = std::filesystem;
using tinyxml2::XMLElement;

constexpr const char* kMainClass = "main";
constexpr std::size_t kMostFiles = 256;

/// The kind under which defaults are kept: all actuators share one.
std::string kind_of(std::string_view name) {
  constexpr std::array<std::string_view, 12> kActuators = {
      "motor",  "position",    "velocity", "intvelocity", "damper",  "cylinder",
      "muscle", "orientation", "adhesion", "pid",         "dcmotor", "plugin"};
  const bool acts = std::find(kActuators.begin(), kActuators.end(), name) != kActuators.end();
  return acts ? "general" : std::string(name);
}

std::string path_of(const XMLElement& element) {
  const auto* parent = element.Parent() == nullptr ? nullptr : element.Parent()->ToElement();
  const std::string before = parent == nullptr ? "" : path_of(*parent) + "/";
  const char* name = element.Attribute("name");
  return before + element.Name() + (name == nullptr ? "" : fmt::format("[{}]", name));
}

}  // namespace

const XMLElement* MjcfReading::parse(const std::string& text) {
  return add_file(text, shown_path(path_));
}

const XMLElement* MjcfReading::add_file(const std::string& text, const std::string& shown) {
  Diagnostics found;
  const auto mended = well_formed_xml(text, shown, found);
  for (const Diagnostic& each : found.list()) diagnostics_.add(each);
  failed_ = failed_ || found.has_errors();
  if (!mended) return nullptr;
  documents_.push_back(std::make_unique<tinyxml2::XMLDocument>());
  documents_.back()->Parse(mended->data(), mended->size());
  files_[documents_.back().get()] = shown;
  return documents_.back()->RootElement();
}

/// MuJoCo looks for the file beside the model.
const XMLElement* MjcfReading::include(const XMLElement& element) {
  if (const auto known = included_.find(&element); known != included_.end()) return known->second;
  const XMLElement*& root = included_[&element];
  const char* const file = element.Attribute("file");
  if (file == nullptr || documents_.size() >= kMostFiles) {
    report(Severity::error, element,
           file == nullptr ? "the attribute \"file\" is missing" : "too many files are included",
           "write <include file=\"part.xml\"/>, of files that do not include each other");
    return nullptr;
  }
  const fs::path folder = fs::path(path_ == "-" ? "" : path_).parent_path();
  const std::string path = (folder / file).lexically_normal().string();
  const auto text = read_text_file(path, diagnostics_);
  if (!text) {
    report(Severity::error, element, fmt::format("\"{}\" cannot be read, see above", file),
           "paths are relative to the folder of the model");
    return nullptr;
  }
  return root = add_file(*text, path);
}

std::vector<const XMLElement*> MjcfReading::children(const XMLElement& parent) {
  std::vector<const XMLElement*> list;
  for (const auto* xml = parent.FirstChildElement(); xml; xml = xml->NextSiblingElement()) {
    if (std::string_view(xml->Name()) != "include") {
      list.push_back(xml);
    } else if (const XMLElement* root = include(*xml)) {
      const auto more = children(*root);
      list.insert(list.end(), more.begin(), more.end());
    }
  }
  return list;
}

void MjcfReading::read_defaults(const XMLElement& element, const MjcfDefaults& inherited) {
  const char* const name = element.Attribute("class");
  const auto children = this->children(element);
  MjcfDefaults& own = classes_[name == nullptr ? kMainClass : name];
  own.insert(inherited.begin(), inherited.end());
  for (const XMLElement* child : children) {
    for (const auto* each = child->FirstAttribute(); each != nullptr; each = each->Next()) {
      own[kind_of(child->Name())][each->Name()] = each->Value();
    }
  }
  for (const XMLElement* child : children) {
    if (std::string_view(child->Name()) == "default") read_defaults(*child, own);
  }
}

const MjcfDefaults* MjcfReading::find_class(const std::string& name) const {
  const auto found = classes_.find(name.empty() ? kMainClass : name);
  return found == classes_.end() ? nullptr : &found->second;
}

void MjcfReading::report(Severity severity, const XMLElement& at, std::string fault,
                         std::string remedy) {
  Diagnostic told{severity,    files_[at.GetDocument()], at.GetLineNum(),
                  path_of(at), std::move(fault),         std::move(remedy)};
  if (severity == Severity::error) {
    failed_ = true;
    diagnostics_.add(std::move(told));
  } else if (++counts_[told.fault] == 1) {
    counted_.push_back(std::move(told));
  }
}

void MjcfReading::report_counts() {
  for (Diagnostic& each : counted_) {
    const std::size_t count = counts_[each.fault];
    if (count > 1) each.fault += fmt::format(" (and so in {} more)", count - 1);
    diagnostics_.add(std::move(each));
  }
}

MjcfElement::MjcfElement(const XMLElement& xml, std::string around, MjcfReading& reading)
    : xml_(&xml), around_(std::move(around)), reading_(&reading) {
  if (const char* inside = xml.Attribute("childclass")) around_ = inside;
  const char* const own = xml.Attribute("class");
  const std::string name = own == nullptr ? around_ : own;
  class_ = reading.find_class(name);
  if (class_ == nullptr && !name.empty()) {
    error(fmt::format("there is no class \"{}\" of defaults", name), "write it inside <default>");
  }
}

std::vector<MjcfElement> MjcfElement::children() const {
  std::vector<MjcfElement> list;
  for (const XMLElement* xml : reading_->children(*xml_))
    list.emplace_back(*xml, around_, *reading_);
  return list;
}

std::optional<std::string> MjcfElement::find(const char* attribute) const {
  if (const char* own = xml_->Attribute(attribute)) return own;
  if (class_ == nullptr) return std::nullopt;
  const auto kind = class_->find(kind_of(name()));
  if (kind == class_->end()) return std::nullopt;
  const auto given = kind->second.find(attribute);
  return given == kind->second.end() ? std::nullopt : std::optional(given->second);
}

std::vector<double> MjcfElement::numbers(const char* attribute, std::size_t least,
                                         std::size_t most) const {
  const auto given = find(attribute);
  if (!given) return {};
  auto values = read_numbers(*given);
  const bool fits = values && values->size() >= least && values->size() <= most &&
                    std::none_of(values->begin(), values->end(),
                                 [](double each) { return is_too_large(each, false); });
  if (fits) return std::move(*values);
  error(
      fmt::format("{}=\"{}\" is not {} numbers", attribute, *given,
                  least == most ? fmt::format("{}", least) : fmt::format("{} to {}", least, most)),
      "write decimal numbers with spaces between them");
  return {};
}

double MjcfElement::number(const char* attribute, double otherwise) const {
  const auto values = numbers(attribute, 1, 1);
  return values.empty() ? otherwise : values.front();
}

}  // namespace treeline
