#pragma once
// Robots small enough to be written by hand, with the functions that generated code has.

#include <cmath>

namespace treeline::test {

/// Two revolute joints about y in a vertical plane, with point masses of 1 kg at the ends of two
/// links of 1 m (Craig, Introduction to Robotics, section 6.7), gravity 9.81 along -z. At q = 0 the
/// arm points along x; positive angles lift it.
struct TwoLink {
  static constexpr int kCoordinates = 2;
  static constexpr int kVelocities = 2;

  static void terms(const double (&q)[2], const double (&qd)[2], double (&M)[3], double (&h)[2]) {
    const double g = 9.81;
    const double c2 = std::cos(q[1]);
    const double s2 = std::sin(q[1]);
    M[0] = 3.0 + 2.0 * c2;
    M[1] = 1.0 + c2;
    M[2] = 1.0;
    h[0] = -s2 * (2.0 * qd[0] * qd[1] + qd[1] * qd[1]) +
           g * (2.0 * std::cos(q[0]) + std::cos(q[0] + q[1]));
    h[1] = s2 * qd[0] * qd[0] + g * std::cos(q[0] + q[1]);
  }
  static void inverse_dynamics(const double (&q)[2], const double (&qd)[2], const double (&qdd)[2],
                               double (&tau)[2]) noexcept {
    double M[3];
    double h[2];
    terms(q, qd, M, h);
    tau[0] = M[0] * qdd[0] + M[1] * qdd[1] + h[0];
    tau[1] = M[1] * qdd[0] + M[2] * qdd[1] + h[1];
  }
  static void forward_dynamics(const double (&q)[2], const double (&qd)[2], const double (&tau)[2],
                               double (&qdd)[2]) noexcept {
    double M[3];
    double h[2];
    terms(q, qd, M, h);
    const double determinant = M[0] * M[2] - M[1] * M[1];
    const double b[2] = {tau[0] - h[0], tau[1] - h[1]};
    qdd[0] = (M[2] * b[0] - M[1] * b[1]) / determinant;
    qdd[1] = (M[0] * b[1] - M[1] * b[0]) / determinant;
  }
  /// Kinetic and potential energy, J.
  static double energy(const double (&q)[2], const double (&qd)[2]) {
    double M[3];
    double h[2];
    terms(q, qd, M, h);
    return 0.5 * (M[0] * qd[0] * qd[0] + 2.0 * M[1] * qd[0] * qd[1] + M[2] * qd[1] * qd[1]) +
           9.81 * (2.0 * std::sin(q[0]) + std::sin(q[0] + q[1]));
  }
};

/// One free rigid body: frame at the centre of mass, 2 kg, principal inertias 0.3, 0.3, 0.5 kg m^2,
/// gravity 9.81 along -z.
struct FreeBody {
  static constexpr int kCoordinates = 7;
  static constexpr int kVelocities = 6;
  static constexpr double kMass = 2.0;
  static constexpr double kInertia[3] = {0.3, 0.3, 0.5};

  static void forward_dynamics(const double (&q)[7], const double (&qd)[6], const double (&tau)[6],
                               double (&qdd)[6]) noexcept {
    const double g = 9.81;
    const double x = q[3];
    const double y = q[4];
    const double z = q[5];
    const double w = q[6];
    // Gravity in the body's axes: the last row of R, times -g.
    const double down[3] = {-g * 2.0 * (x * z - w * y), -g * 2.0 * (y * z + w * x),
                            -g * (1.0 - 2.0 * (x * x + y * y))};
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      const int k = (i + 2) % 3;
      qdd[i] = tau[i] / kMass + down[i] - (qd[3 + j] * qd[k] - qd[3 + k] * qd[j]);
      qdd[3 + i] = (tau[3 + i] - (kInertia[k] - kInertia[j]) * qd[3 + j] * qd[3 + k]) / kInertia[i];
    }
  }
};

/// Two hands, each a ball of 1 kg and inertia 0.1 kg m^2 carried by massless prismatic joints along
/// x, y, z and gimbals about x, y', z'': 12 joints, two operational points with six rows in world
/// axes. The hands are 0.5 m left and right of the origin, 1 m above it.
struct TwoHands {
  static constexpr int kCoordinates = 12;
  static constexpr int kVelocities = 12;
  static constexpr int kTaskRows = 12;
  static constexpr double kInertia = 0.1;
  static constexpr double kGravity = 9.81;

  /// omega = B rates for gimbal angles a: columns x, Rx y, Rx Ry z.
  static void gimbal(const double* a, double (&B)[9]) {
    const double sx = std::sin(a[0]);
    const double cx = std::cos(a[0]);
    const double sy = std::sin(a[1]);
    const double cy = std::cos(a[1]);
    const double columns[9] = {1.0, 0.0, sy, 0.0, cx, -sx * cy, 0.0, sx, cx * cy};
    for (int i = 0; i < 9; ++i) {
      B[i] = columns[i];
    }
  }
  /// dB/dt rates.
  static void gimbal_bias(const double* a, const double* r, double (&bias)[3]) {
    const double sx = std::sin(a[0]);
    const double cx = std::cos(a[0]);
    const double sy = std::sin(a[1]);
    const double cy = std::cos(a[1]);
    bias[0] = cy * r[1] * r[2];
    bias[1] = -sx * r[0] * r[1] + (-cx * cy * r[0] + sx * sy * r[1]) * r[2];
    bias[2] = cx * r[0] * r[1] + (-sx * cy * r[0] - cx * sy * r[1]) * r[2];
  }
  static void solve3(const double (&A)[9], const double (&b)[3], double* x) {
    const double c0 = A[4] * A[8] - A[5] * A[7];
    const double c1 = A[5] * A[6] - A[3] * A[8];
    const double c2 = A[3] * A[7] - A[4] * A[6];
    const double determinant = A[0] * c0 + A[1] * c1 + A[2] * c2;
    const double inverse[9] = {c0, A[2] * A[7] - A[1] * A[8], A[1] * A[5] - A[2] * A[4],
                               c1, A[0] * A[8] - A[2] * A[6], A[2] * A[3] - A[0] * A[5],
                               c2, A[1] * A[6] - A[0] * A[7], A[0] * A[4] - A[1] * A[3]};
    for (int i = 0; i < 3; ++i) {
      x[i] = 0.0;
      for (int j = 0; j < 3; ++j) {
        x[i] += inverse[3 * i + j] * b[j] / determinant;
      }
    }
  }

