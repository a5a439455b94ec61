#include "description/find_inertia_tags.hpp"

namespace treeline {
namespace {

/// Follows the tags of a URDF down to the inertias.
class InertiaSearch {
 public:
  void enter(const XmlTag& tag) {
    ++depth_;
    if (depth_ == 2 && tag.name == "link") {
      found_.emplace_back();
      inertials_ = 0;
      in_link_ = true;
    } else if (depth_ == 2) {
      in_link_ = false;
    } else if (depth_ == 3) {
      in_first_inertial_ = in_link_ && tag.name == "inertial" && ++inertials_ == 1;
    } else if (depth_ == 4 && in_first_inertial_ && tag.name == "inertia" && !found_.back()) {
      found_.back() = tag;
    }
  }

  void leave() { --depth_; }

  [[nodiscard]] std::vector<std::optional<XmlTag>> found() const { return found_; }

 private:
  int depth_ = 0, inertials_ = 0;
  bool in_link_ = false, in_first_inertial_ = false;
  std::vector<std::optional<XmlTag>> found_;
};

}  // namespace

std::vector<std::optional<XmlTag>> find_inertia_tags(std::string_view text) {
  InertiaSearch search;
  for (std::size_t at = 0; const auto tag = next_tag(text, at);) {
    if (tag->kind == XmlTag::Kind::start || tag->kind == XmlTag::Kind::empty) search.enter(*tag);
    if (tag->kind == XmlTag::Kind::end || tag->kind == XmlTag::Kind::empty) search.leave();
  }
  return search.found();
}

}  // namespace treeline
