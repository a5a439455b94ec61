#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "interpreter/instances.hpp"
#include "oracle/entries.hpp"
#include "oracle/group_sizes.hpp"
#include "oracle/term_sizes.hpp"

namespace treeline {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

std::set<int> bodies_to(const interpreter::Model<double>& model, int body) {
  std::set<int> bodies;
  for (; body != interpreter::kWorld; body = model.body(body).parent) bodies.insert(body);
  return bodies;
}

/// 1 for velocities of the joints between two bodies, 0 for all others.
VectorXd velocities_between(const interpreter::Model<double>& model, int first, int second) {
  const auto a = bodies_to(model, first);
  const auto b = bodies_to(model, second);
  VectorXd between = VectorXd::Zero(model.nv);
  for (int i = 0; i < model.size(); ++i) {
    if (a.contains(i) == b.contains(i)) continue;
    const int count = interpreter::velocity_count(model.body(i).kind);
    between.segment(model.body(i).v, count).setOnes();
  }
  return between;
}

/// Largest factors by which terms of a contact exceed its lever: from the divisions by the distance
/// of two balls, and by the sine between a disc's axis and the normal.
struct LeverSizes {
  double r = 0;       ///< from the centre to the contact, m
  double growth = 1;  ///< of a relative change of the displacement
};

LeverSizes lever_sizes(const interpreter::Rolling<double>& rolling, double way, double sine) {
  if (rolling.on_radius) {
    const double distance = std::abs(rolling.radius + *rolling.on_radius);
    return {rolling.radius * way / distance, way / distance};
  }
  if (!rolling.axis) return {rolling.radius, 1};
  return {2 * way / sine, 2 / sine};
}

/// The rows of a loop that rolls, from those of its first frame.
void roll(const interpreter::Rolling<double>& rolling, double way, double sine,
          const VectorXd& speeds, LoopSizes& sizes) {
  const LeverSizes lever = lever_sizes(rolling, way, sine);
  const double moving = (sizes.J.topRows(3) * speeds).maxCoeff();
  const double turning = (sizes.J.bottomRows(3) * speeds).maxCoeff();
  const double rate = lever.r * lever.growth * (turning + moving / way);
  sizes.bias.head(3) +=
      2 * lever.r * sizes.bias.tail(3) + VectorXd::Constant(3, 2 * turning * rate);
  const MatrixXd turned = 2 * lever.r * lever.growth * sizes.J.bottomRows(3);
  sizes.J.topRows(3) += turned.colwise().maxCoeff().replicate(3, 1);
  const double error =
      rolling.axis ? way * way / rolling.radius + rolling.radius : way + lever.r * lever.growth;
  sizes.errors << VectorXd::Constant(3, error), VectorXd::Ones(3);
  if (rolling.axis) sizes.condition = 1 / (sine * sine);
}

interpreter::detail::LoopState<double> place(const Subject<double>& subject, const State& state,
                                             const interpreter::Loop<double>& loop) {
  const auto q = vector_of<double>(state.q);
  return {loop,
          interpreter::kinematics<double>(subject.model, q, VectorXd::Zero(subject.model.nv))};
}

/// Sine of the angle between a disc's axis and the normal of the plane that it rolls on. 1 for
/// balls.
double sine_of(const interpreter::Rolling<double>& rolling,
               const interpreter::detail::LoopState<double>& at) {
  return rolling.axis ? at.R.col(2).cross(at.R_first * *rolling.axis).norm() : 1;
}

/// Sizes of the six rows of one loop.
LoopSizes sizes_of(const Subject<double>& subject, const State& state,
                   const interpreter::Loop<double>& loop) {
  Subject<double> seen = subject;
  seen.points = interpreter::detail::in_world(loop);
  const VectorXd between = velocities_between(subject.model, loop.first.body, loop.second.body);
  const MatrixXd both = TermSizes(seen, state.q).jacobian() * between.asDiagonal();
  const VectorXd speeds = magnitudes(state.qd);
  const MatrixXd turns = both.middleRows(3, 3).cwiseMax(both.middleRows(9, 3));
  // The first frame is seen from the second along the links between them. What lies before the
  // first joint is in no lever, but in the displacement.
  const auto at = place(subject, state, loop);
  const double way = both.middleRows(0, 3).maxCoeff() + both.middleRows(6, 3).maxCoeff() +
                     loop.first.p.norm() + loop.second.p.norm() + at.d.norm();
  LoopSizes sizes{MatrixXd(6, both.cols()), VectorXd(6), VectorXd(6)};
  sizes.J << both.middleRows(0, 3) + both.middleRows(6, 3) + way * both.middleRows(9, 3), turns;
  const double turning = (turns * speeds).maxCoeff();
  const double moving = (sizes.J.topRows(3) * speeds).maxCoeff();
  sizes.bias << VectorXd::Constant(3, 4 * turning * moving),
      VectorXd::Constant(3, 2 * turning * turning);
  sizes.errors << VectorXd::Constant(3, way), VectorXd::Ones(3);
  if (loop.rolling) {
    // A centre in the plane has no way to it.
    roll(*loop.rolling, way + std::abs(loop.rolling->radius), sine_of(*loop.rolling, at), speeds,
         sizes);
  }
  return sizes;
}

}  // namespace

LoopSizes loop_sizes(const Subject<double>& subject, const State& state) {
  const Eigen::Index rows = interpreter::row_count(subject.loops);
  LoopSizes sizes{MatrixXd::Zero(rows, subject.model.nv), VectorXd::Zero(rows),
                  VectorXd::Zero(rows)};
  Eigen::Index row = 0;
  for (const auto& loop : subject.loops.frames) {
    const LoopSizes all = sizes_of(subject, state, loop);
    sizes.condition = std::max(sizes.condition, all.condition);
    for (const int held : interpreter::controlled_rows<double>({loop.second})) {
      sizes.J.row(row) = all.J.row(held);
      sizes.bias(row) = all.bias(held);
      sizes.errors(row++) = all.errors(held);
    }
  }
  for (const auto& coupling : subject.loops.couplings) {
    sizes.errors(row) = std::abs(coupling.offset);
    for (const auto& part : coupling.parts) {
      sizes.J(row, part.v) += std::abs(part.factor);
      sizes.errors(row) += std::abs(part.factor * state.q[static_cast<std::size_t>(part.q)]);
    }
    ++row;
  }
  return sizes;
}

}  // namespace treeline
