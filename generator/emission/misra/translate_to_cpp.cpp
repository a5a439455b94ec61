#include "emission/misra/translate_to_cpp.hpp"

#include <fmt/format.h>

#include <cctype>
#include <regex>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include "emission/c_family_syntax.hpp"
#include "emission/wrap_line.hpp"

namespace treeline::misra {
namespace {

/// The text with what `print` makes of each match in its place.
template <class Print>
std::string replace_each(const std::string& text, const std::regex& pattern, const Print& print) {
  std::string replaced;
  auto from = text.cbegin();
  for (std::sregex_iterator found(text.cbegin(), text.cend(), pattern), end; found != end;
       ++found) {
    replaced.append(from, text.cbegin() + found->position());
    replaced += print(*found);
    from = text.cbegin() + found->position() + found->length();
  }
  return replaced.append(from, text.cend());
}

/// `most_rows` and `MOST_ROWS` as `kMostRows`.
std::string name_constant(std::string word) {
  for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return fmt::format("k{}", in_pascal_case(word));
}

/// Adds what a pattern finds first in each of its matches.
void add_names(const std::string& text, const std::regex& pattern, std::set<std::string>& names) {
  for (std::sregex_iterator found(text.begin(), text.end(), pattern), end; found != end; ++found) {
    names.insert((*found)[1].str());
  }
}

/// `typedef struct { ... } @_cone_row;` as `struct @_cone_row { ... };`.
std::string declare_structs(const std::string& text) {
  static const std::regex structure("typedef struct \\{\n([^}]*)\\} @_(\\w+);");
  return std::regex_replace(text, structure, "struct @_$2 {\n$1};");
}

/// Lists of enumerators without a name as constants.
std::string declare_constants(const std::string& text) {
  static const std::regex local("enum \\{ (\\w+ = [^{}]*) \\};");
  static const std::regex list("enum \\{\n([^}]*)\\};");
  static const std::regex enumerator(
      "  (@@?_\\w+) = ([^,\n]*?) *(?:,|(?=  //)|(?=\n))(?: *(  //[^\n]*))?\n");
  return replace_each(
      std::regex_replace(text, local, "constexpr int $1;"), list, [](const std::smatch& found) {
        const std::string constants =
            std::regex_replace(found[1].str(), enumerator, "inline constexpr int $1 = $2;$3\n");
        return constants.substr(0, constants.size() - 1);
      });
}

/// Heads of functions in as few lines as hold them.
std::string wrap_heads(const std::string& text) {
  static const std::regex head("static inline ([^;{]*)\\) \\{\n");
  static const std::regex blanks("\\s+");
  static const std::regex opening("\\( ");
  return replace_each(text, head, [](const std::smatch& found) {
    const std::string line = std::regex_replace(found[1].str(), blanks, " ");
    return wrap_line(fmt::format("inline {}) noexcept {{", std::regex_replace(line, opening, "(")),
                     0);
  });
}

/// What the headers declare, without the prefix.
struct Names {
  std::set<std::string> types, constants;
};

std::string rename_all(const std::string& text, const Names& names) {
  static const std::regex capitals("@@_(\\w+)");
  static const std::regex own("@_(\\w+)");
  const std::string renamed = replace_each(
      text, capitals, [](const std::smatch& found) { return name_constant(found[1].str()); });
  return replace_each(renamed, own, [&](const std::smatch& found) {
    const std::string word = found[1].str();
    if (names.types.contains(word)) return in_pascal_case(word);
    return names.constants.contains(word) ? name_constant(word) : word;
  });
}

void reject_left_over(const GeneratedFile& header) {
  static const std::regex left_over("@|typedef|enum|static|\\bint\\b|\\.h\"");
  std::smatch found;
  if (std::regex_search(header.text, found, left_over)) {
    throw std::logic_error(fmt::format("{}: `{}` is left of C", header.name, found[0].str()));
  }
}

}  // namespace

void translate_to_cpp(std::vector<GeneratedFile>& headers) {
  static const std::regex structure("struct @_(\\w+) \\{");
  static const std::regex constant("inline constexpr (?:int|@_\\w+) @_(\\w+) =");
  static const std::regex header_of_c("\\b(\\w+)\\.h\\b");
  static const std::regex integer("\\bint\\b");
  Names names;
  for (GeneratedFile& header : headers) {
    header.text = declare_constants(declare_structs(header.text));
    add_names(header.text, structure, names.types);
    add_names(header.text, constant, names.constants);
  }
  for (GeneratedFile& header : headers) {
    header.text = std::regex_replace(header.text, header_of_c, "$1.hpp");
    header.text = std::regex_replace(header.text, integer, "int32_t");
    header.text = wrap_heads(rename_all(header.text, names));
    reject_left_over(header);
  }
}

}  // namespace treeline::misra
