#include "emission/adapt.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <vector>

#include "emission/backend.hpp"
#include "emission/c_family_syntax.hpp"
#include "text/identifier.hpp"

namespace treeline {
namespace {

/// `TL_REAL(1.5)` at the front of a text, whose first word was taken off, as a literal.
std::string take_literal(std::string_view& text, const Adaptation& own) {
  const std::size_t end = text.find(')');
  const std::string digits(text.substr(1, end - 1));
  text.remove_prefix(end + 1);
  return digits + own.suffix;
}

/// The robot's name and the part's, as C has them before others.
std::string name_of_part(const Adaptation& own) {
  return own.part.empty() ? own.name : own.name + "_" + own.part;
}

std::string rename(std::string_view word, const Adaptation& own) {
  if (const auto found = own.words.find(word); found != own.words.end()) return found->second;
  if (word.starts_with("TL_")) return constant_name(own, word.substr(3));
  const bool is_type = word.starts_with("Tl");
  if (!is_type && !word.starts_with("tl_")) return std::string(word);
  const std::string rest(word.substr(is_type ? 2 : 3));
  if (backend_of(own.language).has_namespaces) return rest;
  return name_of_part(own) + "_" + (is_type ? in_snake_case(rest) : rest);
}

/// Whether a line tells a compiler what it knows of itself in this language.
bool is_known(std::string_view line, const Backend& backend) {
  return std::any_of(backend.known.begin(), backend.known.end(),
                     [&](std::string_view front) { return line.starts_with(front); });
}

/// The comment on the whole and the includes, and what is behind them.
struct Parts {
  std::string_view comment, includes, rest;
};

bool is_comment(std::string_view line) {
  return line.starts_with("#pragma once") || (line.starts_with("//") && !line.starts_with("///"));
}

bool is_include(std::string_view line) {
  return line.starts_with("#include") || line.starts_with("\n");
}

/// Takes the lines of a kind from the front of a text.
std::string_view take_lines(std::string_view& text, bool (*is_taken)(std::string_view)) {
  std::size_t at = 0;
  while (at < text.size() && is_taken(text.substr(at))) at = text.find('\n', at) + 1;
  const std::string_view taken = text.substr(0, at);
  text.remove_prefix(at);
  return taken;
}

Parts take_apart(std::string_view header) {
  Parts parts;
  parts.comment = take_lines(header, is_comment);
  parts.includes = take_lines(header, is_include);
  parts.rest = header;
  return parts;
}

/// A branch around a line.
struct Branch {
  std::string other, end;  ///< how the lines begin that turn to the other branch, and end both
  bool stays;
  std::size_t indentation;  ///< that its lines lose
};

/// The branch that a line opens: `#if TL_TASK`, or `if (TL_TASK) {` where the word is 1 or 0.
std::optional<Branch> open_branch(std::string_view line, const Adaptation& own) {
  const std::string blanks(line.substr(0, line.find_first_not_of(' ')));
  line.remove_prefix(blanks.size());
  const bool of_text = line.starts_with("#if TL_");
  if (!of_text && !(line.starts_with("if (TL_") && line.ends_with(") {\n"))) return std::nullopt;
  line.remove_prefix(4);
  const std::string word(line.substr(0, line.find_first_of(")\n")));
  if (of_text) return Branch{"#else", "#endif", own.words.at(word) == "1", 0};
  const auto found = own.words.find(word);
  if (found == own.words.end()) return std::nullopt;
  return Branch{blanks + "} else {", blanks + "}\n", found->second == "1", 2};
}

}  // namespace

Adaptation make_adaptation(const EmissionContext& context, const std::string& contract) {
  const Backend& backend = backend_of(context.language);
  Adaptation own{context.language,
                 context.name,
                 contract,
                 {{"real", number_type(context)},
                  {"TL_REAL_BYTES", std::to_string(number_bytes(context))},
                  {"TL_ZERO", number_literal(context, "0.0")},
                  {"TL_ONE", number_literal(context, "1.0")},
                  {"TL_TEN", number_literal(context, "10.0")}},
                 context.single_precision ? "F" : ""};
  own.words.insert(backend.words.begin(), backend.words.end());
  if (context.misra) own.words["TL_FUNCTION"] = backend.words.at("TL_SAFE_FUNCTION");
  return own;
}

void add_literals(const EmissionContext& context, std::initializer_list<WordOfNumber> numbers,
                  Adaptation& own) {
  for (const auto& [word, digits] : numbers) own.words[word] = number_literal(context, digits);
}

void add_number_format(const EmissionContext& context, Adaptation& own) {
  const bool single = context.single_precision;
  own.words["TlBits"] = rename(single ? "uint32_t" : "uint64_t", own);
  own.words["TL_FRACTION_BITS"] = single ? "23U" : "52U";
  own.words["TL_SIGN_AT"] = single ? "31U" : "63U";
  own.words["TL_BIAS"] = single ? "127" : "1023";
}

std::string constant_name(const Adaptation& own, std::string_view name) {
  if (!backend_of(own.language).has_namespaces || own.constants_of_c) {
    return fmt::format("{}_{}", in_capitals(name_of_part(own)), name);
  }
  std::string words(name);
  for (char& c : words) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return "k" + in_pascal_case(words);
}

bool belongs_to_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

std::string choose_branches(std::string_view text, const Adaptation& own) {
  std::string chosen;
  std::vector<Branch> open;
  while (!text.empty()) {
    const std::size_t length = std::min(text.find('\n'), text.size() - 1) + 1;
    std::string_view line = text.substr(0, length);
    text.remove_prefix(length);
    if (std::optional<Branch> next = open_branch(line, own)) {
      open.push_back(*next);
    } else if (!open.empty() && line.starts_with(open.back().other)) {
      open.back().stays = !open.back().stays;
    } else if (!open.empty() && line.starts_with(open.back().end)) {
      open.pop_back();
    } else if (std::all_of(open.begin(), open.end(), [](const Branch& b) { return b.stays; })) {
      for (const Branch& branch : open) {
        line.remove_prefix(std::min(branch.indentation, line.find_first_not_of(' ')));
      }
      chosen += line;
    }
  }
  return chosen;
}

std::string adapt_words(std::string_view given, const Adaptation& own) {
  std::string adapted;
  const std::string branches = choose_branches(given, own);
  std::string_view text = branches;
  const Backend& backend = backend_of(own.language);
  while (!text.empty()) {
    if (is_known(text, backend)) {
      text.remove_prefix(text.find('\n') + 1);
      continue;
    }
    std::size_t end = 0;
    while (end < text.size() && belongs_to_word(text[end])) ++end;
    const bool of_library = adapted.ends_with("#include <");
    const std::string_view word = text.substr(0, std::max<std::size_t>(end, 1));
    text.remove_prefix(word.size());
    if (word == "TL_REAL" && !own.words.contains(word)) {
      adapted += take_literal(text, own);
      continue;
    }
    adapted += rename(word, own);
    const bool is_header = end > 0 && text.starts_with(".h") &&
                           (text.size() == 2 || !belongs_to_word(text[2])) &&
                           own.contract != std::string(word) + ".h";
    if (is_header && !of_library) {
      adapted += backend.header;
      text.remove_prefix(2);
    }
  }
  return adapted;
}

std::string adapt(std::string_view header, const Adaptation& own) {
  const Parts parts = take_apart(header);
  const std::string generated =
      fmt::format("// Generated; see {} for the contract.\n", own.contract);
  const std::string front =
      adapt_words(parts.comment, own) + generated + adapt_words(parts.includes, own);
  const std::string rest = adapt_words(parts.rest, own);
  if (!backend_of(own.language).has_namespaces) return front + rest;
  std::string text = rest;
  for (const std::string& scope : {own.part, std::string("detail"), own.name}) {
    if (scope.empty()) continue;
    const bool is_inner = text.starts_with("namespace ");
    text = fmt::format("namespace {0} {{\n{2}{1}{2}}}  // namespace {0}\n", scope, text,
                       is_inner ? "" : "\n");
  }
  return front + text;
}

std::string join_headers(std::span<const std::string_view> others, std::string_view last) {
  const Parts parts = take_apart(last);
  std::string joined = std::string(parts.comment) + std::string(parts.includes);
  for (const std::string_view each : others) joined += std::string(take_apart(each).rest) + "\n";
  return joined + std::string(parts.rest);
}

std::string adapt_declarations(std::string_view header, const Adaptation& own) {
  return adapt_words(take_apart(header).rest, own);
}

}  // namespace treeline
