#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "description/flat/flat_model.hpp"
#include "text/suggest_name.hpp"

namespace treeline {
namespace {

constexpr std::size_t kWorld = 0;  ///< in `reached`; links follow

std::size_t node_of(int link) {
  return static_cast<std::size_t>(link + 1);
}

/// Exchanges the ends of a joint: the coordinate stays, the axes change their direction.
FlatJoint turn_round(FlatJoint joint) {
  std::swap(joint.parent, joint.child);
  std::swap(joint.in_parent, joint.in_child);
  std::reverse(joint.axes.begin(), joint.axes.end());
  for (FlatAxis& axis : joint.axes) axis.direction = -axis.direction;
  return joint;
}

class Span {
 public:
  explicit Span(const FlatModel& model)
      : model_(model), taken_(model.joints.size()), reached_(model.links.size() + 1) {}

  FlatTree run() {
    const auto holds_to_world = [](const FlatJoint& j) { return j.parent < 0 || j.child < 0; };
    tree_.has_world = std::any_of(model_.joints.begin(), model_.joints.end(), holds_to_world);
    reached_[tree_.has_world ? kWorld : node_of(0)] = true;
    while (take_next(false) || take_next(true)) {
    }
    for (std::size_t j = 0; j < taken_.size(); ++j) {
      if (!taken_[j]) tree_.loops.push_back(model_.joints[j]);
    }
    return std::move(tree_);
  }

  /// Names of the links that no joint of the tree leads to.
  [[nodiscard]] std::vector<std::string> unreached() const {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < model_.links.size(); ++i) {
      if (!reached_[i + 1]) names.push_back(model_.links[i].name);
    }
    return names;
  }

 private:
  bool take_next(bool against) {
    for (std::size_t j = 0; j < taken_.size(); ++j) {
      if (taken_[j]) continue;
      const FlatJoint joint = against ? turn_round(model_.joints[j]) : model_.joints[j];
      if (!reached_[node_of(joint.parent)] || reached_[node_of(joint.child)]) continue;
      taken_[j] = true;
      reached_[node_of(joint.child)] = true;
      tree_.joints.push_back(joint);
      return true;
    }
    return false;
  }

  const FlatModel& model_;
  std::vector<bool> taken_, reached_;
  FlatTree tree_;
};

}  // namespace

std::optional<FlatTree> span_tree(const FlatModel& model, const std::string& file,
                                  Diagnostics& diagnostics) {
  Span span(model);
  FlatTree tree = span.run();
  if (const auto loose = span.unreached(); !loose.empty()) {
    diagnostics.add({Severity::error, file, 0, fmt::format("sdf/model[{}]", model.name),
                     fmt::format("no joint connects {} to the rest", list_names(loose)),
                     tree.has_world ? "a joint holds the rest to the world; add one for these, or "
                                      "write a model for each robot"
                                    : "add joints, or write a model for each robot"});
    return std::nullopt;
  }
  return tree;
}

}  // namespace treeline
