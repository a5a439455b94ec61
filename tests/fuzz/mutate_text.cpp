#include "mutate_text.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "words.hpp"

namespace treeline::fuzz {
namespace {

struct Span {
  std::size_t at = 0, size = 0;
};

std::size_t below(std::size_t count, Random& random) {
  return count == 0 ? 0 : random() % count;
}

template <std::size_t N>
std::string one_of(const std::array<std::string_view, N>& words, Random& random) {
  return std::string(words[below(N, random)]);
}

/// Replaces the text of one of the spans. Returns the text unchanged if there are none.
std::string replace_one(std::string text, const std::vector<Span>& spans, const std::string& by,
                        Random& random) {
  if (spans.empty()) return text;
  const Span& span = spans[below(spans.size(), random)];
  return text.replace(span.at, span.size, by);
}

/// Finds the texts between quotes of either kind.
std::vector<Span> find_quoted(std::string_view text) {
  std::vector<Span> spans;
  for (std::size_t at = text.find_first_of("\"'"); at != std::string_view::npos;
       at = text.find_first_of("\"'", at + 1)) {
    const std::size_t end = text.find(text[at], at + 1);
    if (end == std::string_view::npos) break;
    spans.push_back({at + 1, end - at - 1});
    at = end;
  }
  return spans;
}

/// Finds words before `=`, or after `<` and `</`.
std::vector<Span> find_names(std::string_view text, bool attributes) {
  constexpr std::string_view kEnds = " \t\r\n/>=<\"'";
  std::vector<Span> spans;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (attributes ? text[at] != '=' : text[at] != '<') continue;
    if (attributes) {
      std::size_t first = at;
      while (first > 0 && kEnds.find(text[first - 1]) == std::string_view::npos) --first;
      spans.push_back({first, at - first});
    } else {
      const std::size_t first = at + (text.substr(at, 2) == "</" ? 2 : 1);
      spans.push_back({first, std::min(text.find_first_of(kEnds, first), text.size()) - first});
    }
  }
  return spans;
}

/// Picks an element with its content, by counting tags from a random one. Empty if there is none.
Span pick_subtree(std::string_view text, Random& random) {
  std::vector<std::size_t> starts;
  for (std::size_t at = text.find('<'); at != std::string_view::npos; at = text.find('<', at + 1)) {
    if (at + 1 < text.size() && text[at + 1] != '/' && text[at + 1] != '!') starts.push_back(at);
  }
  if (starts.empty()) return {};
  const std::size_t begin = starts[below(starts.size(), random)];
  int depth = 0;
  for (std::size_t at = begin; at != std::string_view::npos; at = text.find('<', at + 1)) {
    const std::size_t end = text.find('>', at);
    if (end == std::string_view::npos) break;
    if (text[at + 1] == '/') --depth;
    if (text[at + 1] != '/' && text[at + 1] != '!' && text[end - 1] != '/') ++depth;
    if (depth <= 0) return {begin, end + 1 - begin};
  }
  return {begin, text.size() - begin};
}

/// Picks a place, mostly between tags.
std::size_t pick_gap(std::string_view text, Random& random) {
  const std::size_t from = below(text.size() + 1, random);
  const std::size_t gap = text.find('<', from);
  return gap == std::string_view::npos || random() % 8 == 0 ? from : gap;
}

std::string numbers(std::size_t count, Random& random) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) text += ' ';
    text += one_of(kNumbers, random);
  }
  return text;
}

/// A value of the kind that the old one seems to have, or of another kind.
std::string new_value(std::string_view old, std::string_view text, Random& random) {
  const auto quoted = find_quoted(text);
  switch (random() % 6) {
    case 0:
      return one_of(kTypes, random);
    case 1: {
      if (quoted.empty()) return "a";
      const Span& other = quoted[below(quoted.size(), random)];
      return std::string(text.substr(other.at, other.size));
    }
    case 2:
      return std::string(old) + one_of(kOddBytes, random);
    default: {
      const bool three = old.find(' ') != std::string_view::npos;
      return numbers(random() % 16 == 0 ? random() % 5 : three ? 3 : 1, random);
    }
  }
}

