#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "description/scan_xml.hpp"
#include "description/xml_faults.hpp"

namespace treeline {
namespace {

/// The value of a start tag's attribute "name"; empty if it has none.
std::string_view named(const XmlTag& tag) {
  const auto found = std::find_if(tag.attributes.begin(), tag.attributes.end(),
                                  [](const XmlAttribute& each) { return each.name == "name"; });
  return found == tag.attributes.end() ? std::string_view() : found->value;
}

/// Walks the tags of a text and keeps those that are open.
class TagWalk {
 public:
  explicit TagWalk(std::string_view text) : text_(text) {}

  /// Up to the first fault, the end or that line.
  void walk(int last_line) {
    while (!fault_) {
      move_to(text_.find('<', at_));
      std::size_t next = at_;
      const auto tag = line_ < last_line ? next_tag(text_, next) : std::nullopt;
      if (!tag) return;
      take(*tag);
      move_to(next);
    }
  }

  [[nodiscard]] const std::vector<OpenElement>& open() const { return open_; }
  [[nodiscard]] const std::optional<UnclosedElement>& fault() const { return fault_; }
  [[nodiscard]] int line() const { return line_; }

 private:
  void move_to(std::size_t to) {
    to = std::min(to, text_.size());
    line_ += static_cast<int>(std::count(text_.begin() + static_cast<std::ptrdiff_t>(at_),
                                         text_.begin() + static_cast<std::ptrdiff_t>(to), '\n'));
    at_ = to;
  }

  void take(const XmlTag& tag) {
    const std::string name(tag.name);
    if (tag.kind == XmlTag::Kind::end) {
      close(name);
    } else if (tag.kind == XmlTag::Kind::start) {
      const std::string_view called = named(tag);
      open_.push_back({name,
                       called.empty() ? fmt::format("<{}>", name)
                                      : fmt::format("<{} name=\"{}\">", name, called),
                       line_});
    }
  }

  void close(const std::string& name) {
    if (open_.empty()) {
      fault_ = UnclosedElement{{}, fmt::format("</{}>", name), line_};
    } else if (open_.back().name != name) {
      fault_ = UnclosedElement{open_.back(), fmt::format("</{}>", name), line_};
    } else {
      open_.pop_back();
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1;
  std::vector<OpenElement> open_;
  std::optional<UnclosedElement> fault_;
};

}  // namespace

std::optional<UnclosedElement> find_unclosed_element(std::string_view text) {
  TagWalk walk(text);
  walk.walk(std::numeric_limits<int>::max());
  if (walk.fault()) {
    return walk.fault()->open.name.empty() ? std::nullopt : walk.fault();
  }
  if (walk.open().empty()) return std::nullopt;
  return UnclosedElement{walk.open().back(), "", walk.line()};
}

std::optional<OpenElement> find_open_element(std::string_view text, int line) {
  TagWalk walk(text);
  walk.walk(line);
  if (walk.open().empty()) return std::nullopt;
  return walk.open().back();
}

}  // namespace treeline
