#include "choice/choose_axes.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "mechanism/find_limbs.hpp"
#include "passes/count_operations.hpp"
#include "passes/rebuild.hpp"
#include "program/find_sections.hpp"
#include "recursion/routes/trace_function.hpp"

namespace treeline {
namespace {

using Links = std::vector<int>;

MovingLink& link_at(Mechanism& mechanism, int index) {
  return mechanism.links[static_cast<std::size_t>(index)];
}

/// Links that decide together, each in one of them: those of alike limbs, and the others alone.
std::vector<Links> corresponding_links(const Mechanism& mechanism) {
  std::vector<Links> together;
  std::vector<bool> listed(mechanism.links.size(), false);
  for (const LimbFamily& family : find_limbs(mechanism, std::numeric_limits<int>::max())) {
    for (std::size_t j = 0; j < family.limbs.front().size(); ++j) {
      Links& links = together.emplace_back();
      for (const std::vector<int>& limb : family.limbs) {
        links.push_back(limb[j]);
        listed[static_cast<std::size_t>(limb[j])] = true;
      }
    }
  }
  for (std::size_t i = 0; i < listed.size(); ++i) {
    if (!listed[i]) together.push_back({static_cast<int>(i)});
  }
  return together;
}

int sum_of(const std::vector<int>& counts) {
  return std::accumulate(counts.begin(), counts.end(), 0);
}

/// Counts operations of a function's routes as traced, but for those far from the cheapest.
class Counter {
 public:
  Counter(const Mechanism& mechanism, Function function) : links_(mechanism.links.size()) {
    constexpr double kFar = 1.5;
    const std::vector<Program> programs = trace_function(mechanism, function);
    std::vector<double> counts;
    for (const Program& program : programs) counts.push_back(count_operations(program).flops());
    const double least = *std::min_element(counts.begin(), counts.end());
    for (std::size_t i = 0; i < programs.size(); ++i) {
      if (counts[i] <= kFar * least) {
        routes_.push_back(
            {prepare_route(mechanism, function, programs[i].route), counts[i], counts[i]});
      }
    }
    cheapest_ = find_cheapest();
  }

  /// Operations of the cheapest route for the mechanism that was last accepted, or first built.
  [[nodiscard]] int flops() const { return static_cast<int>(routes_[cheapest_].least); }

  /// Operations of the cheapest route for the mechanism as it is now, in which `changed` links have
  /// changed since it was accepted. Tracing takes most of the time. A route is traced only if it
  /// can be the cheapest: one link changes fewer operations than twice the average of a link.
  [[nodiscard]] int count_changed(std::size_t changed) {
    const double share = 2 * static_cast<double>(changed) / static_cast<double>(links_);
    for (Route& route : routes_) route.next = route.least * (1 - share);
    const auto count = [](Route& route) {
      return route.next = count_operations(route.trace(Names::forgotten)).flops();
    };
    double least = count(routes_[cheapest_]);
    for (std::size_t i = 0; i < routes_.size(); ++i) {
      if (i != cheapest_ && routes_[i].next < least) least = std::min(least, count(routes_[i]));
    }
    return static_cast<int>(least);
  }

  /// Takes the mechanism of the last count as the one from which the next changes are made.
  void accept() {
    for (Route& route : routes_) route.least = route.next;
    cheapest_ = find_cheapest();
  }

  /// Operations of the cheapest route, by link, see `count_by_link`.
  [[nodiscard]] std::vector<int> flops_by_link() const {
    std::vector<int> best;
    for (const Route& route : routes_) {
      std::vector<int> counts = count_by_link(route.trace(Names::kept), links_);
      if (best.empty() || sum_of(counts) < sum_of(best)) best = std::move(counts);
    }
    return best;
  }

 private:
  struct Route {
    std::function<Program(Names)> trace;
    double least = 0;  ///< not more than its operations as the mechanism was last accepted
    double next = 0;   ///< the same as the mechanism was last counted
  };

