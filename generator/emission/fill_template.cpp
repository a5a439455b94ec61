#include <set>
#include <stdexcept>

#include "emission/emitted_text.hpp"

namespace treeline {
namespace {

class Filler {
 public:
  explicit Filler(const std::map<std::string, std::string>& values) : values_(values) {}

  std::string fill(std::string_view text) {
    while (!text.empty()) {
      const std::size_t end = text.find('\n');
      fill_line(text.substr(0, end));
      text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
    return std::move(filled_);
  }

  void expect_all_used() const {
    for (const auto& [name, value] : values_) {
      if (!used_.contains(name)) {
        throw std::logic_error("the template has no hole {{" + name + "}}");
      }
    }
  }

 private:
  void fill_line(std::string_view line) {
    const std::size_t indentation = std::min(line.find_first_not_of(' '), line.size());
    const std::string_view rest = line.substr(indentation);
    if (rest.starts_with("{{") && rest.find("}}") + 2 == rest.size()) {
      append_block(value_of(rest.substr(2, rest.size() - 4)), line.substr(0, indentation));
      return;
    }
    for (std::size_t open = line.find("{{"); open != std::string_view::npos;
         open = line.find("{{")) {
      const std::size_t close = line.find("}}", open);
      if (close == std::string_view::npos) {
        throw std::logic_error("a hole of the template is not closed: " + std::string(line));
      }
      filled_ += line.substr(0, open);
      filled_ += value_of(line.substr(open + 2, close - open - 2));
      line.remove_prefix(close + 2);
    }
    filled_ += line;
    filled_ += '\n';
  }

  void append_block(std::string_view value, std::string_view indentation) {
    while (!value.empty()) {
      const std::size_t end = value.find('\n');
      const std::string_view line = value.substr(0, end);
      filled_ += line.empty() ? std::string_view() : indentation;
      filled_ += line;
      filled_ += '\n';
      value.remove_prefix(end == std::string_view::npos ? value.size() : end + 1);
    }
  }

  const std::string& value_of(std::string_view name) {
    const auto found = values_.find(std::string(name));
    if (found == values_.end()) {
      throw std::logic_error("no value for the template's hole {{" + std::string(name) + "}}");
    }
    used_.insert(found->first);
    return found->second;
  }

  const std::map<std::string, std::string>& values_;
  std::set<std::string> used_;
  std::string filled_;
};

}  // namespace

std::string fill_template(std::string_view text, const std::map<std::string, std::string>& values) {
  Filler filler(values);
  std::string filled = filler.fill(text);
  filler.expect_all_used();
  return filled;
}

std::string fill_holes(std::string_view text, const std::map<std::string, std::string>& values) {
  return Filler(values).fill(text);
}

}  // namespace treeline
