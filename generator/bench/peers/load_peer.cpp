#include "bench/peers/load_peer.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <utility>

namespace treeline {
namespace {

void report(const std::filesystem::path& path, const std::string& fault, Diagnostics& diagnostics) {
  diagnostics.add({Severity::error, path, 0, "", fault,
                   "Build it anew with this program's sources, with -DTREELINE_PEERS=ON."});
}

/// Redirects standard output to standard error during its lifetime, because standard output is for
/// data.
class OutputToErrors {
 public:
  OutputToErrors() : kept_(std::cout.rdbuf(std::cerr.rdbuf())) {}
  ~OutputToErrors() { std::cout.rdbuf(kept_); }
  OutputToErrors(const OutputToErrors&) = delete;
  OutputToErrors& operator=(const OutputToErrors&) = delete;

 private:
  std::streambuf* kept_;
};

peer::Point point_of(const PeerPoint& from) {
  peer::Point point{from.link.c_str(), {}, {}, {}, from.world_axes};
  std::copy(from.R.begin(), from.R.end(), point.R);
  std::copy(from.p.begin(), from.p.end(), point.p);
  std::copy(from.rows.begin(), from.rows.end(), point.rows);
  return point;
}

peer::Constraint constraint_of(const PeerConstraint& from) {
  peer::Constraint constraint{from.name.c_str(), point_of(from.frame), {}};
  if (from.other) constraint.other = point_of(*from.other);
  return constraint;
}

std::vector<const char*> pointers_to(const std::vector<std::string>& words) {
  std::vector<const char*> pointers;
  for (const std::string& word : words) pointers.push_back(word.c_str());
  return pointers;
}

}  // namespace

std::optional<LoadedPeer> load_peer(const std::filesystem::path& path, Diagnostics& diagnostics) {
  // A name without a folder would be searched among the system's libraries.
  const std::string file = std::filesystem::absolute(path).string();
  const OutputToErrors redirected;
  void* const handle = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  if (handle == nullptr) {
    report(path, std::string("cannot be loaded: ") + dlerror(), diagnostics);
    return std::nullopt;
  }
  const auto entry = reinterpret_cast<decltype(&treeline_peer)>(dlsym(handle, "treeline_peer"));
  const peer::Peer* const functions = entry == nullptr ? nullptr : entry();
  if (functions == nullptr) {
    report(path, "is no module of a peer: it has no symbol treeline_peer", diagnostics);
    return std::nullopt;
  }
  if (functions->version != peer::kVersion) {
    report(path,
           fmt::format("is of version {} of the interface, this program of version {}",
                       functions->version, peer::kVersion),
           diagnostics);
    return std::nullopt;
  }
  return LoadedPeer{functions->name, functions->release, file, functions};
}

OpenedPeer open_peer(const LoadedPeer& peer, const std::filesystem::path& urdf,
                     const PeerDescription& description,
                     const std::vector<std::string>& functions) {
  const auto links = pointers_to(description.links);
  const auto names = pointers_to(functions);
  std::vector<peer::Point> points;
  for (const PeerPoint& point : description.points) points.push_back(point_of(point));
  std::vector<peer::Constraint> constraints;
  for (const PeerConstraint& each : description.constraints) {
    constraints.push_back(constraint_of(each));
  }
  const std::string file = urdf.string();
  const auto& g = description.gravity;
  const peer::Robot robot{file.c_str(),       description.floating,
                          {g[0], g[1], g[2]}, static_cast<int>(links.size()),
                          links.data(),       static_cast<int>(points.size()),
                          points.data(),      static_cast<int>(constraints.size()),
                          constraints.data(), static_cast<int>(names.size()),
                          names.data()};
  OpenedPeer made;
  const auto listen = [](void* listener, const char* sentence) {
    static_cast<OpenedPeer*>(listener)->sentences.emplace_back(sentence);
  };
  const OutputToErrors redirected;
  void* const opened = peer.functions->open(&robot, listen, &made);
  if (opened == nullptr) return made;
  const std::shared_ptr<void> keeper(opened, peer.functions->close);
  const peer::Routine* routines = nullptr;
  const int count = peer.functions->list(opened, &routines);
  for (int i = 0; i < count; ++i) {
    const peer::Routine& each = routines[i];
    made.routines.push_back(
        {each.function, each.route, {keeper, each.solver}, each.call, each.finish});
  }
  return made;
}

}  // namespace treeline
