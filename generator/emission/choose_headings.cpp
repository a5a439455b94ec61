#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <map>

#include "emission/body_steps.hpp"

namespace treeline {
namespace {

/// Statements that may stand below one title more than they need, rather than that there is one
/// heading more.
constexpr std::size_t kCostOfHeading = 8;
/// Statements that one heading may have, as far as the search for the best division looks.
constexpr std::size_t kMostUnderHeading = 250;

/// Titles as numbers, in the order of their first appearance.
struct NumberedTitles {
  explicit NumberedTitles(const std::vector<std::set<SectionTitle>>& titles) {
    std::map<SectionTitle, std::size_t> known;
    for (const std::set<SectionTitle>& own : titles) {
      std::vector<std::size_t>& numbers = of_statement.emplace_back();
      for (const SectionTitle& title : own) {
        const auto [place, is_new] = known.try_emplace(title, list.size());
        if (is_new) list.push_back(title);
        numbers.push_back(place->second);
      }
    }
  }
  std::vector<SectionTitle> list;
  std::vector<std::vector<std::size_t>> of_statement;
};

/// Statements at the beginning that have no title.
std::size_t count_untitled(const NumberedTitles& titles) {
  const auto& own = titles.of_statement;
  const auto titled = std::find_if(own.begin(), own.end(), [](auto& t) { return !t.empty(); });
  return static_cast<std::size_t>(titled - own.begin());
}

/// Divides statements, up to their count, such that the fewest stand below the titles of
/// others.
std::vector<std::size_t> divide(const NumberedTitles& titles) {
  constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
  const std::size_t count = titles.of_statement.size();
  std::vector<std::size_t> cost(count + 1, kNone), from(count + 1, 0);
  const std::size_t untitled = count_untitled(titles);
  cost[untitled] = 0;
  for (std::size_t end = untitled + kFewestUnderHeading; end <= count; ++end) {
    std::set<std::size_t> below;
    const std::size_t furthest = end - std::min(end - untitled, kMostUnderHeading);
    for (std::size_t first = end; first-- > furthest;) {
      const auto& own = titles.of_statement[first];
      below.insert(own.begin(), own.end());
      const std::size_t strangers = below.empty() ? 0 : below.size() - 1;
      const std::size_t added = kCostOfHeading + strangers * (end - first);
      if (added >= cost[end]) break;
      const bool is_allowed = cost[first] != kNone && end - first >= kFewestUnderHeading;
      if (is_allowed && cost[first] + added < cost[end]) {
        cost[end] = cost[first] + added;
        from[end] = first;
      }
    }
  }
  if (cost[count] == kNone) return {};
  std::vector<std::size_t> divisions = {count};
  while (divisions.back() > untitled) divisions.push_back(from[divisions.back()]);
  std::reverse(divisions.begin(), divisions.end());
  return divisions;
}

/// `links 2, 4 to 6`, or up to two with their names.
std::string list_links(const std::map<int, std::string>& links) {
  if (links.size() == 1) {
    return fmt::format("link {} ({})", links.begin()->first, links.begin()->second);
  }
  if (links.size() == 2) {
    const auto &first = *links.begin(), &last = *links.rbegin();
    return fmt::format("links {} ({}) and {} ({})", first.first, first.second, last.first,
                       last.second);
  }
  std::vector<std::string> runs;
  for (auto link = links.begin(); link != links.end();) {
    const int first = link->first;
    int last = first;
    while (++link != links.end() && link->first == last + 1) last = link->first;
    runs.push_back(last == first
                       ? std::to_string(first)
                       : fmt::format("{} {} {}", first, last > first + 1 ? "to" : "and", last));
  }
  return fmt::format("links {}", fmt::join(runs, ", "));
}

/// One text for several titles: steps with the links where they are made.
std::string print_titles(const std::vector<SectionTitle>& titles) {
  std::vector<std::string> steps;
  std::map<std::string, std::map<int, std::string>> links;
  for (const SectionTitle& title : titles) {
    if (std::find(steps.begin(), steps.end(), title.step) == steps.end())
      steps.push_back(title.step);
    if (title.link > 0) links[title.step][title.link] = title.link_name;
  }
  std::string text;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const auto& own = links[steps[i]];
    const bool continues = i > 0 && !own.empty() && own == links[steps[i - 1]];
    if (continues) {
      text += " and " + steps[i];
      continue;
    }
    text += fmt::format("{}{}{}{}", text.empty() ? "" : "; ", own.empty() ? "" : list_links(own),
                        own.empty() ? "" : ", ", steps[i]);
  }
  return text;
}

}  // namespace

std::vector<Heading> choose_headings(const std::vector<std::set<SectionTitle>>& titles) {
  const NumberedTitles numbered(titles);
  const std::vector<std::size_t> divisions = divide(numbered);
  std::vector<Heading> headings;
  for (std::size_t d = 0; d + 1 < divisions.size(); ++d) {
    std::vector<std::size_t> below;
    for (std::size_t i = divisions[d]; i < divisions[d + 1]; ++i) {
      for (const std::size_t title : numbered.of_statement[i]) {
        if (std::find(below.begin(), below.end(), title) == below.end()) below.push_back(title);
      }
    }
    std::vector<SectionTitle> named;
    for (const std::size_t title : below) named.push_back(numbered.list[title]);
    const std::string text = print_titles(named);
    if (headings.empty() || headings.back().text != text) headings.push_back({divisions[d], text});
  }
  return headings;
}

}  // namespace treeline
