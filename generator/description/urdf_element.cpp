#include "description/urdf_element.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "description/read_number.hpp"
#include "text/printable.hpp"

namespace treeline {
namespace {

constexpr std::size_t kMostReports = 1000;
constexpr std::size_t kLongestName = 1000;   ///< bytes
constexpr std::size_t kLongestInPath = 100;  ///< bytes of a name in an element's path

/// The first bytes of a long name, whole characters of UTF-8.
std::string shortened(std::string_view name) {
  if (name.size() <= kLongestInPath) return std::string(name);
  std::size_t end = kLongestInPath;
  while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xC0U) == 0x80U) --end;
  return std::string(name.substr(0, end)) + "...";
}

}  // namespace

void UrdfReading::report(Severity severity, int line, std::string element, std::string fault,
                         std::string remedy, Minor minor) {
  failed_ = failed_ || severity == Severity::error;
  if (++reports_ > kMostReports) {
    ++unlisted_;
    return;
  }
  diagnostics_.add(
      {severity, file_, line, std::move(element), std::move(fault), std::move(remedy), minor});
}

void UrdfReading::pass_over(Severity severity, const std::string& kind, int line,
                            std::string element, std::string fault, std::string remedy,
                            Minor minor) {
  if (kinds_.size() >= kMostReports && !kinds_.contains(kind)) {
    ++unlisted_;
    return;
  }
  const auto [place, is_new] = kinds_.try_emplace(kind, passed_over_.size());
  if (is_new) {
    passed_over_.push_back(
        {severity, file_, line, std::move(element), std::move(fault), std::move(remedy), minor});
  } else {
    ++passed_over_[place->second].times;
  }
}

void UrdfReading::report_passed_over() {
  for (Diagnostic& first : passed_over_) {
    if (first.times > 1) first.fault += fmt::format(" (and {} more like it)", first.times - 1);
    diagnostics_.add(std::move(first));
  }
  passed_over_.clear();
  kinds_.clear();
  if (unlisted_ == 0) return;
  diagnostics_.add({failed_ ? Severity::error : Severity::warning, file_, 0, "robot",
                    fmt::format("{} more faults are not listed", unlisted_),
                    "mend those above first"});
  unlisted_ = 0;
}

void UrdfElement::error(std::string fault, std::string remedy) const {
  reading_->report(Severity::error, line(), path_, std::move(fault), std::move(remedy));
}

void UrdfElement::warn(std::string fault, std::string remedy, Minor minor) const {
  reading_->report(Severity::warning, line(), path_, std::move(fault), std::move(remedy), minor);
}

std::optional<std::string> UrdfElement::required_text(const char* attribute,
                                                      const std::string& remedy) const {
  const char* text = xml_->Attribute(attribute);
  if (text != nullptr && *text != '\0') return text;
  error(fmt::format("the attribute \"{}\" is {}", attribute, text == nullptr ? "missing" : "empty"),
        remedy);
  return std::nullopt;
}

std::string UrdfElement::required_name(const std::string& remedy) const {
  const auto text = required_text("name", remedy);
  if (!text) return {};
  const auto is_control = [](char c) { return (c >= 0 && c < ' ') || c == 0x7F; };
  if (!is_utf8(*text)) {
    error("the name is not UTF-8 text", "save the file as UTF-8");
  } else if (std::any_of(text->begin(), text->end(), is_control)) {
    error("the name holds a line break or another control character", "write it as one word");
  } else if (text->size() > kLongestName) {
    error(fmt::format("the name has {} bytes, more than {}", text->size(), kLongestName),
          "shorten it");
  } else if (const std::string blank = name_outer_blank(*text); !blank.empty()) {
    warn(fmt::format("the name begins or ends with {}, which counts", blank), "remove it");
  }
  return *text;
}

std::optional<double> UrdfElement::number(const char* attribute, bool may_be_infinite) const {
  const char* text = xml_->Attribute(attribute);
  if (text == nullptr) return std::nullopt;
  const auto value = read_number(text);
  if (value && (may_be_infinite || std::isfinite(*value))) {
    if (!may_be_infinite) refuse_large(attribute, *value);
    warn_if_lost(attribute, text, *value);
    return value;
  }
  error(fmt::format("{}=\"{}\" is not a {}number{}", attribute, text,
                    may_be_infinite ? "" : "finite ", note_odd_character(text)),
        "write one decimal number with a point, such as 0.25 or 2.5e-1");
  return std::nullopt;
}

std::optional<std::array<double, 3>> UrdfElement::three_numbers(const char* attribute) const {
  const char* text = xml_->Attribute(attribute);
  if (text == nullptr) return std::nullopt;
  const auto values = read_numbers(text);
  if (values && values->size() == 3) {
    // Of an axis the direction counts alone.
    const bool has_size = name() != "axis";
    const auto words = split_words(text);
    for (std::size_t i = 0; i < words.size(); ++i) {
      if (has_size) refuse_large(attribute, (*values)[i]);
      warn_if_lost(attribute, words[i], (*values)[i]);
    }
    return std::array{(*values)[0], (*values)[1], (*values)[2]};
  }
  const std::string count = values ? fmt::format(" but {}", values->size()) : "";
  error(fmt::format("{}=\"{}\" is not three finite numbers{}{}", attribute, text, count,
                    note_odd_character(text)),
        "write three decimal numbers with spaces between them, such as \"0 0.5 1\"");
  return std::nullopt;
}

void UrdfElement::refuse_large(const char* attribute, double value) const {
  const bool angle = std::string_view(attribute) == "rpy";
  if (!is_too_large(value, angle)) return;
  error(fmt::format("{} in \"{}\" is too large to compute with", value, attribute),
        angle ? fmt::format("give angles of at most {} rad", kLargestAngle)
              : fmt::format("give numbers of at most {} in SI units", kLargestNumber));
}

void UrdfElement::warn_if_lost(const char* attribute, std::string_view text, double value) const {
  if (value != 0 || !rounds_to_zero(text)) return;
  warn(fmt::format("{} in \"{}\" is nearer to 0 than any number of double and counts as 0", text,
                   attribute),
       "write 0", Minor::form);
}

UrdfElement UrdfElement::as_child(const tinyxml2::XMLElement& xml) const {
  std::string path = path_ + "/" + shortened(xml.Name());
  if (const char* name = xml.Attribute("name")) path += fmt::format("[{}]", shortened(name));
  return {xml, std::move(path), *reading_};
}

std::optional<UrdfElement> UrdfElement::child(const char* name) const {
  const auto* first = xml_->FirstChildElement(name);
  if (first == nullptr) return std::nullopt;
  if (const auto* second = first->NextSiblingElement(name)) {
    as_child(*second).warn(
        fmt::format("there is more than one <{}>; the first, in line {}, is used and this is not",
                    name, first->GetLineNum()),
        "keep one of them");
  }
  return as_child(*first);
}

Pose UrdfElement::origin() const {
  const auto origin = child("origin");
  if (!origin) return {};
  origin->holds_only_attributes({"xyz", "rpy"});
  const Pose pose{origin->three_numbers("xyz").value_or(std::array<double, 3>{}),
                  origin->three_numbers("rpy").value_or(std::array<double, 3>{}), origin->line()};
  if (std::any_of(pose.rpy.begin(), pose.rpy.end(), is_beyond_a_turn)) {
    reading_->pass_over(
        Severity::warning, "more than a turn", origin->line(), origin->path(),
        fmt::format("rpy=\"{}\" is more than a whole turn", origin->xml().Attribute("rpy")),
        kRadiansForDegrees);
  }
  return pose;
}

}  // namespace treeline