std::string nested(std::string_view inside, const std::string& element, Random& random) {
  std::string opening, closing;
  const std::size_t depth = random() % 8 == 0 ? 1 + random() % 300 : 1 + random() % 4;
  for (std::size_t i = 0; i < depth; ++i) {
    opening += "<" + element + ">";
    closing += "</" + element + ">";
  }
  return opening + std::string(inside) + closing;
}

/// Finds every word of a scene that is not white space or punctuation.
std::vector<Span> find_words(std::string_view text) {
  constexpr std::string_view kEnds = " \t\r\n,:[]{}#&*!|>'\"%@`";
  std::vector<Span> spans;
  for (std::size_t at = text.find_first_not_of(kEnds); at != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(kEnds, at), text.size());
    spans.push_back({at, end - at});
    at = text.find_first_not_of(kEnds, end);
  }
  return spans;
}

std::vector<Span> find_lines(std::string_view text) {
  std::vector<Span> spans;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size() - 1) + 1;
    spans.push_back({at, end - at});
    at = end;
  }
  return spans;
}

Span pick(const std::vector<Span>& spans, Random& random) {
  return spans.empty() ? Span{} : spans[below(spans.size(), random)];
}

}  // namespace

std::string mutate_urdf(std::string text, Random& random) {
  const Span subtree = pick_subtree(text, random);
  const std::string copy = text.substr(subtree.at, subtree.size);
  switch (random() % 12) {
    case 0:
      return replace_one(text, find_names(text, true), one_of(kAttributes, random), random);
    case 1:
      return replace_one(text, find_names(text, false), one_of(kElements, random), random);
    case 2:
      return text.erase(subtree.at, subtree.size);
    case 3:
      return text.insert(pick_gap(text, random), copy);
    case 4:
      text.erase(subtree.at, subtree.size);
      return text.insert(pick_gap(text, random), copy);
    case 5:
      return text.replace(subtree.at, subtree.size,
                          nested(copy, one_of(kElements, random), random));
    case 6:
      return text.insert(below(text.size() + 1, random), one_of(kOddBytes, random));
    case 7:
    case 8:
      return text.insert(pick_gap(text, random), one_of(kInsertedXml, random));
    default: {
      const Span value = pick(find_quoted(text), random);
      return text.replace(value.at, value.size,
                          new_value(text.substr(value.at, value.size), text, random));
    }
  }
}

std::string mutate_scene(std::string text, Random& random) {
  const Span word = pick(find_words(text), random);
  const Span line = pick(find_lines(text), random);
  const std::string copy = text.substr(line.at, line.size);
  const Span other = pick(find_lines(text), random);
  switch (random() % 10) {
    case 0:
      return text.replace(word.at, word.size, one_of(kSceneKeys, random));
    case 1:
      return text.replace(word.at, word.size, one_of(kSceneValues, random));
    case 2:
      return text.erase(line.at, line.size);
    case 3:
      return text.insert(other.at, copy);
    case 4:
      return text.insert(line.at, std::string(1 + random() % 4, ' '));
    case 5:
      return text.insert(below(text.size() + 1, random), one_of(kOddBytes, random));
    case 6:
      return text.insert(other.at,
                         one_of(kSceneKeys, random) + ": " + one_of(kSceneValues, random) + "\n");
    case 7: {
      constexpr std::string_view kOpening = "[{-?&*!|>\"'#,:]}";
      const std::size_t times = random() % 8 == 0 ? random() % 1000 : 1;
      return text.insert(below(text.size() + 1, random),
                         std::string(times, kOpening[below(kOpening.size(), random)]));
    }
    default:
      return text.replace(word.at, word.size, one_of(kNumbers, random));
  }
}

std::string mutate_both(const std::string& text, Random& random) {
  const std::size_t mark = text.find(kSceneMark);
  const std::size_t end = std::min(mark, text.size());
  std::string urdf = text.substr(0, end);
  std::string scene = mark == std::string::npos ? "" : text.substr(mark + kSceneMark.size());
  if (random() % 2 == 0) {
    urdf = mutate_urdf(std::move(urdf), random);
  } else {
    scene = mutate_scene(std::move(scene), random);
  }
  return urdf + kSceneMark + scene;
}

}  // namespace treeline::fuzz
