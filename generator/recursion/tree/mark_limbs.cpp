#include "recursion/tree/mark_limbs.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "functions/quantity.hpp"
#include "recursion/tree/tree.hpp"

namespace treeline {
namespace {

using Constants = std::vector<Expression*>;

void append(Vector3<Expression>& v, Constants& constants) {
  for (Expression* constant : {&v.x, &v.y, &v.z}) constants.push_back(constant);
}
void append(Symmetric3<Expression>& A, Constants& constants) {
  for (Expression* constant : {&A.xx, &A.xy, &A.xz, &A.yy, &A.yz, &A.zz})
    constants.push_back(constant);
}
void append(PlanarRotation<Expression>& r, Constants& constants) {
  for (Expression* constant : {&r.c, &r.s}) constants.push_back(constant);
}

Constants constants_of(TreeLink<Expression>& link) {
  Constants constants{&link.multiplier, &link.offset, &link.inertia.mass};
  for (PlanarRotation<Expression>* turn : {&link.R.a, &link.R.alpha, &link.R.b}) {
    append(*turn, constants);
  }
  append(link.p, constants);
  append(link.inertia.h, constants);
  append(link.inertia.Sigma, constants);
  append(link.inertia.J, constants);
  TreeDrive<Expression>& drive = link.drive;
  for (Expression* constant : {&drive.inertia, &drive.damping, &drive.friction, &drive.sharpness,
                               &drive.stiffness, &drive.rest}) {
    constants.push_back(constant);
  }
  return constants;
}

Constants constants_of(TreePoint<Expression>& point) {
  Constants constants;
  for (Vector3<Expression>* row : {&point.R.row_x, &point.R.row_y, &point.R.row_z}) {
    append(*row, constants);
  }
  append(point.p, constants);
  return constants;
}

/// Numbers the places of constants of all families.
class Marker {
 public:
  /// `things`: one for each limb.
  template <class Thing>
  void mark(const std::vector<Thing*>& things) {
    std::vector<Constants> of_limbs;
    for (Thing* thing : things) {
      of_limbs.push_back(constants_of(*thing));
    }
    for (std::size_t i = 0; i < of_limbs.front().size(); ++i) {
      ++slot_;
      mark_one(of_limbs, i);
    }
  }

 private:
  void mark_one(const std::vector<Constants>& of_limbs, std::size_t i) const {
    const bool same = std::all_of(of_limbs.begin(), of_limbs.end(), [&](const Constants& limb) {
      return limb[i]->constant() == of_limbs.front()[i]->constant();
    });
    if (same) {
      return;
    }
    const auto limbs = static_cast<std::uint32_t>(of_limbs.size());
    for (std::uint32_t limb = 0; limb < limbs; ++limb) {
      Expression& constant = *of_limbs[limb][i];
      const DoubleDouble exact = constant.exact_constant();
      const Node node = make_limb_constant({slot_, limb, limbs}, exact.value);
      constant = {Graph::current().intern(node, exact.rest), false};
    }
  }

  std::uint32_t slot_ = 0;
};

/// Entries of a vector of task rows or of forces that belong to each point.
using Rows = std::vector<std::pair<int, int>>;  // first, count

Rows rows_of(const std::vector<MechanismPoint>& points, bool all) {
  Rows rows;
  int first = 0;
  for (const MechanismPoint& point : points) {
    const int count = all ? 6 : point.row_count();
    rows.emplace_back(first, count);
    first += count;
  }
  return rows;
}

void pair_inputs(const char* vector, const std::vector<int>& indices) {
  Graph::LimbInputs inputs;
  for (const int index : indices) {
    inputs.push_back(std::string(vector) + "[" + std::to_string(index) + "]");
  }
  Graph::current().add_limb_inputs(std::move(inputs));
}

/// The points on corresponding links, where all limbs have alike ones, go by their order.
std::vector<std::vector<std::size_t>> corresponding_points(
    const std::vector<MechanismPoint>& points, const std::vector<int>& links) {
  std::vector<std::vector<std::size_t>> of_limbs;
  for (const int link : links) {
    std::vector<std::size_t>& own = of_limbs.emplace_back();
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (points[i].link == link) {
        own.push_back(i);
      }
    }
  }
  std::vector<std::vector<std::size_t>> together(of_limbs.front().size());
  for (const std::vector<std::size_t>& own : of_limbs) {
    if (own.size() != together.size()) {
      return {};
    }
    for (std::size_t i = 0; i < own.size(); ++i) {
      const MechanismPoint& first = points[of_limbs.front()[i]];
      if (points[own[i]].rows != first.rows || points[own[i]].axes != first.axes) {
        return {};
      }
      together[i].push_back(own[i]);
    }
  }
  return together;
}

void pair_coordinates(const Mechanism& mechanism, const std::vector<int>& links) {
  const auto link_at = [&](int i) -> const MovingLink& {
    return mechanism.links[static_cast<std::size_t>(i)];
  };
  const JointStep& joint = link_at(links.front());
  const auto pair_all = [&](const char* vector, int MovingLink::*first, int count) {
    for (int k = 0; k < count; ++k) {
      std::vector<int> indices;
      for (const int link : links) {
        indices.push_back(link_at(link).*first + k);
      }
      pair_inputs(vector, indices);
    }
  };
  for (const char* vector : {"q", "sin_q", "cos_q"}) {
    pair_all(vector, &MovingLink::q_index, joint.coordinates());
  }
  for (const char* vector : {"qd", "qdd", "qdd_0", "tau"}) {
    pair_all(vector, &MovingLink::v_index, joint.velocities());
  }
}

void pair_rows(const char* vector, const Rows& rows, const std::vector<std::size_t>& points) {
  for (int k = 0; k < rows[points.front()].second; ++k) {
    std::vector<int> indices;
    for (const std::size_t point : points) {
      indices.push_back(rows[point].first + k);
    }
    pair_inputs(vector, indices);
  }
}

/// Marks corresponding points on these links: constants, and entries of quantities of `space`.
void mark_points(const std::vector<MechanismPoint>& points, const std::vector<int>& links,
                 IndexSpace space, const Rows& rows, std::vector<TreePoint<Expression>>& marked,
                 Marker& marker) {
  for (const std::vector<std::size_t>& together : corresponding_points(points, links)) {
    std::vector<TreePoint<Expression>*> things;
    for (const std::size_t point : together) {
      things.push_back(&marked[point]);
    }
    marker.mark(things);
    for (const QuantityInfo& row : kQuantities) {
      if (row.space == space) pair_rows(row.symbol, rows, together);
    }
  }
}

}  // namespace

void mark_limbs(const Mechanism& mechanism, Tree<Expression>& tree) {
  Marker marker;
  for (const LimbFamily& family : mechanism.limbs) {
    for (std::size_t j = 0; j < family.limbs.front().size(); ++j) {
      std::vector<int> links;
      std::vector<TreeLink<Expression>*> things;
      for (const std::vector<int>& limb : family.limbs) {
        links.push_back(limb[j]);
        things.push_back(&tree.links[static_cast<std::size_t>(limb[j])]);
      }
      marker.mark(things);
      pair_coordinates(mechanism, links);
      mark_points(mechanism.operational_points, links, IndexSpace::task_rows,
                  rows_of(mechanism.operational_points, false), tree.operational_points, marker);
      mark_points(mechanism.external_forces, links, IndexSpace::external_forces,
                  rows_of(mechanism.external_forces, true), tree.external_forces, marker);
    }
  }
}

}  // namespace treeline
