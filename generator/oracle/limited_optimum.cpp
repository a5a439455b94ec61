#include "oracle/limited_optimum.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "interpreter/instances.hpp"
#include "oracle/entries.hpp"
#include "oracle/interpret.hpp"
#include "oracle/subject_at.hpp"

namespace treeline {
namespace {

using Matrix50 = interpreter::Matrix<Digits50>;
using Vector50 = interpreter::Vector<Digits50>;
using Dense50 = Eigen::Matrix<Digits50, Eigen::Dynamic, Eigen::Dynamic>;

/// Held rows that depend on each other share their multiplier by this; it moves no digit of double.
const Digits50 kRegularisation("1e-24");
/// A row of J_s that has less than this share left outside the others depends on them.
constexpr double kDependent = 1e-12;
/// Share left outside the others below which rounding decides whether a row depends on them.
constexpr double all_but_dependent(Real real) {
  return real == Real::float32 ? 1e-2 : 1e-7;
}
/// Largest multiplier or violation that counts as 0, relative to what it is compared with.
const Digits50 kResidue("1e-18");

Digits50 largest(const Vector50& x) {
  return x.size() == 0 ? Digits50(0) : Digits50(x.cwiseAbs().maxCoeff());
}

/// Columns of a matrix that are independent of those before them, by Gram and Schmidt.
struct IndependentColumns {
  std::vector<Eigen::Index> independent;
  std::vector<Eigen::Index> dependent;
  bool certain = true;  ///< rounding decides none
};

IndependentColumns find_independent(const Matrix50& columns, Real real) {
  IndependentColumns found;
  Matrix50 basis(columns.rows(), columns.cols());
  for (Eigen::Index j = 0; j < columns.cols(); ++j) {
    const auto before = basis.leftCols(static_cast<Eigen::Index>(found.independent.size()));
    Vector50 left = columns.col(j);
    for (int pass = 0; pass < 2; ++pass) left -= before * Vector50(before.transpose() * left);
    const Digits50 length = columns.col(j).norm();
    const Digits50 share = length == 0 ? Digits50(0) : Digits50(left.norm() / length);
    const bool depends = share <= all_but_dependent(real);
    if (depends && share > kDependent) found.certain = false;
    if (!depends) basis.col(before.cols()) = left.normalized();
    (depends ? found.dependent : found.independent).push_back(j);
  }
  return found;
}

/// The equations of d_qdd, as columns in coordinates in which M is 1: passive entries of M d_qdd
/// that no force of the held rows balances, then the held rows.
Matrix50 equations_of_motion(const LimitProblem& problem, const LimitFacts& facts,
                             const Matrix50& weighted, const IndependentColumns& carried) {
  const Eigen::LLT<Dense50> of_inertia(Dense50(problem.M));
  const Dense50 rows = of_inertia.matrixU();
  const auto count = static_cast<Eigen::Index>(carried.dependent.size());
  Matrix50 equations(problem.M.rows(), count + problem.J_s.rows());
  const Matrix50 basis = weighted(Eigen::all, carried.independent);
  for (Eigen::Index k = 0; k < count; ++k) {
    const Eigen::Index j = carried.dependent[static_cast<std::size_t>(k)];
    equations.col(k) = rows.col(facts.passive[static_cast<std::size_t>(j)]);
    if (carried.independent.empty()) continue;
    const Vector50 relation = Dense50(basis.transpose() * basis)
                                  .ldlt()
                                  .solve(Vector50(basis.transpose() * weighted.col(j)));
    for (Eigen::Index r = 0; r < relation.size(); ++r) {
      const Eigen::Index other = carried.independent[static_cast<std::size_t>(r)];
      equations.col(k) -= relation(r) * rows.col(facts.passive[static_cast<std::size_t>(other)]);
    }
  }
  equations.rightCols(problem.J_s.rows()) =
      of_inertia.matrixL().solve(Dense50(problem.J_s.transpose()));
  return equations;
}

/// The share of a row, or 1.
Digits50 share_of(const Vector50& shares, Eigen::Index row) {
  return shares.size() == 0 ? Digits50(1) : shares(row);
}

/// Weights of forces, of rows that are held in part less: none of those that are not held.
Vector50 force_weights(const LimitProblem& problem, const LimitFacts& facts) {
  Vector50 weights(problem.f.size());
  for (Eigen::Index i = 0; i < weights.size(); ++i) {
    const Digits50 share = share_of(problem.held_shares, i);
    weights(i) = facts.force_weights[static_cast<std::size_t>(i)] * sqrt(share);
  }
  return weights;
}

/// The program in y = (d_qdd, d_f, slack): least 1/2 y^T H y + h^T y with E y = 0 and the limits.
class DenseProgram {
 public:
  DenseProgram(const LimitProblem& problem, const LimitFacts& facts)
      : problem_(problem),
        facts_(facts),
        nv_(problem.M.rows()),
        held_(problem.f.size()),
        size_(nv_ + held_ + 1),
        M_inverse_(interpreter::inverse_of_positive_definite<Digits50>(problem.M)) {
    set_cost();
    set_equations();
    set_limits();
  }

