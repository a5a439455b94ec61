#pragma once

#include <Eigen/Core>
#include <vector>

#include "oracle/subject.hpp"

namespace treeline {

/// Scales by which errors of results are measured: each equation with the magnitude of every term
/// in place of the term, so that nothing cancels. Lever arms are lengths of paths along the links,
/// never projected or folded. Velocities and accelerations add up along the path as if all had the
/// same direction. So a small torque that is the balance of large ones has the scale of the large
/// ones, the scale of each joint follows from what it carries, and no scale depends on the unit of
/// another. A lever arm that is only noise of the files (see `noise_limits`) has the scale of the
/// robot's longest one, because code leaves it out.
class TermSizes {
 public:
  TermSizes(const Subject<double>& subject, const std::vector<double>& q);

  /// Sizes of M: sum over bodies of m l_i l_j + |I|. nv x nv.
  [[nodiscard]] Eigen::MatrixXd mass_matrix() const;
  /// Sizes of M qdd + b + g - J_ext^T f_ext: sum over bodies of l m |a| + |I| |alpha|, plus those
  /// of friction and springs, and of the external forces if `f_ext` is not empty. nv.
  [[nodiscard]] Eigen::VectorXd forces(const std::vector<double>& qd,
                                       const std::vector<double>& qdd,
                                       const std::vector<double>& f_ext) const;
  /// Sizes of the derivatives of `forces` with respect to displacements. A displacement turns and
  /// moves what it displaces, and exposes it to other accelerations. nv x nv.
  [[nodiscard]] Eigen::MatrixXd forces_by_displacement(const std::vector<double>& qd,
                                                       const std::vector<double>& qdd,
                                                       const std::vector<double>& f_ext) const;
  /// Sizes of the derivatives of `forces` with respect to velocities: l m 2 (|w| l' + |v|) + |I| 2
  /// |w|. nv x nv.
  [[nodiscard]] Eigen::MatrixXd forces_by_velocity(const std::vector<double>& qd) const;
  /// Largest slopes of friction over the velocities of joints. nv.
  [[nodiscard]] Eigen::VectorXd friction_slopes() const;
  /// Size of the kinetic energy: sum over bodies of (m |v|^2 + |I| |w|^2) / 2.
  [[nodiscard]] double kinetic_energy(const std::vector<double>& qd) const;
  /// Size of the potential energy: gravity times the masses and the lengths of the paths to them,
  /// and that of springs.
  [[nodiscard]] double potential_energy() const;
  /// Sizes of Y, nv x columns: those of `forces` for bodies whose mass, first moment or moment is
  /// one. The columns are those of the subject's regressor.
  [[nodiscard]] Eigen::MatrixXd inverse_dynamics_regressor(const std::vector<double>& qd,
                                                           const std::vector<double>& qdd) const;
  /// Sizes of E, 2 x columns: those of the energies of such bodies.
  [[nodiscard]] Eigen::MatrixXd energy_regressor(const std::vector<double>& qd) const;
  /// Sizes of J, controlled rows x nv: l in translational rows, 1 in rotational ones.
  [[nodiscard]] Eigen::MatrixXd jacobian() const;
  /// Sizes of Jd qd, controlled rows: 2 |w| |v| and |w|^2.
  [[nodiscard]] Eigen::VectorXd bias(const std::vector<double>& qd) const;
  /// Sizes of positions and rotation matrices, in the layout of forward kinematics: 3, then 9 per
  /// point.
  [[nodiscard]] Eigen::VectorXd poses() const;
  /// Sizes of the centre of mass, 3: the mean length of the paths to the bodies' centres of mass.
  [[nodiscard]] Eigen::VectorXd center_of_mass() const;
  /// Sizes of the Jacobian of the centre of mass, 3 x nv: the mean of l.
  [[nodiscard]] Eigen::MatrixXd center_of_mass_jacobian() const;
  /// Sizes of A_G, 6 x nv: m l, and m d l + |I| with the distance d from the centre of mass.
  [[nodiscard]] Eigen::MatrixXd centroidal_momentum_matrix() const;
  /// Sizes of h_G, 6: m |v|, and m d |v| + |I| |w|.
  [[nodiscard]] Eigen::VectorXd centroidal_momentum(const std::vector<double>& qd) const;
  /// Sizes of dA_G/dt qd, 6: m |a|, and m d |a| + |I| (|alpha| + |w|^2).
  [[nodiscard]] Eigen::VectorXd centroidal_bias(const std::vector<double>& qd) const;
  /// Sizes of masses and centres of everything that links carry: n, then 3 n for the n bodies that
  /// move against their parents.
  [[nodiscard]] Eigen::VectorXd subtrees() const;
  /// Sizes of velocities of all points, 6 each.
  [[nodiscard]] Eigen::VectorXd point_velocities(const std::vector<double>& qd) const;
  /// Sizes of accelerations of all points, 6 each.
  [[nodiscard]] Eigen::VectorXd point_accelerations(const std::vector<double>& qd,
                                                    const std::vector<double>& qdd) const;
  /// Sizes of the Jacobian of all points, 6 rows each: l over 1. 6 rows a point x nv.
  [[nodiscard]] Eigen::MatrixXd point_jacobian() const;
  /// Sizes of the derivatives of velocities of all points: l |w| + |v| over |w|.
  [[nodiscard]] Eigen::MatrixXd point_velocities_by_displacement(
      const std::vector<double>& qd) const;
  /// Sizes of the derivatives of accelerations of all points, by displacements: l |alpha| + |a|
  /// over |alpha|; by velocities: twice those of velocities by displacements.
  [[nodiscard]] Eigen::MatrixXd point_accelerations_by_displacement(
      const std::vector<double>& qd, const std::vector<double>& qdd) const;
  [[nodiscard]] Eigen::MatrixXd point_accelerations_by_velocity(
      const std::vector<double>& qd) const;
  /// Sizes of the derivatives of h_G, 6 x nv: the momenta of bodies turn and change, their places
  /// and the centre of mass move.
  [[nodiscard]] Eigen::MatrixXd centroidal_momentum_by_displacement(
      const std::vector<double>& qd) const;
  /// Sizes of the derivatives of dh_G/dt, 6 x nv.
  [[nodiscard]] Eigen::MatrixXd centroidal_rate_by_displacement(
      const std::vector<double>& qd, const std::vector<double>& qdd) const;
  [[nodiscard]] Eigen::MatrixXd centroidal_rate_by_velocity(const std::vector<double>& qd) const;
  /// Sizes of the derivatives of the kinetic energy: m |v| (l |w| + |v|) + |I| |w|^2. 1 x nv.
  [[nodiscard]] Eigen::MatrixXd kinetic_energy_by_displacement(const std::vector<double>& qd) const;

