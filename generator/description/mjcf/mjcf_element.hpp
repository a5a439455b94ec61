#pragma once

#include <tinyxml2.h>

#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "text/diagnostic.hpp"

namespace treeline {

/// Attributes that elements of a class have unless they give others: by kind of element, by name.
using MjcfDefaults = std::map<std::string, std::map<std::string, std::string>>;

/// One reading of an MJCF file and of those that it includes: their elements, the classes of
/// defaults, and where faults go.
class MjcfReading {
 public:
  MjcfReading(std::string path, Diagnostics& diagnostics)
      : path_(std::move(path)), diagnostics_(diagnostics) {}

  /// The root element of the model; null, with an error, where the text is no XML.
  const tinyxml2::XMLElement* parse(const std::string& text);

  /// The child elements, those of included files in the place of `<include>`.
  std::vector<const tinyxml2::XMLElement*> children(const tinyxml2::XMLElement& parent);

  /// Reads a `<default>` with the classes inside it; `inherited` is the class around it.
  void read_defaults(const tinyxml2::XMLElement& element, const MjcfDefaults& inherited);

  /// The class of that name; null if there is none.
  [[nodiscard]] const MjcfDefaults* find_class(const std::string& name) const;

  /// What is no error is told once for each fault, by `report_counts`, with the number of places.
  void report(Severity severity, const tinyxml2::XMLElement& at, std::string fault,
              std::string remedy);
  void report_counts();

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] bool failed() const { return failed_; }

 private:
  const tinyxml2::XMLElement* add_file(const std::string& text, const std::string& shown);
  const tinyxml2::XMLElement* include(const tinyxml2::XMLElement& element);

  std::string path_;
  Diagnostics& diagnostics_;
  std::vector<std::unique_ptr<tinyxml2::XMLDocument>> documents_;
  std::map<const tinyxml2::XMLDocument*, std::string> files_;  ///< as messages name them
  std::map<const tinyxml2::XMLElement*, const tinyxml2::XMLElement*> included_;  ///< their roots
  std::map<std::string, MjcfDefaults> classes_;
  std::map<std::string, std::size_t> counts_;  ///< by fault
  std::vector<Diagnostic> counted_;            ///< the first of each
  bool failed_ = false;
};

/// An element of the model, with what its class of defaults gives it. What is malformed is an
/// error, and a stand-in is handed over, so that one run shows all faults.
class MjcfElement {
 public:
  /// `around` is the `childclass` that holds where it stands.
  MjcfElement(const tinyxml2::XMLElement& xml, std::string around, MjcfReading& reading);

  [[nodiscard]] std::string_view name() const { return xml_->Name(); }
  [[nodiscard]] const tinyxml2::XMLElement& xml() const { return *xml_; }
  [[nodiscard]] MjcfReading& reading() const { return *reading_; }
  [[nodiscard]] std::vector<MjcfElement> children() const;

  /// The text of an attribute; nothing where neither the element nor its class has it.
  [[nodiscard]] std::optional<std::string> find(const char* attribute) const;
  [[nodiscard]] bool has(const char* attribute) const { return find(attribute).has_value(); }
  [[nodiscard]] std::string text(const char* attribute, const char* otherwise = "") const {
    return find(attribute).value_or(otherwise);
  }
  [[nodiscard]] bool is(const char* attribute, const char* value) const {
    return text(attribute) == value;
  }
  /// `least` to `most` finite numbers; empty where absent, and where there are others: an error.
  [[nodiscard]] std::vector<double> numbers(const char* attribute, std::size_t least,
                                            std::size_t most) const;
  [[nodiscard]] double number(const char* attribute, double otherwise) const;

  void error(std::string fault, std::string remedy) const {
    reading_->report(Severity::error, *xml_, std::move(fault), std::move(remedy));
  }
  void warn(std::string fault, std::string remedy) const {
    reading_->report(Severity::warning, *xml_, std::move(fault), std::move(remedy));
  }
  void note(std::string fault, std::string remedy) const {
    reading_->report(Severity::note, *xml_, std::move(fault), std::move(remedy));
  }

 private:
  const tinyxml2::XMLElement* xml_;
  std::string around_;  ///< class for this element and, unless it says otherwise, for its children
  MjcfReading* reading_;
  const MjcfDefaults* class_ = nullptr;
};

}  // namespace treeline
