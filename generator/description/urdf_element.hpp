#pragma once

#include <tinyxml2.h>

#include <array>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "description/robot.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// One reading of a URDF: where faults go, and what was passed over. The same unknown attribute
/// stands on a hundred joints of an exported robot, so each kind is reported once, with a count.
/// Beyond a thousand reports and a thousand kinds, faults are counted and not listed.
class UrdfReading {
 public:
  UrdfReading(std::string file, Diagnostics& diagnostics)
      : file_(std::move(file)), diagnostics_(diagnostics) {}

  void report(Severity severity, int line, std::string element, std::string fault,
              std::string remedy, Minor minor = Minor::none);

  /// Something in the file that changes nothing; `kind` says what is to be counted as the same.
  void pass_over(Severity severity, const std::string& kind, int line, std::string element,
                 std::string fault, std::string remedy, Minor minor = Minor::none);

  /// Reports what was passed over, in the order of its first place in the file, and how many faults
  /// are not listed.
  void report_passed_over();

  [[nodiscard]] const std::string& file() const { return file_; }
  [[nodiscard]] bool failed() const { return failed_; }

 private:
  std::string file_;
  Diagnostics& diagnostics_;
  bool failed_ = false;
  std::size_t reports_ = 0, unlisted_ = 0;
  std::map<std::string, std::size_t> kinds_;
  std::vector<Diagnostic> passed_over_;  ///< the first of each kind
};

/// An element of the file: its attributes as numbers, and complaints that name its place. Every
/// reader reports what is malformed as an error and goes on with a stand-in, so that one run shows
/// all faults; whether there were any is `UrdfReading::failed`.
class UrdfElement {
 public:
  UrdfElement(const tinyxml2::XMLElement& xml, std::string path, UrdfReading& reading)
      : xml_(&xml), path_(std::move(path)), reading_(&reading) {}

  [[nodiscard]] std::string_view name() const { return xml_->Name(); }
  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] int line() const { return xml_->GetLineNum(); }
  [[nodiscard]] UrdfReading& reading() const { return *reading_; }
  [[nodiscard]] const tinyxml2::XMLElement& xml() const { return *xml_; }

  void error(std::string fault, std::string remedy) const;
  void warn(std::string fault, std::string remedy, Minor minor = Minor::none) const;

  [[nodiscard]] bool has(const char* attribute) const {
    return xml_->Attribute(attribute) != nullptr;
  }
  /// The attribute's text; an error when it is absent or empty, with `remedy`.
  [[nodiscard]] std::optional<std::string> required_text(const char* attribute,
                                                         const std::string& remedy) const;
  /// The attribute "name"; an error when it is absent, empty, not UTF-8, not one printable line or
  /// longer than `kLongestName`.
  [[nodiscard]] std::string required_name(const std::string& remedy) const;
  /// Nothing when absent; an error when it is no finite number (or, if allowed, an infinite one),
  /// or one too large to compute with, see `is_too_large`.
  [[nodiscard]] std::optional<double> number(const char* attribute,
                                             bool may_be_infinite = false) const;
  /// Nothing when absent; an error when it is not three finite numbers.
  [[nodiscard]] std::optional<std::array<double, 3>> three_numbers(const char* attribute) const;

  /// The first child of that name; a warning when there are more: the first counts, as in urdfdom.
  [[nodiscard]] std::optional<UrdfElement> child(const char* name) const;
  [[nodiscard]] UrdfElement as_child(const tinyxml2::XMLElement& xml) const;

  /// Warns of attributes and child elements that are not among these, and of stray text. An error
  /// where capitals are all that makes the difference: what the file's author meant would be lost.
  void only_attributes(std::initializer_list<std::string_view> known) const;
  void only_children(std::initializer_list<std::string_view> known) const;
  /// Likewise of one child element that is not among `known`.
  void pass_over_child(const UrdfElement& child,
                       std::initializer_list<std::string_view> known) const;
  void no_text() const;
  /// Warns like `only_attributes`, of an element that may have attributes and nothing inside. An
  /// error if it contains what would be one of these attributes, or a number.
  void holds_only_attributes(std::initializer_list<std::string_view> known) const;

  /// Position and orientation of a child `<origin>`; zero where absent.
  [[nodiscard]] Pose origin() const;

 private:
  [[nodiscard]] std::string kind() const;
  void refuse_large(const char* attribute, double value) const;
  void warn_if_lost(const char* attribute, std::string_view text, double value) const;

  const tinyxml2::XMLElement* xml_;
  std::string path_;
  UrdfReading* reading_;
};

}  // namespace treeline