  /// H y + h = E^T lambda + B^T mu with the sides' rows of B at their limits.
  void solve(const LimitSides& sides);
  /// Changes one side that violates a condition; false where there is none.
  [[nodiscard]] bool correct(LimitSides& sides) {
    solve(sides);
    return drop_wrong(sides) || add_missed(sides);
  }

  [[nodiscard]] LimitedOptimum optimum(const LimitSides& sides) const {
    const Vector50 d_qdd = y_.head(nv_);
    Vector50 d_f = y_.segment(nv_, held_), lost = -(problem_.J_t * d_qdd);
    // What is not held has no force, and what is not done loses nothing.
    for (Eigen::Index i = 0; i < held_; ++i) {
      if (share_of(problem_.held_shares, i) == 0) d_f(i) = 0;
    }
    for (Eigen::Index t = 0; t < lost.size(); ++t) {
      if (share_of(problem_.task_shares, t) == 0) lost(t) = 0;
    }
    return {Vector50(problem_.tau + problem_.M * d_qdd - problem_.J_s.transpose() * d_f),
            Vector50(problem_.f + d_f),
            lost,
            lost_size(d_qdd, d_f),
            y_(size_ - 1),
            0,
            sides};
  }

 private:
  void set_cost();
  void set_equations();
  void set_limits();
  void add_limit(const Vector50& row, const Digits50& lower, const Digits50& upper, bool has_lower,
                 bool has_upper);
  [[nodiscard]] Matrix50 free_forces() const;
  [[nodiscard]] Digits50 lost_size(const Vector50& d_qdd, const Vector50& d_f) const;
  [[nodiscard]] bool drop_wrong(LimitSides& sides) const;
  [[nodiscard]] bool add_missed(LimitSides& sides) const;

