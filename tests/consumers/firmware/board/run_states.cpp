// The arm's control torque in many states: prints its bits, and the instructions per call. The same
// source runs on the host, where nothing is counted. Angles are from 1e-6 to 1000 rad.
#include <stdint.h>

#include FIRMWARE_HEADER
#include "board.hpp"

namespace robot = FIRMWARE_NAMESPACE;
using robot::Real;

namespace {

constexpr int kStates = 200;
constexpr int kCalls = 64;  // of each state, to count them finely

uint32_t rng = 2463534242U;

/// Uniform in [-1, 1), by xorshift.
Real draw() {
  rng ^= rng << 13;
  rng ^= rng >> 17;
  rng ^= rng << 5;
  return static_cast<Real>(static_cast<int32_t>(rng)) / static_cast<Real>(2147483648.0F);
}

template <int size>
void fill(Real (&values)[size], Real largest) {
  for (Real& value : values) {
    value = largest * draw();
  }
}

void print_word(uint32_t word) {
  char text[10];
  for (int i = 0; i < 8; ++i) {
    text[i] = "0123456789abcdef"[(word >> (28 - 4 * i)) & 15U];
  }
  text[8] = ' ';
  text[9] = '\0';
  print(text);
}

void print_bits(Real value) {
  uint32_t words[sizeof(Real) / 4];
  __builtin_memcpy(words, &value, sizeof(words));
  for (const uint32_t word : words) {
    print_word(word);
  }
}

Real q[robot::kCoordinates];
Real qd[robot::kVelocities];
Real posture[robot::kVelocities];
Real command[robot::kTaskRows];
Real tau[robot::kVelocities];

}  // namespace

void run() {
  unsigned least = 0xffffffff;
  unsigned most = 0;
  constexpr Real kAngles[] = {Real(3.1F), Real(1000), Real(1e-6F), Real(30)};
  for (int state = 0; state < kStates; ++state) {
    fill(q, kAngles[state % 4]);
    fill(qd, Real(8));
    fill(posture, Real(10));
    fill(command, Real(10));
    const unsigned start = ticks();
    for (int call = 0; call < kCalls; ++call) {
      robot::control_torque(q, qd, posture, command, tau);
    }
    const unsigned taken = instructions_since(start);
    least = taken < least ? taken : least;
    most = taken > most ? taken : most;
    for (const Real value : tau) {
      print_bits(value);
    }
    print("\n");
  }
  print("instructions least ");
  print_word(least / kCalls);
  print("most ");
  print_word(most / kCalls);
  print("\n");
}
