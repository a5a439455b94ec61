#pragma once

#include <Eigen/Core>
#include <vector>

#include "oracle/subject.hpp"

namespace treeline {

/// The scale that errors of results are measured by: each equation with the magnitude of every term
/// in place of the term, so that nothing cancels. Lever arms are lengths of paths along the links,
/// never projected or folded; velocities and accelerations add up along the path as if all had one
/// direction. So a torque that is small because large ones balance has the scale of the large ones,
/// each joint has the scale of what hangs on it, and no scale depends on the unit of another. A
/// lever that is nothing but noise of the files, see `noise_limits`, has the robot's longest for a
/// scale: code leaves it out.
class TermSizes {
 public:
  TermSizes(const Subject<double>& subject, const std::vector<double>& q);

  /// Of M: sum over bodies of m l_i l_j + |I|. nv x nv.
  [[nodiscard]] Eigen::MatrixXd mass_matrix() const;
  /// Of M qdd + b + g - J_ext^T f_ext: sum over bodies of l m |a| + |I| |alpha|, and the external
  /// forces' where `f_ext` has any. nv.
  [[nodiscard]] Eigen::VectorXd forces(const std::vector<double>& qd,
                                       const std::vector<double>& qdd,
                                       const std::vector<double>& f_ext) const;
  /// Of the derivatives of `forces` by displacements: as they turn, move and meet other
  /// accelerations with what is displaced. nv x nv.
  [[nodiscard]] Eigen::MatrixXd forces_by_displacement(const std::vector<double>& qd,
                                                       const std::vector<double>& qdd,
                                                       const std::vector<double>& f_ext) const;
  /// Of the derivatives of `forces` by velocities: l m 2 (|w| l' + |v|) + |I| 2 |w|. nv x nv.
  [[nodiscard]] Eigen::MatrixXd forces_by_velocity(const std::vector<double>& qd) const;
  /// Of the kinetic energy: sum over bodies of (m |v|^2 + |I| |w|^2) / 2.
  [[nodiscard]] double kinetic_energy(const std::vector<double>& qd) const;
  /// Of the potential energy: gravity times the masses and the lengths of the paths to them.
  [[nodiscard]] double potential_energy() const;
  /// Of J, controlled rows x nv: l in rows of translation, 1 in those of rotation.
  [[nodiscard]] Eigen::MatrixXd jacobian() const;
  /// Of Jd qd, controlled rows: 2 |w| |v| and |w|^2.
  [[nodiscard]] Eigen::VectorXd bias(const std::vector<double>& qd) const;
  /// Of positions and rotation matrices, as forward kinematics gives them: 3 and then 9 a point.
  [[nodiscard]] Eigen::VectorXd poses() const;
  /// Of the centre of mass, 3: the mean length of the paths to the bodies' centres.
  [[nodiscard]] Eigen::VectorXd center_of_mass() const;
  /// Of its Jacobian, 3 x nv: the mean of l.
  [[nodiscard]] Eigen::MatrixXd center_of_mass_jacobian() const;

 private:
  /// How one velocity moves a point: by `lever` m/s and `turn` rad/s for 1 of it.
  struct Column {
    int v;
    double lever, turn;
  };
  using Columns = std::vector<Column>;
  /// Velocity and acceleration of a point, linear and angular.
  struct Motion {
    double v = 0, w = 0, a = 0, alpha = 0;
  };

  [[nodiscard]] Columns columns(int body, double distance) const;
  [[nodiscard]] double path_to(int body) const;
  [[nodiscard]] double first_moment() const;
  [[nodiscard]] Motion motion(const Columns& columns, const std::vector<double>& qd,
                              const std::vector<double>& qdd) const;

  const Subject<double>& subject_;
  std::vector<double> lengths_;  ///< of each body: of the way from its parent's origin to its own
  double longest_ = 0;           ///< offset of a joint or a centre of mass
};

}  // namespace treeline
