#include <algorithm>
#include <utility>
#include <vector>

#include "recursion/methods/factor_mass_matrix.hpp"
#include "recursion/methods/kinetic_energy.hpp"
#include "recursion/methods/mass_matrix.hpp"
#include "recursion/methods/potential_energy.hpp"
#include "recursion/routes/result_parts.hpp"
#include "recursion/routes/trace.hpp"
#include "recursion/routes/trace_function.hpp"
#include "recursion/tree/joint_axes.hpp"

namespace treeline {
namespace {

using Traced3 = Vector3<Expression>;

void append_three(std::vector<Expression>& list, const Traced3& v) {
  list.insert(list.end(), {v.x, v.y, v.z});
}

/// Traces the robot as it is in the files, with the arguments of `function`.
template <class Body>
Program trace_of_robot(const Mechanism& mechanism, Function function, int lanes, const Body& body) {
  Program program;
  program.graph = Graph::for_trace(lanes);
  const Graph::Scope scope(program.graph);
  Trace trace = begin_trace(mechanism);
  trace.in = TracedInputs(mechanism, function, program);
  find_transforms(trace);
  program.results = body(trace);
  return program;
}

/// Takes the place of a floating base out of its transform, so that all places are relative to it.
Traced3 take_origin(Trace& trace) {
  const auto is_root = [](const TreeLink<Expression>& link) { return link.parent < 0; };
  const auto& links = trace.tree.links;
  if (std::count_if(links.begin(), links.end(), is_root) != 1 || !links.front().is_floating()) {
    return {};
  }
  return std::exchange(trace.X.front().p, Traced3{});
}

/// The motions [v; w] at the origin that the velocities make, world axes.
std::vector<Expression> world_motions(const Trace& trace,
                                      const std::vector<WorldPose<Expression>>& poses) {
  std::vector<Expression> motions(6 * static_cast<std::size_t>(trace.tree.nv));
  for (std::size_t i = 0; i < trace.tree.links.size(); ++i) {
    const TreeLink<Expression>& link = trace.tree.links[i];
    for (int k = 0; k < link.velocities(); ++k) {
      const UnitMotion<Expression> own = unit_motion(link, k);
      const Traced3 w = poses[i].R * own.w * link.multiplier;
      const Traced3 v = poses[i].R * own.v * link.multiplier + cross(poses[i].p, w);
      std::vector<Expression> entries;
      append_three(entries, v);
      append_three(entries, w);
      const auto at = 6 * static_cast<std::size_t>(link.v_index + k);
      std::copy(entries.begin(), entries.end(), motions.begin() + static_cast<std::ptrdiff_t>(at));
    }
  }
  return motions;
}

/// The entries of L that can be other than zero, row by row.
std::vector<Expression> packed_rows(const Mechanism& mechanism, const DenseMatrix<Expression>& L) {
  std::vector<Expression> entries;
  const auto before = velocities_before(mechanism);
  for (std::size_t row = 0; row < before.size(); ++row) {
    for (const int col : before[row]) entries.push_back(L(row, static_cast<std::size_t>(col)));
  }
  return entries;
}

}  // namespace

Program trace_heights(const Mechanism& mechanism, int lanes) {
  return trace_of_robot(mechanism, Function::forward_kinematics, lanes, [](const Trace& trace) {
    const auto poses = trace.poses();
    std::vector<Expression> heights;
    for (const TreePoint<Expression>& point : trace.tree.operational_points) {
      const WorldPose<Expression> pose = point_pose(poses, point);
      append_three(heights, pose.R.row_z);
      heights.push_back(pose.p.z);
    }
    return vector_output("heights", "the world's z axis in each point's axes, and its height, m",
                         std::move(heights));
  });
}

Program trace_for_impulses(const Mechanism& mechanism, int lanes) {
  return trace_of_robot(mechanism, Function::lambda_inverse, lanes, [&](Trace& trace) {
    std::vector<Expression> origin;
    append_three(origin, take_origin(trace));
    const auto poses = trace.poses();
    std::vector<Expression> positions;
    std::vector<Expression> rotations;
    for (const TreePoint<Expression>& point : trace.tree.operational_points) {
      const WorldPose<Expression> pose = point_pose(poses, point);
      append_three(positions, pose.p);
      for (const auto& row : {pose.R.row_x, pose.R.row_y, pose.R.row_z})
        append_three(rotations, row);
    }
    const auto factor = factor_ltdl(mass_matrix(trace.tree, trace.X));
    return std::vector<Result>{
        vector_result("origin", "the place to which others are relative, m", std::move(origin)),
        vector_result("position", "of each point, m", std::move(positions)),
        vector_result("rotation", "of each point, its axes to the world's, row-major",
                      std::move(rotations)),
        vector_result("motion", "[v; w] at the origin by each velocity, world axes",
                      world_motions(trace, poses)),
        vector_result("factor", "rows of L before the diagonal, M = L^T D L",
                      packed_rows(mechanism, factor.L)),
        vector_result("inverse", "one over D", factor.inverse_D)};
  });
}

std::vector<std::vector<int>> velocities_before(const Mechanism& mechanism) {
  std::vector<std::vector<int>> of_links;
  std::vector<std::vector<int>> before(static_cast<std::size_t>(mechanism.nv()));
  for (const MovingLink& link : mechanism.links) {
    std::vector<int> path;
    if (link.parent >= 0) path = of_links[static_cast<std::size_t>(link.parent)];
    for (int k = 0; k < link.velocities(); ++k) {
      before[static_cast<std::size_t>(link.v_index + k)] = path;
      path.push_back(link.v_index + k);
    }
    of_links.push_back(std::move(path));
  }
  return before;
}

Program trace_energy(const Mechanism& mechanism, int lanes) {
  return trace_of_robot(mechanism, Function::kinetic_energy, lanes, [](const Trace& trace) {
    const Expression energy = kinetic_energy<Expression>(trace.tree, trace.X, trace.qd()) +
                              potential_energy(trace.tree, trace.X);
    return vector_output("energy", "kinetic and potential energy, J", {energy});
  });
}

}  // namespace treeline