 private:
  /// Motion of a point per unit of one velocity: `lever` in m, `turn` in rad per unit.
  struct Column {
    int v;
    double lever, turn;
  };
  using Columns = std::vector<Column>;
  /// Velocity and acceleration of a point, linear and angular.
  struct Motion {
    double v = 0, w = 0, a = 0, alpha = 0;
  };
  /// Linear and angular change of a velocity or an acceleration.
  struct Pair {
    double linear, angular;
  };
  static Pair velocity_change(const Motion& of, const Column& by);
  static Pair acceleration_change(const Motion& of, const Column& by);

  [[nodiscard]] Columns columns(int body, double distance) const;
  [[nodiscard]] double path_to(int body) const;
  [[nodiscard]] double first_moment() const;
  [[nodiscard]] std::vector<double> arms() const;
  /// Sizes of derivatives of a momentum or its rate where bodies stay in place. `change`: what a
  /// column changes of a body's velocity or acceleration.
  template <class Change>
  [[nodiscard]] Eigen::MatrixXd centroidal_columns(const std::vector<double>& qd,
                                                   const std::vector<double>& qdd,
                                                   Change change) const;
  template <class Change>
  [[nodiscard]] Eigen::MatrixXd point_columns(const std::vector<double>& qd,
                                              const std::vector<double>& qdd, Change change) const;
  [[nodiscard]] Motion motion(const Columns& columns, const std::vector<double>& qd,
                              const std::vector<double>& qdd) const;

  [[nodiscard]] Motion motion_of(const interpreter::OperationalPoint<double>& point,
                                 const std::vector<double>& qd,
                                 const std::vector<double>& qdd) const;

  const Subject<double>& subject_;
  std::vector<double> q_;
  std::vector<double> lengths_;  ///< by body: path from its parent's origin to its own, m
  double longest_ = 0;           ///< largest offset of a joint or a centre of mass, m
};

}  // namespace treeline