  const LimitProblem& problem_;
  const LimitFacts& facts_;
  Eigen::Index nv_, held_, size_;
  Matrix50 M_inverse_;
  Matrix50 H_, E_, B_;
  Vector50 h_, lower_, upper_;
  std::vector<bool> has_lower_, has_upper_;
  Vector50 y_, multipliers_;
};

/// The part of d_f over its weights that balances no passive joint.
Matrix50 DenseProgram::free_forces() const {
  const Vector50 weights = force_weights(problem_, facts_);
  Matrix50 left = Matrix50::Identity(held_, held_);
  if (!facts_.passive.empty() && held_ > 0) {
    const Dense50 G = weights.asDiagonal() * problem_.J_s(Eigen::all, facts_.passive);
    Eigen::CompleteOrthogonalDecomposition<Dense50> factors(G.rows(), G.cols());
    factors.setThreshold(Digits50("1e-9"));
    factors.compute(G);
    left -= G * factors.pseudoInverse();
  }
  Vector50 inverse = weights;
  for (Digits50& each : inverse) each = each == 0 ? Digits50(0) : Digits50(1 / each);
  return left * inverse.asDiagonal();
}

/// Size of J_t M^-1 (tau + J_s^T f), whose difference before and after is what the task loses.
Digits50 DenseProgram::lost_size(const Vector50& d_qdd, const Vector50& d_f) const {
  const Vector50 forces =
      problem_.tau.cwiseAbs() + (problem_.M * d_qdd).cwiseAbs() +
      problem_.J_s.transpose().cwiseAbs() * (problem_.f.cwiseAbs() + d_f.cwiseAbs());
  return largest(problem_.J_t.cwiseAbs() * Vector50(M_inverse_.cwiseAbs() * forces));
}

void DenseProgram::set_cost() {
  const Digits50 k2 = Digits50(problem_.hierarchy) * problem_.hierarchy;
  const Digits50 largest_inertia = problem_.M.diagonal().maxCoeff();
  H_ = Matrix50::Zero(size_, size_);
  h_ = Vector50::Zero(size_);
  H_.topLeftCorner(nv_, nv_) = problem_.M;
  for (Eigen::Index t = 0; t < problem_.J_t.rows(); ++t) {
    const Vector50 row = problem_.J_t.row(t).transpose();
    const Digits50 mobility = row.dot(Vector50(M_inverse_ * row));
    if (mobility == 0) continue;
    const Digits50 done = pow(share_of(problem_.task_shares, t), 8);
    const Digits50 weight = k2 * done * facts_.task_weights[static_cast<std::size_t>(t)] / mobility;
    H_.topLeftCorner(nv_, nv_) += weight * row * row.transpose();
  }
  const Matrix50 free = free_forces();
  H_.block(nv_, nv_, held_, held_) = free.transpose() * free / Digits50(k2 * largest_inertia);
  const Digits50 penalty = 10000 * k2;
  H_(size_ - 1, size_ - 1) = penalty / Digits50(10 * largest_inertia);
  h_(size_ - 1) = penalty;
}

void DenseProgram::set_equations() {
  const auto passive = static_cast<Eigen::Index>(facts_.passive.size());
  E_ = Matrix50::Zero(held_ + passive, size_);
  for (Eigen::Index i = 0; i < held_; ++i) {
    const Digits50 share = share_of(problem_.held_shares, i);
    const Vector50 row = problem_.J_s.row(i).transpose();
    E_.row(i).head(nv_) = share * row.transpose();
    E_(i, nv_ + i) = (1 - share) * row.dot(Vector50(M_inverse_ * row));
  }
  E_.block(held_, 0, passive, nv_) = problem_.M(facts_.passive, Eigen::all);
  E_.block(held_, nv_, passive, held_) = -problem_.J_s(Eigen::all, facts_.passive).transpose();
}

void DenseProgram::add_limit(const Vector50& row, const Digits50& lower, const Digits50& upper,
                             bool has_lower, bool has_upper) {
  const auto at = static_cast<Eigen::Index>(has_lower_.size());
  B_.row(at) = row.transpose();
  lower_(at) = lower;
  upper_(at) = upper;
  has_lower_.push_back(has_lower);
  has_upper_.push_back(has_upper);
}

void DenseProgram::set_limits() {
  const auto motors = nv_ - static_cast<Eigen::Index>(facts_.passive.size());
  const auto count = motors + static_cast<Eigen::Index>(facts_.cones.size()) + 1;
  B_ = Matrix50::Zero(count, size_);
  lower_ = upper_ = Vector50::Zero(count);
  for (Eigen::Index v = 0; v < nv_; ++v) {
    if (std::count(facts_.passive.begin(), facts_.passive.end(), static_cast<int>(v)) > 0) continue;
    Vector50 row = Vector50::Zero(size_);
    row.head(nv_) = problem_.M.row(v).transpose();
    row.segment(nv_, held_) = -problem_.J_s.col(v);
    const double most = facts_.torque[static_cast<std::size_t>(v)];
    const bool limited = std::isfinite(most);
    const Digits50 limit = limited ? most : 0;
    add_limit(row, -limit - problem_.tau(v), limit - problem_.tau(v), limited, limited);
  }
  for (const LimitFacts::Row& cone : facts_.cones) {
    Vector50 row = Vector50::Zero(size_);
    const Digits50 share = share_of(problem_.held_shares, cone.first);
    Digits50 room = share * cone.bound;
    for (std::size_t i = 0; i < cone.coefficients.size(); ++i) {
      const auto force = cone.first + static_cast<Eigen::Index>(i);
      row(nv_ + force) = cone.coefficients[i];
      room -= cone.coefficients[i] * problem_.f(force);
    }
    const Digits50 narrowed = pow(share, 7);
    row *= narrowed;
    row(size_ - 1) = -1;
    add_limit(row, 0, narrowed * room, false, share > problem_.least_share);
  }
  add_limit(Vector50::Unit(size_, size_ - 1), 0, 0, true, false);
}

void DenseProgram::solve(const LimitSides& sides) {
  std::vector<Eigen::Index> active;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (sides[i] != 0) active.push_back(static_cast<Eigen::Index>(i));
  }
  const auto equations = E_.rows();
  const auto count = static_cast<Eigen::Index>(active.size());
  Dense50 K = Dense50::Zero(size_ + equations + count, size_ + equations + count);
  Vector50 b = Vector50::Zero(K.rows());
  K.topLeftCorner(size_, size_) = H_;
  K.block(0, size_, size_, equations) = -E_.transpose();
  K.block(size_, 0, equations, size_) = E_;
  K.block(size_, size_, equations, equations).diagonal().setConstant(kRegularisation);
  b.head(size_) = -h_;
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Index row = active[static_cast<std::size_t>(i)];
    const Eigen::Index at = size_ + equations + i;
    K.col(at).head(size_) = -B_.row(row).transpose();
    K.row(at).head(size_) = B_.row(row);
    b(at) = sides[static_cast<std::size_t>(row)] < 0 ? lower_(row) : upper_(row);
  }
  const Vector50 x = K.partialPivLu().solve(b);
  y_ = x.head(size_);
  multipliers_ = Vector50::Zero(B_.rows());
  for (Eigen::Index i = 0; i < count; ++i) {
    multipliers_(active[static_cast<std::size_t>(i)]) = x(size_ + equations + i);
  }
}

