#include "description/find_open_element.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace treeline {
namespace {

constexpr auto kNowhere = std::string_view::npos;

/// The name that a tag begins with.
std::string_view name_in(std::string_view tag) {
  return tag.substr(0, std::min(tag.find_first_of(" \t\r\n/>"), tag.size()));
}

/// The value of the attribute "name" of a start tag; empty when there is none.
std::string_view named(std::string_view tag) {
  for (auto at = tag.find("name="); at != kNowhere; at = tag.find("name=", at + 1)) {
    const bool whole = at > 0 && std::string_view(" \t\r\n").find(tag[at - 1]) != kNowhere;
    if (!whole || at + 5 >= tag.size()) continue;
    const char quote = tag[at + 5];
    const auto end = tag.find(quote, at + 6);
    if ((quote == '"' || quote == '\'') && end != kNowhere) return tag.substr(at + 6, end - at - 6);
  }
  return {};
}

/// Walks the tags of a text and keeps those that are open.
class TagWalk {
 public:
  explicit TagWalk(std::string_view text) : text_(text) {}

  /// Up to the first fault, the end or that line.
  void walk(int last_line) {
    while (!fault_ && advance_to('<') && line_ < last_line) {
      const std::string_view rest = text_.substr(at_);
      if (rest.starts_with("<!--")) {
        skip_past("-->");
      } else if (rest.starts_with("<![CDATA[")) {
        skip_past("]]>");
      } else if (rest.starts_with("<?") || rest.starts_with("<!")) {
        skip_past(">");
      } else {
        take_tag(rest.starts_with("</"));
      }
    }
  }

  [[nodiscard]] const std::vector<OpenElement>& open() const { return open_; }
  [[nodiscard]] bool ended() const { return at_ >= text_.size(); }
  [[nodiscard]] const std::optional<UnclosedElement>& fault() const { return fault_; }
  [[nodiscard]] int line() const { return line_; }

 private:
  void move_to(std::size_t to) {
    to = std::min(to, text_.size());
    line_ += static_cast<int>(std::count(text_.begin() + static_cast<std::ptrdiff_t>(at_),
                                         text_.begin() + static_cast<std::ptrdiff_t>(to), '\n'));
    at_ = to;
  }

  bool advance_to(char c) {
    move_to(text_.find(c, at_));
    return !ended();
  }

  void skip_past(std::string_view end) {
    const auto found = text_.find(end, at_);
    move_to(found == kNowhere ? found : found + end.size());
  }

  /// Where the tag that begins here ends, not counting what stands in quotes.
  [[nodiscard]] std::size_t end_of_tag() const {
    char quote = 0;
    for (std::size_t i = at_; i < text_.size(); ++i) {
      const char c = text_[i];
      if (quote != 0) {
        quote = c == quote ? char{0} : quote;
      } else if (c == '"' || c == '\'') {
        quote = c;
      } else if (c == '>') {
        return i;
      }
    }
    return text_.size();
  }

  void take_tag(bool is_end) {
    const std::size_t end = end_of_tag();
    const std::string_view inside =
        text_.substr(at_, end - at_).substr(is_end ? 2 : 1);  // without `<` or `</`
    const std::string name(name_in(inside));
    if (is_end) {
      close(name);
    } else if (!inside.ends_with('/')) {
      const std::string_view called = named(inside);
      open_.push_back({name,
                       called.empty() ? fmt::format("<{}>", name)
                                      : fmt::format("<{} name=\"{}\">", name, called),
                       line_});
    }
    move_to(end + 1);
  }

  void close(const std::string& name) {
    if (open_.empty()) {
      fault_ = UnclosedElement{};
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