  static void inverse_dynamics(const double (&q)[12], const double (&qd)[12],
                               const double (&qdd)[12], double (&tau)[12]) noexcept {
    for (int base = 0; base < 12; base += 6) {
      double B[9];
      double alpha[3];
      gimbal(q + base + 3, B);
      gimbal_bias(q + base + 3, qd + base + 3, alpha);
      for (int i = 0; i < 3; ++i) {
        tau[base + i] = qdd[base + i] + (i == 2 ? kGravity : 0.0);
        for (int j = 0; j < 3; ++j) {
          alpha[i] += B[3 * i + j] * qdd[base + 3 + j];
        }
      }
      for (int j = 0; j < 3; ++j) {
        tau[base + 3 + j] =
            kInertia * (B[j] * alpha[0] + B[3 + j] * alpha[1] + B[6 + j] * alpha[2]);
      }
    }
  }
  static void mass_matrix(const double (&q)[12], double (&M)[144]) noexcept {
    for (double& entry : M) {
      entry = 0.0;
    }
    for (int base = 0; base < 12; base += 6) {
      double B[9];
      gimbal(q + base + 3, B);
      for (int i = 0; i < 3; ++i) {
        M[(base + i) * 13] = 1.0;
        for (int j = 0; j < 3; ++j) {
          M[(base + 3 + i) * 12 + base + 3 + j] =
              kInertia * (B[i] * B[j] + B[3 + i] * B[3 + j] + B[6 + i] * B[6 + j]);
        }
      }
    }
  }
  static void forward_dynamics(const double (&q)[12], const double (&qd)[12],
                               const double (&tau)[12], double (&qdd)[12]) noexcept {
    for (int base = 0; base < 12; base += 6) {
      double B[9];
      double bias[3];
      gimbal(q + base + 3, B);
      gimbal_bias(q + base + 3, qd + base + 3, bias);
      const double transposed[9] = {B[0], B[3], B[6], B[1], B[4], B[7], B[2], B[5], B[8]};
      const double torque[3] = {tau[base + 3], tau[base + 4], tau[base + 5]};
      double moment[3];
      solve3(transposed, torque, moment);
      double rest[3];
      for (int i = 0; i < 3; ++i) {
        qdd[base + i] = tau[base + i] - (i == 2 ? kGravity : 0.0);
        rest[i] = moment[i] / kInertia - bias[i];
      }
      solve3(B, rest, qdd + base + 3);
    }
  }
  static void forward_kinematics(const double (&q)[12], double (&position)[6],
                                 double (&rotation)[18]) noexcept {
    for (int k = 0; k < 2; ++k) {
      const double* p = q + 6 * k;
      position[3 * k] = p[0];
      position[3 * k + 1] = p[1] + (k == 0 ? 0.5 : -0.5);
      position[3 * k + 2] = p[2] + 1.0;
      const double sx = std::sin(p[3]);
      const double cx = std::cos(p[3]);
      const double sy = std::sin(p[4]);
      const double cy = std::cos(p[4]);
      const double sz = std::sin(p[5]);
      const double cz = std::cos(p[5]);
      const double R[9] = {cy * cz,
                           -cy * sz,
                           sy,
                           cx * sz + sx * sy * cz,
                           cx * cz - sx * sy * sz,
                           -sx * cy,
                           sx * sz - cx * sy * cz,
                           sx * cz + cx * sy * sz,
                           cx * cy};
      for (int i = 0; i < 9; ++i) {
        rotation[9 * k + i] = R[i];
      }
    }
  }
  static void jacobian(const double (&q)[12], double (&J)[144]) noexcept {
    for (double& entry : J) {
      entry = 0.0;
    }
    for (int base = 0; base < 12; base += 6) {
      double B[9];
      gimbal(q + base + 3, B);
      for (int i = 0; i < 3; ++i) {
        J[(base + i) * 12 + base + i] = 1.0;
        for (int j = 0; j < 3; ++j) {
          J[(base + 3 + i) * 12 + base + 3 + j] = B[3 * i + j];
        }
      }
    }
  }
  /// As many joints as rows: the task alone determines the torque, whatever qdd_0 is.
  static void control_torque(const double (&q)[12], const double (&qd)[12], const double (&)[12],
                             const double (&xdd)[12], double (&tau)[12]) noexcept {
    double qdd[12];
    for (int base = 0; base < 12; base += 6) {
      double B[9];
      double bias[3];
      gimbal(q + base + 3, B);
      gimbal_bias(q + base + 3, qd + base + 3, bias);
      double rest[3];
      for (int i = 0; i < 3; ++i) {
        qdd[base + i] = xdd[base + i];
        rest[i] = xdd[base + 3 + i] - bias[i];
      }
      solve3(B, rest, qdd + base + 3);
    }
    inverse_dynamics(q, qd, qdd, tau);
  }
};

}  // namespace treeline::test
