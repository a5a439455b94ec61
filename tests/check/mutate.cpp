#include "mutate.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace treeline::tests {
namespace {

/// The statements of a source: beginning and end of its function's body.
struct Body {
  std::size_t begin = 0, end = 0;
};

Body body_of(const std::string& source) {
  const std::string head = "noexcept {";
  return {source.find(head) + head.size(), source.rfind("\n}\n\n}  // namespace")};
}

/// Replaces comments by spaces, so that the length stays the same.
std::string without_comments(std::string text) {
  for (std::size_t at = text.find("//"); at != std::string::npos; at = text.find("//", at)) {
    while (at < text.size() && text[at] != '\n') text[at++] = ' ';
  }
  return text;
}

class Mutator {
 public:
  Mutator(const std::string& source, Rng& rng)
      : source_(source), readable_(without_comments(source)), body_(body_of(source)), rng_(rng) {}

  std::vector<Mutant> make(Mutation mutation) {
    switch (mutation) {
      case Mutation::constant:
        scale_constants(mutation, 1.01);
        break;
      case Mutation::hair:
        scale_constants(mutation, 1 + 1e-9);
        break;
      case Mutation::sign:
        flip_signs();
        break;
      case Mutation::index:
        change_indices();
        break;
      case Mutation::name:
        change_names();
        break;
    }
    return std::move(mutants_);
  }

 private:
  template <class Use>
  void each_match(const std::string& pattern, const Use& use) {
    const std::regex regex(pattern);
    const auto begin = readable_.cbegin() + static_cast<std::ptrdiff_t>(body_.begin);
    const auto end = readable_.cbegin() + static_cast<std::ptrdiff_t>(body_.end);
    for (std::sregex_iterator at(begin, end, regex), none; at != none; ++at) use(*at);
  }

  void replace(Mutation mutation, const std::smatch& match, std::size_t group,
               const std::string& by) {
    const std::size_t at = body_.begin + static_cast<std::size_t>(match.position(group));
    const auto length = static_cast<std::size_t>(match.length(group));
    Mutant mutant{mutation, source_, ""};
    mutant.text.replace(at, length, by);
    const std::size_t line = source_.rfind('\n', at) + 1;
    mutant.description = std::string(mutation_name(mutation)) + ": `" +
                         source_.substr(line, source_.find('\n', at) - line) +
                         "`: " + match.str(group) + " becomes " + by;
    mutants_.push_back(mutant);
  }

  void scale_constants(Mutation mutation, double factor) {
    each_match(R"(([0-9]+\.[0-9]+(?:e[-+]?[0-9]+)?)f?)", [&](const std::smatch& match) {
      const double value = std::strtod(match.str(1).c_str(), nullptr);
      std::ostringstream text;
      text.precision(17);
      // Zeros and ones belong to the structure, not to a parameter. Any other number would be
      // wrong.
      text << std::scientific << (value == 0 ? factor - 1 : value * factor);
      replace(mutation, match, 1, text.str());
    });
  }

  void flip_signs() {
    each_match(R"( ([-+])\s)", [&](const std::smatch& match) {
      replace(Mutation::sign, match, 1, match.str(1) == "+" ? "-" : "+");
    });
    each_match(R"( = (-)[a-zA-Z(])",
               [&](const std::smatch& match) { replace(Mutation::sign, match, 1, ""); });
    each_match(R"( = ()[a-zA-Z])",
               [&](const std::smatch& match) { replace(Mutation::sign, match, 1, "-"); });
  }

  void change_indices() {
    const std::regex declared(R"((\w+)\)?\[([0-9]+)\])");
    const std::string head = readable_.substr(0, body_.begin);
    std::map<std::string, int> sizes;
    for (std::sregex_iterator at(head.begin(), head.end(), declared), none; at != none; ++at) {
      sizes[at->str(1)] = std::atoi(at->str(2).c_str());
    }
    each_match(R"((\w+)\[([0-9]+)\])", [&](const std::smatch& match) {
      const int index = std::atoi(match.str(2).c_str());
      const auto size = sizes.find(match.str(1));
      if (size == sizes.end() || size->second < 2) return;  // sines, cosines, angles: see below
      const int other = (index + 1 + rng_.below(size->second - 1)) % size->second;
      replace(Mutation::index, match, 2, std::to_string(other));
    });
    each_match(R"(= (?:sines|cosines)\[([0-9]+)\])", [&](const std::smatch& match) {
      const int index = std::atoi(match.str(1).c_str());
      replace(Mutation::index, match, 1, std::to_string(index == 0 ? 1 : index - 1));
    });
  }

  void change_names() {
    std::vector<std::string> known;
    each_match(R"(const Real (\w+) = ([^;]*);)", [&](const std::smatch& match) {
      const std::regex used(R"([a-zA-Z_]\w*)");
      const std::string value = match.str(2);
      std::smatch first;
      if (known.size() > 1 && std::regex_search(value, first, used) &&
          std::find(known.begin(), known.end(), first.str()) != known.end()) {
        const std::string& other =
            known[static_cast<std::size_t>(rng_.below(static_cast<int>(known.size())))];
        if (other != first.str()) {
          replace(Mutation::name, match, 2,
                  value.substr(0, static_cast<std::size_t>(first.position())) + other +
                      first.suffix().str());
        }
      }
      known.push_back(match.str(1));
    });
  }

  const std::string& source_;
  std::string readable_;
  Body body_;
  Rng& rng_;
  std::vector<Mutant> mutants_;
};

}  // namespace

const char* mutation_name(Mutation mutation) {
  constexpr std::array kNames = {"constant", "hair", "sign", "index", "name"};
  return kNames[static_cast<std::size_t>(mutation)];
}

std::vector<Mutant> mutants_of(const std::string& source, Mutation mutation, Rng& rng) {
  return Mutator(source, rng).make(mutation);
}

}  // namespace treeline::tests