  [[nodiscard]] std::size_t find_cheapest() const {
    const auto cheapest =
        std::min_element(routes_.begin(), routes_.end(),
                         [](const Route& a, const Route& b) { return a.least < b.least; });
    return static_cast<std::size_t>(cheapest - routes_.begin());
  }

  std::size_t links_;
  std::vector<Route> routes_;
  std::size_t cheapest_ = 0;
};

/// One choice of links that decide together.
struct Flip {
  const Links* links;
  bool MovingLink::*choice;
};

void apply(Mechanism& mechanism, const Flip& flip) {
  for (const int i : *flip.links) {
    bool& chosen = link_at(mechanism, i).*flip.choice;
    chosen = !chosen;
  }
}

/// One flip after the other: each is kept that pays.
void flip_each(Mechanism& mechanism, Counter& counter, const std::vector<Flip>& flips) {
  constexpr std::size_t kMostSweeps = 2;  // a third found nothing on any robot at hand
  int flops = counter.flops();
  std::size_t in_vain = 0;  // flips since the last that paid, each another
  for (std::size_t n = 0; n < kMostSweeps * flips.size() && in_vain < flips.size(); ++n) {
    const Flip& flip = flips[n % flips.size()];
    apply(mechanism, flip);
    const int changed = counter.count_changed(flip.links->size());
    if (changed < flops) {
      counter.accept();
      flops = changed;
      in_vain = 1;  // flipping it back is known not to pay
    } else {
      apply(mechanism, flip);
      ++in_vain;
    }
  }
}

int depth_of(const Mechanism& mechanism, int link) {
  int depth = 0;
  for (; link >= 0; link = mechanism.links[static_cast<std::size_t>(link)].parent) ++depth;
  return depth;
}

/// Finds for each link the nearest flipped link, counted in joints along the tree: among itself and
/// the links before it, or behind it. Returns indices into `flips`, -1 where there is none.
std::vector<int> nearest_flips(const Mechanism& mechanism, const std::vector<Flip>& flips) {
  struct Near {
    int flip = -1, ways = std::numeric_limits<int>::max() / 2;
  };
  const std::size_t count = mechanism.links.size();
  std::vector<Near> before(count), behind(count);
  for (std::size_t f = 0; f < flips.size(); ++f) {
    for (const int link : *flips[f].links) {
      before[static_cast<std::size_t>(link)] =
          behind[static_cast<std::size_t>(link)] = {static_cast<int>(f), 0};
    }
  }
  const auto carry = [](const Near& from, Near& to) {
    if (from.ways + 1 < to.ways) to = {from.flip, from.ways + 1};
  };
  std::vector<int> nearest(count, -1);
  for (std::size_t i = count; i-- > 0;) {
    const int parent = mechanism.links[i].parent;
    if (parent >= 0) carry(behind[i], behind[static_cast<std::size_t>(parent)]);
  }
  for (std::size_t i = 0; i < count; ++i) {
    const int parent = mechanism.links[i].parent;
    if (parent >= 0) carry(before[static_cast<std::size_t>(parent)], before[i]);
    nearest[i] = before[i].ways <= behind[i].ways ? before[i].flip : behind[i].flip;
  }
  return nearest;
}

/// Assigns to each flip the change of operations, with all flips made, of the links nearest to it.
std::vector<int> share_changes(const Mechanism& mechanism, const std::vector<Flip>& flips,
                               const std::vector<int>& flops, const std::vector<int>& changed) {
  std::vector<int> shares(flips.size(), 0);
  const std::vector<int> nearest = nearest_flips(mechanism, flips);
  for (std::size_t link = 0; link < nearest.size(); ++link) {
    if (nearest[link] < 0) continue;
    shares[static_cast<std::size_t>(nearest[link])] += changed[link] - flops[link];
  }
  return shares;
}

/// Makes those of the flips that pay, told by what all of them together change at each link; none
/// where that misleads. `flops`, by link, is kept up to date.
void keep_what_pays(Mechanism& mechanism, const Counter& counter, const std::vector<Flip>& flips,
                    std::vector<int>& flops) {
  for (const Flip& flip : flips) apply(mechanism, flip);
  std::vector<int> changed = counter.flops_by_link();
  const std::vector<int> shares = share_changes(mechanism, flips, flops, changed);
  std::vector<Flip> kept;
  for (std::size_t f = 0; f < flips.size(); ++f) {
    if (shares[f] < 0) {
      kept.push_back(flips[f]);
    } else {
      apply(mechanism, flips[f]);
    }
  }
  if (kept.empty()) return;
  if (kept.size() < flips.size()) changed = counter.flops_by_link();
  if (sum_of(changed) < sum_of(flops)) {
    flops = std::move(changed);
  } else {
    for (const Flip& flip : kept) apply(mechanism, flip);
  }
}

/// Flips of links that are some way apart at once: they hardly touch each other's operations. For
/// mechanisms of so many links that tracing them anew for each flip would take most of the time,
/// which grows with the square of the output.
void flip_apart(Mechanism& mechanism, const Counter& counter, const std::vector<Flip>& flips) {
  constexpr int kApart = 4, kSweeps = 2;
  std::vector<int> flops = counter.flops_by_link();
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    const int before = sum_of(flops);
    for (int depth = 0; depth < kApart; ++depth) {
      for (bool MovingLink::*choice : {&MovingLink::defers_rotation, &MovingLink::carries_column}) {
        std::vector<Flip> apart;
        for (const Flip& flip : flips) {
          const bool fits = depth_of(mechanism, flip.links->front()) % kApart == depth;
          if (fits && flip.choice == choice) apart.push_back(flip);
        }
        if (!apart.empty()) keep_what_pays(mechanism, counter, apart, flops);
      }
    }
    if (sum_of(flops) == before) break;
  }
}

}  // namespace

