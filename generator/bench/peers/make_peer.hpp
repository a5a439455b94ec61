#pragma once

#include <algorithm>
#include <exception>
#include <functional>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "bench/peers/peer.hpp"

namespace treeline::peer {

/// A robot opened by an adapter: routines, and the objects to which their solvers point.
struct Opened {
  std::vector<Routine> routines;
  std::vector<std::shared_ptr<void>> solvers;

  /// Makes a solver and keeps it, so that `routines` may point to it.
  template <class Solver, class... Arguments>
  Solver& keep(Arguments&&... arguments) {
    auto made = std::make_shared<Solver>(std::forward<Arguments>(arguments)...);
    Solver& solver = *made;
    solvers.push_back(std::move(made));
    return solver;
  }
};

using Tell = std::function<void(const std::string& sentence)>;

/// Whether rotation is held. Libraries hold the three rows of a point or all six of a frame: says
/// so where the scene holds fewer.
inline bool holds_turns(const Constraint& constraint, const Tell& tell) {
  const auto& rows = constraint.frame.rows;
  const bool turns = rows[3] || rows[4] || rows[5];
  const auto held = std::count(std::begin(rows), std::end(rows), true);
  const int all = turns ? 6 : 3;
  if (held < all) {
    tell("holds " + std::to_string(all) + " rows of " + constraint.name +
         ", where the scene holds " + std::to_string(held));
  }
  return turns;
}

/// Makes a peer from the function that reads a robot; `records`: see `Peer`. A robot that it cannot
/// handle has no routines. Exceptions of the library become remarks.
template <Opened (*read)(const Robot&, const Tell&)>
constexpr Peer make_peer(const char* name, const char* release, bool records = false) {
  Peer made{kVersion, name, release, nullptr, nullptr, nullptr, records};
  made.open = [](const Robot* robot, Say say, void* listener) -> void* {
    const Tell tell = [say, listener](const std::string& text) { say(listener, text.c_str()); };
    try {
      auto opened = std::make_unique<Opened>(read(*robot, tell));
      return opened->routines.empty() ? nullptr : opened.release();
    } catch (const std::exception& error) {
      tell(error.what());
      return nullptr;
    }
  };
  made.list = [](void* opened, const Routine** routines) {
    const auto& all = static_cast<const Opened*>(opened)->routines;
    *routines = all.data();
    return static_cast<int>(all.size());
  };
  made.close = [](void* opened) { delete static_cast<Opened*>(opened); };
  return made;
}

}  // namespace treeline::peer
