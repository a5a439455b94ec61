#include "bounds/search_rounding.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "bounds/draw_inputs.hpp"

namespace treeline::bounds {
namespace {

using Point = InputSpace::Point;
using Points = std::array<Point, kStatesAtOnce>;

/// A state that was drawn, and its largest first-order bound. Only those entries of a result are
/// bounded that had the largest sampled errors.
struct Seen {
  Point point;
  FoundError found;
};

/// Evaluates a program and its rounding errors at points of its domain.
class Search {
 public:
  Search(const Program& program, const Domain& domain, double unit, std::uint64_t seed)
      : program_(program),
        space_(program.graph, domain),
        errors_(program.graph, unit),
        rng_(seed),
        inputs_(program.graph.inputs().size()) {}

  /// Draws `batches` times `kStatesAtOnce` states. Returns them for each result.
  std::vector<std::vector<Seen>> draw(int batches) {
    std::vector<std::vector<Seen>> seen(program_.results.size());
    for (int i = 0; i < batches; ++i) {
      Points points;
      for (Point& point : points) point = space_.draw(rng_);
      evaluate(points);
      errors_.sample(rng_.bits());
      for (std::size_t r = 0; r < seen.size(); ++r) {
        for (Seen& each : look(points, program_.results[r])) seen[r].push_back(std::move(each));
      }
    }
    return seen;
  }

  /// Hill climbing: changes the state repeatedly and keeps changes for which the entry's bound
  /// grows.
  FoundError hill_climb(Seen best, const Result& result, int generations) {
    const std::uint32_t node = result.values[best.found.entry].node();
    for (int i = 0; i < generations; ++i) {
      Points points;
      for (Point& point : points) point = space_.change(best.point, rng_);
      evaluate(points);
      const States& bound = errors_.bound(node);
      for (std::size_t s = 0; s < kStatesAtOnce; ++s) {
        if (!(bound[s] > best.found.error) || !std::isfinite(bound[s])) continue;
        best = {points[s], {bound[s], size_of(result, s), best.found.entry}};
      }
    }
    return best.found;
  }

 private:
  void evaluate(const Points& points) {
    for (std::size_t s = 0; s < kStatesAtOnce; ++s) space_.put(points[s], s, inputs_);
    errors_.evaluate(inputs_);
  }

  [[nodiscard]] double size_of(const Result& result, std::size_t s) const {
    double size = 0;
    for (const Expression& value : result.values) {
      size = std::max(size, std::abs(errors_.value(value.node())[s]));
    }
    return size;
  }

  [[nodiscard]] std::size_t worst_sampled(const Result& result, std::size_t s) const {
    std::size_t worst = 0;
    double largest = 0;
    for (std::size_t i = 0; i < result.values.size(); ++i) {
      const double error = std::abs(errors_.sampled(result.values[i].node())[s]);
      if (!(error > largest)) continue;
      largest = error;
      worst = i;
    }
    return worst;
  }

  std::array<Seen, kStatesAtOnce> look(const Points& points, const Result& result) {
    std::array<Seen, kStatesAtOnce> seen;
    std::set<std::size_t> entries;
    for (std::size_t s = 0; s < kStatesAtOnce; ++s) {
      entries.insert(worst_sampled(result, s));
      seen[s] = {points[s], {0, size_of(result, s), 0}};
    }
    for (const std::size_t entry : entries) {
      const States& bound = errors_.bound(result.values[entry].node());
      for (std::size_t s = 0; s < kStatesAtOnce; ++s) {
        FoundError& found = seen[s].found;
        if (bound[s] > found.error) found = {bound[s], found.size, entry};
      }
    }
    return seen;
  }

  const Program& program_;
  InputSpace space_;
  ErrorPropagation errors_;
  Rng rng_;
  std::vector<States> inputs_;
};

bool is_less(const Seen& a, const Seen& b) {
  return a.found.error < b.found.error;
}

/// Drops states with a division by zero or nearly zero.
void drop_infinite(std::vector<Seen>& seen) {
  std::erase_if(seen, [](const Seen& each) { return !std::isfinite(each.found.error); });
}

}  // namespace

SearchEffort default_effort(const Graph& graph) {
  const std::size_t nodes = std::max<std::size_t>(1, graph.nodes().size());
  SearchEffort effort;
  effort.batches = static_cast<int>(std::clamp<std::size_t>(200'000 / nodes, 16, 64));
  effort.generations = static_cast<int>(std::clamp<std::size_t>(1'000'000 / nodes, 30, 100));
  return effort;
}

std::vector<FoundError> search_worst(const Program& program, const Domain& domain, double unit,
                                     const SearchEffort& effort) {
  Search search(program, domain, unit, effort.seed);
  auto seen = search.draw(effort.batches);
  std::vector<FoundError> worst;
  for (std::size_t r = 0; r < seen.size(); ++r) {
    drop_infinite(seen[r]);
    std::stable_sort(seen[r].begin(), seen[r].end(),
                     [](const Seen& a, const Seen& b) { return is_less(b, a); });
    FoundError& most = worst.emplace_back();
    const std::size_t starts =
        std::min(seen[r].size(), static_cast<std::size_t>(std::max(effort.starts, 0)));
    for (std::size_t i = 0; i < starts; ++i) {
      const FoundError found =
          search.hill_climb(seen[r][i], program.results[r], effort.generations);
      most.size = std::max(most.size, found.size);
      if (found.error > most.error) most = {found.error, most.size, found.entry};
    }
  }
  return worst;
}

std::vector<TypicalErrors> find_typical(const Program& program, const Domain& domain, double unit,
                                        const SearchEffort& effort) {
  Search search(program, domain, unit, effort.seed);
  std::vector<TypicalErrors> typical;
  for (std::vector<Seen>& seen : search.draw(effort.batches)) {
    std::stable_sort(seen.begin(), seen.end(), is_less);
    TypicalErrors& errors = typical.emplace_back();
    const std::array<double, 3> shares{0.50, 0.90, 0.99};
    for (std::size_t i = 0; i < shares.size(); ++i) {
      const auto at =
          static_cast<std::size_t>(std::ceil(shares[i] * static_cast<double>(seen.size())) - 1);
      errors[i] = seen[at].found;
    }
  }
  return typical;
}

}  // namespace treeline::bounds