int count_cheapest(const Mechanism& mechanism, Function function) {
  int least = std::numeric_limits<int>::max();
  for (const Program& program : trace_function(mechanism, function)) {
    least = std::min(least, count_operations(program).flops());
  }
  return least;
}

void choose_axes(Mechanism& mechanism, Function frame_cost) {
  constexpr std::size_t kFew = 64;  // as humanoids have
  std::vector<bool MovingLink::*> choices{&MovingLink::defers_rotation};
  if (info_of(frame_cost).columns == Columns::carried)
    choices.push_back(&MovingLink::carries_column);
  const std::vector<Links> together = corresponding_links(mechanism);
  Counter counter(mechanism, frame_cost);
  std::vector<Flip> flips;
  for (const Links& links : together) {
    if (!link_at(mechanism, links.front()).has_one_coordinate()) continue;
    for (bool MovingLink::*choice : choices) flips.push_back({&links, choice});
  }
  if (flips.size() <= kFew) {
    flip_each(mechanism, counter, flips);
  } else {
    flip_apart(mechanism, counter, flips);
  }
}

namespace {

bool is_operation(Op op) {
  return op == Op::add || op == Op::sub || op == Op::mul || op == Op::div;
}

}  // namespace

std::vector<int> count_by_link(const Program& program, std::size_t links) {
  const Graph& graph = program.graph;
  const Marks live = find_live(program);
  std::vector<int> counts(links + 1, 0);
  const auto sections = find_sections(graph);
  for (std::uint32_t i = 0; i < graph.nodes().size(); ++i) {
    const int number = sections[i] == nullptr ? 0 : sections[i]->title().link;
    const std::size_t link = number > 0 ? static_cast<std::size_t>(number) - 1 : links;
    counts[link] += live[i] && is_operation(graph.nodes()[i].op) ? 1 : 0;
  }
  return counts;
}

}  // namespace treeline
