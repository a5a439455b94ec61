#include "count_growth.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <functional>

#include "mechanism/build_mechanism.hpp"
#include "passes/count_operations.hpp"
#include "passes/passes.hpp"
#include "recursion/methods/control_torque.hpp"
#include "recursion/methods/link_inverse_inertias.hpp"

namespace treeline::growth {
namespace {

using Expressions = std::vector<Expression>;

Expressions declare(Program& program, const char* name, int size) {
  program.arguments.push_back({name, size, 1, ""});
  Expressions entries;
  for (int i = 0; i < size; ++i) {
    entries.push_back(program.graph.input(fmt::format("{}[{}]", name, i)));
  }
  return entries;
}

/// The tree and poses while operations are counted.
struct Counted {
  Program& program;
  Tree<Expression> tree;
  std::vector<JointTransform<Expression>> X;
  std::size_t rows;
};

int count(const Mechanism& robot, const std::function<Expressions(Counted&)>& body) {
  Program program;
  program.graph = Graph::for_trace(1);
  const Graph::Scope scope(program.graph);
  const Expressions q = declare(program, "q", robot.nq());
  Counted counted{program, tree_of<Expression>(robot), {}, 0};
  counted.X = joint_transforms<Expression>(counted.tree, q);
  counted.rows = static_cast<std::size_t>(robot.task_rows());
  const Expressions values = body(counted);
  program.results = {{{"result", static_cast<int>(values.size()), 1, ""}, values}};
  return count_operations(canonicalize(program)).flops();
}

LambdaRoute route_of(Way way) {
  switch (way) {
    case Way::branching:
      return LambdaRoute::branching;
    case Way::sparse_factors:
      return LambdaRoute::factors_world;
    default:
      return LambdaRoute::unit_forces;
  }
}

/// J M^-1 J^T, column by column.
DenseMatrix<Expression> dense_lambda_inverse(const Counted& on) {
  const auto J = jacobian_world(on.tree, world_poses(on.tree, on.X), {}, on.rows);
  auto M = mass_matrix(on.tree, on.X);
  const auto factor = factor_ldlt(M);
  DenseMatrix<Expression> Lambda_inv(on.rows, on.rows);
  for (std::size_t r = 0; r < on.rows; ++r) {
    Expressions column;
    for (std::size_t k = 0; k < J.cols(); ++k) column.push_back(J(r, k));
    column = solve(factor, column);
    for (std::size_t s = 0; s <= r; ++s) {
      for (std::size_t k = 0; k < J.cols(); ++k) {
        Lambda_inv(r, s) = Lambda_inv(r, s) + J(s, k) * column[k];
      }
      Lambda_inv(s, r) = Lambda_inv(r, s);
    }
  }
  return Lambda_inv;
}

DenseMatrix<Expression> lambda_inverse_by(Way way, const Counted& on) {
  if (way == Way::dense) return dense_lambda_inverse(on);
  return lambda_inverse_as_asked(on.tree, on.X, {{}, route_of(way)}, on.rows);
}

/// Control torque of Chang table 6.1 from its parts, with Lambda^-1 computed in any way.
Expressions control_torque_by(Way way, Counted& on) {
  const int nv = on.tree.nv;
  const Expressions qd = declare(on.program, "qd", nv);
  const Expressions qdd = declare(on.program, "qdd_0", nv);
  const Expressions xdd = declare(on.program, "xdd_cmd", static_cast<int>(on.rows));
  if (way != Way::dense) {
    return control_torque<Expression>(on.tree, on.X, {{qd, qdd}, xdd, {}}, {{}, route_of(way)},
                                      on.rows);
  }
  const auto poses = world_poses(on.tree, on.X);
  const auto tasks = task_points(on.tree, {}, poses);
  const auto J = jacobian_world(on.tree, poses, {}, on.rows);
  Expressions errors = bias_acceleration<Expression>(on.tree, on.X, tasks, qd);
  for (std::size_t r = 0; r < on.rows; ++r) {
    errors[r] = xdd[r] - errors[r];
    for (std::size_t k = 0; k < J.cols(); ++k) errors[r] = errors[r] - J(r, k) * qdd[k];
  }
  const auto F = solve(factor_ldlt(dense_lambda_inverse(on)), errors);
  Expressions tau = inverse_dynamics<Expression>(on.tree, on.X, {qd, qdd}, {});
  for (std::size_t k = 0; k < J.cols(); ++k) {
    for (std::size_t r = 0; r < on.rows; ++r) tau[k] = tau[k] + J(r, k) * F[r];
  }
  return tau;
}

using CountOf = std::function<int(const Shape&)>;

Series count_series(std::string name, std::string size, const std::vector<Shape>& shapes,
                    const std::function<int(const Shape&)>& size_of,
                    const std::vector<std::pair<std::string, CountOf>>& ways) {
  Series series{std::move(name), std::move(size), {}, {}, {}};
  for (const Shape& shape : shapes) series.sizes.push_back(size_of(shape));
  for (const auto& [way, count_of] : ways) {
    series.ways.push_back(way);
    std::vector<int>& flops = series.flops.emplace_back();
    for (const Shape& shape : shapes) flops.push_back(count_of(shape));
  }
  return series;
}

std::vector<std::pair<std::string, CountOf>> task_ways(int (*flops)(const Mechanism&, Way)) {
  std::vector<std::pair<std::string, CountOf>> ways;
  for (const Way way : kWays) {
    ways.emplace_back(name_of(way),
                      [way, flops](const Shape& shape) { return flops(make_robot(shape), way); });
  }
  return ways;
}

}  // namespace

Mechanism make_robot(const Shape& shape) {
  const tests::LimbedRobot made = tests::make_limbed_robot(shape);
  return reduced_mechanism(made.robot, made.scene);
}

const char* name_of(Way way) {
  switch (way) {
    case Way::unit_forces:
      return "PV-OSIM";
    case Way::branching:
      return "Chang table 5.3";
    case Way::sparse_factors:
      return "sparse L^T D L";
    case Way::dense:
      return "dense";
  }
  return "";
}

int lambda_inverse_flops(const Mechanism& robot, Way way) {
  return count(robot, [way](Counted& on) { return lambda_inverse_by(way, on).values(); });
}

int control_torque_flops(const Mechanism& robot, Way way) {
  return count(robot, [way](Counted& on) { return control_torque_by(way, on); });
}

int link_inertias_flops(const Mechanism& robot, bool by_recursion) {
  return count(robot, [by_recursion](Counted& on) {
    return by_recursion
               ? link_inverse_inertias(on.tree, on.X)
               : link_inverse_inertias_by_factors(on.tree, on.X, world_poses(on.tree, on.X));
  });
}

std::vector<Series> count_all() {
  std::vector<Shape> chains, trees, hands;
  for (const int n : {4, 8, 16, 24, 32, 48, 64}) chains.push_back({n, 0, 4, 1});
  for (const int limbs : {2, 4, 6, 8, 11, 15}) trees.push_back({4, limbs, 4, 2});
  for (int m = 1; m <= 8; ++m) hands.push_back({4, 8, 4, m});
  const auto links = [](const Shape& shape) { return shape.links(); };
  const auto points = [](const Shape& shape) { return shape.hands; };
  const std::vector<std::pair<std::string, CountOf>> inertia_ways{
      {"recursion over links",
       [](const Shape& shape) { return link_inertias_flops(make_robot(shape), true); }},
      {"link by link from M", [](const Shape& shape) {
         return shape.links() > 32 ? 0 : link_inertias_flops(make_robot(shape), false);
       }}};
  std::vector<Series> all;
  all.push_back(count_series("lambda_inverse_of_chains", "links n, one hand", chains, links,
                             task_ways(lambda_inverse_flops)));
  all.push_back(count_series("lambda_inverse_of_trees", "links n, two hands", trees, links,
                             task_ways(lambda_inverse_flops)));
  all.push_back(count_series("lambda_inverse_of_hands", "hands m of a tree of 36 links", hands,
                             points, task_ways(lambda_inverse_flops)));
  all.push_back(count_series("control_torque_of_chains", "links n, one hand", chains, links,
                             task_ways(control_torque_flops)));
  all.push_back(count_series("control_torque_of_trees", "links n, two hands", trees, links,
                             task_ways(control_torque_flops)));
  all.push_back(count_series("control_torque_of_hands", "hands m of a tree of 36 links", hands,
                             points, task_ways(control_torque_flops)));
  all.push_back(count_series("link_inertias_of_chains", "links n", chains, links, inertia_ways));
  all.push_back(count_series("link_inertias_of_trees", "links n", trees, links, inertia_ways));
  return all;
}

std::string csv_text(const Series& series) {
  std::string text = fmt::format("size,{}\n", fmt::join(series.ways, ","));
  for (std::size_t i = 0; i < series.sizes.size(); ++i) {
    text += fmt::format("{}", series.sizes[i]);
    for (const std::vector<int>& flops : series.flops) {
      text += flops[i] > 0 ? fmt::format(",{}", flops[i]) : ",";
    }
    text += '\n';
  }
  return text;
}

}  // namespace treeline::growth
