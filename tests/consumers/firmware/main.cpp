// Minimal firmware: it steps the arm's control law with inputs from memory that hardware would
// write.
#include FIRMWARE_HEADER

namespace robot = FIRMWARE_NAMESPACE;
using robot::Real;

volatile Real sensor[robot::kCoordinates + robot::kVelocities];
volatile Real motor[robot::kVelocities];

extern "C" [[noreturn]] void _start() {
  for (;;) {
    Real q[robot::kCoordinates];
    Real qd[robot::kVelocities];
    static const Real posture[robot::kVelocities] = {};
    static const Real command[robot::kTaskRows] = {};
    Real tau[robot::kVelocities];
    for (int i = 0; i < robot::kCoordinates; ++i) {
      q[i] = sensor[i];
    }
    for (int i = 0; i < robot::kVelocities; ++i) {
      qd[i] = sensor[robot::kCoordinates + i];
    }
    robot::control_torque(q, qd, posture, command, tau);
    for (int i = 0; i < robot::kVelocities; ++i) {
      motor[i] = tau[i];
    }
  }
}