/// Gives up the limit whose multiplier has the wrong sign the most.
bool DenseProgram::drop_wrong(LimitSides& sides) const {
  Digits50 worst = -kResidue * largest(multipliers_);
  std::size_t wrong = sides.size();
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const Digits50 inward = -sides[i] * multipliers_(static_cast<Eigen::Index>(i));
    if (!(inward < worst)) continue;
    worst = inward;
    wrong = i;
  }
  if (wrong == sides.size()) return false;
  sides[wrong] = 0;
  return true;
}

/// Takes in the limit that is exceeded the most, in proportion to its terms.
bool DenseProgram::add_missed(LimitSides& sides) const {
  Digits50 worst = kResidue;
  std::size_t missed = sides.size();
  int side = 0;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (sides[i] != 0) continue;
    const auto row = static_cast<Eigen::Index>(i);
    const Digits50 value = B_.row(row).dot(y_.transpose());
    const Digits50 terms =
        1 + abs(lower_(row)) + abs(upper_(row)) + largest(B_.row(row).transpose()) * largest(y_);
    const auto consider = [&](const Digits50& beyond, int which) {
      if (!(beyond / terms > worst)) return;
      worst = beyond / terms;
      missed = i;
      side = which;
    };
    if (has_lower_[i]) consider(lower_(row) - value, -1);
    if (has_upper_[i]) consider(value - upper_(row), 1);
  }
  if (missed == sides.size()) return false;
  sides[missed] = side;
  return true;
}

}  // namespace

LimitProblem limit_problem(const Subject<Digits50>& subject, const State& state,
                           const std::vector<double>& tau, const std::vector<double>& f,
                           double hierarchy, double least_share) {
  const SubjectAt<Digits50> at(subject, state);
  const auto q = vector_of<Digits50>(state.q);
  const auto& tasks = values_of(state, Quantity::active_tasks);
  return {
      interpreter::mass_matrix<Digits50>((*at).model, q),
      interpreter::detail::held_jacobian<Digits50>((*at).model, (*at).constraints, (*at).loops, q),
      interpreter::jacobian<Digits50>((*at).model, (*at).points, q),
      vector_of<Digits50>(tau),
      vector_of<Digits50>(f),
      hierarchy,
      least_share,
      held_shares(subject, state),
      tasks.empty() ? Vector50() : interpreter::task_shares<Digits50>((*at).points).s};
}

LimitedOptimum point_at_limits(const LimitProblem& problem, const LimitFacts& facts,
                               const LimitSides& sides) {
  DenseProgram program(problem, facts);
  program.solve(sides);
  return program.optimum(sides);
}

bool fits_freedoms(const LimitProblem& problem, const LimitFacts& facts, Real real) {
  const auto passive = static_cast<Eigen::Index>(facts.passive.size());
  const Vector50 weights = force_weights(problem, facts);
  const Matrix50 weighted = weights.asDiagonal() * problem.J_s(Eigen::all, facts.passive);
  // Rows that are held in part are equations of forces too, which depend on no other.
  std::vector<Eigen::Index> whole;
  for (Eigen::Index h = 0; h < problem.f.size(); ++h) {
    if (share_of(problem.held_shares, h) >= 1) whole.push_back(h);
  }
  LimitProblem held = problem;
  held.J_s = problem.J_s(whole, Eigen::all);
  const IndependentColumns carried = find_independent(weighted, real);
  const Matrix50 equations = equations_of_motion(held, facts, weighted, carried);
  const auto count = static_cast<Eigen::Index>(whole.size());
  const IndependentColumns all = find_independent(equations, real);
  const IndependentColumns rows = find_independent(equations.rightCols(count), real);
  const auto dependent = static_cast<Eigen::Index>(rows.dependent.size());
  return problem.M.rows() - passive + dependent <= facts.freedoms && carried.certain &&
         all.certain && rows.certain;
}

std::optional<LimitedOptimum> find_limited_optimum(const LimitProblem& problem,
                                                   const LimitFacts& facts, LimitSides sides,
                                                   int most) {
  DenseProgram program(problem, facts);
  for (int corrections = 0; corrections <= most; ++corrections) {
    if (program.correct(sides)) continue;
    LimitedOptimum optimum = program.optimum(sides);
    optimum.corrections = corrections;
    return optimum;
  }
  return std::nullopt;
}

}  // namespace treeline
