// Would catch: a step of an emitted controller whose torque is not finite, beyond its limit or its
// rate; a current that is not finite; a fault that gets lost before a reset; brakes that are not
// called for; a configuration or a measurement that is not sound and no fault; undefined behaviour.
// An input is a program of some steps: bytes choose numbers of the configuration, commands and
// measurements, odd ones among them.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "gantry_controller.h"
#include "puma_arm_controller.h"

namespace {

/// Draws numbers from the fuzzer's bytes; zeros where they are used up.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : at_(data), end_(data + size) {}
  bool used_up() const { return at_ == end_; }
  unsigned byte() { return at_ == end_ ? 0U : *at_++; }
  /// From -1 to 1.
  double share() { return (byte() - 127.5) / 127.5; }
  /// Around `usual`, or anything.
  double number(double usual) {
    static const double odd[] = {0,
                                 -0.0,
                                 std::numeric_limits<double>::quiet_NaN(),
                                 std::numeric_limits<double>::infinity(),
                                 -std::numeric_limits<double>::infinity(),
                                 std::numeric_limits<double>::max(),
                                 -std::numeric_limits<double>::max(),
                                 std::numeric_limits<double>::denorm_min(),
                                 1e-30,
                                 1e30,
                                 1e9,
                                 -1,
                                 1e-9,
                                 1e15,
                                 3.5e8,
                                 1};
    const unsigned kind = byte();
    if (kind < 16) return odd[kind];
    if (kind < 80) return usual * std::exp2(8 * share());
    return usual * share();
  }

 private:
  const std::uint8_t* at_;
  const std::uint8_t* end_;
};

void demand(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "broken: %s\n", what);
  std::abort();
}

/// A joint's current where the controller tells currents, else 0.
template <class Output>
auto current_of(const Output& output, int joint, int) -> decltype(output.current[joint]) {
  return output.current[joint];
}
template <class Output>
double current_of(const Output&, int, long) {
  return 0;
}

template <class Robot>
class Run {
  static constexpr int n = Robot::kJoints;

 public:
  Run() {
    Robot::default_config(config_);
    Robot::default_config(defaults_);
  }

  void step(Bytes& bytes) {
    const unsigned what = bytes.byte();
    if ((what & 7U) == 0) change_config(bytes);
    if ((what & 0x38U) != 0) command(bytes);
    measure(bytes, (what & 0xc0U) == 0);
    const auto last = output_;
    Robot::step(config_, state_, input_, output_);
    check(last);
    stepped_ = true;
  }

 private:
  using Number = typename Robot::Real;

  void change_config(Bytes& bytes) {
    // The struct is numbers alone, but for three integers at its end.
    auto* const numbers = reinterpret_cast<Number*>(&config_);
    const auto* const usual = reinterpret_cast<const Number*>(&defaults_);
    const std::size_t count = offsetof(typename Robot::Config, saturation) / sizeof(Number);
    const std::size_t place = bytes.byte() % (count + 4);
    if (place < count) {
      numbers[place] = static_cast<Number>(bytes.number(usual[place]));
    } else if (place == count) {
      config_.saturation = static_cast<std::int32_t>(bytes.byte() % 4) - 1;
    } else if (place == count + 1) {
      config_.stale_ticks = static_cast<std::int32_t>(bytes.byte()) - 5;
    } else if (place == count + 2) {
      config_.blind_ticks = static_cast<std::int32_t>(bytes.byte()) - 5;
    } else {
      config_ = defaults_;
    }
  }

  void command(Bytes& bytes) {
    auto& command = input_.command;
    const unsigned kind = bytes.byte();
    command.kind = kind < 240 ? static_cast<std::int32_t>(kind % 14) : INT32_MAX - 255 + kind;
    ++command.sequence;
    command.point = kind % 16 == 15 ? -1 : static_cast<std::int32_t>(kind / 16 % 3);
    command.duration = static_cast<Number>(bytes.number(2));
    for (int i = 0; i < n; ++i) {
      command.goal[i] = static_cast<Number>(state_.sound_q[i] + bytes.number(1));
    }
    if constexpr (Robot::kTask) {
      for (auto& x : command.position) x = static_cast<Number>(bytes.number(0.8));
      const double angle = 3.2 * bytes.share();
      const double turn[9] = {
          std::cos(angle), -std::sin(angle), 0, std::sin(angle), std::cos(angle), 0, 0, 0, 1};
      for (int i = 0; i < 9; ++i) command.rotation[i] = static_cast<Number>(turn[i]);
      if (kind > 200) command.rotation[kind % 9] = static_cast<Number>(bytes.number(1));
    }
    if constexpr (Robot::kForce) {
      command.direction[0] = command.direction[1] = 0;
      command.direction[2] = kind % 2 == 0 ? -1 : 1;
      if (kind > 200) command.direction[kind % 3] = static_cast<Number>(bytes.number(1));
      command.force = static_cast<Number>(bytes.number(40));
    }
  }

  /// A robot that moves about as it is told to, or as it likes; numbers that are lost.
  void measure(Bytes& bytes, bool wild) {
    for (int i = 0; i < n; ++i) {
      qd_[i] += wild ? 0.3 * bytes.share() : 1e-5 * static_cast<double>(output_.tau[i]);
      qd_[i] = std::fmin(std::fmax(0.99 * qd_[i], -30), 30);
      q_[i] += 1e-3 * qd_[i];
      input_.q[i] = static_cast<Number>(q_[i]);
      input_.qd[i] = static_cast<Number>(qd_[i]);
    }
    const unsigned lost = bytes.byte();
    if (lost < 12) input_.q[bytes.byte() % n] = static_cast<Number>(bytes.number(3));
    if (lost > 4 && lost < 24) input_.qd[bytes.byte() % n] = static_cast<Number>(bytes.number(3));
    if constexpr (Robot::kForce) {
      if (lost > 200) input_.force[lost % 3] = static_cast<Number>(bytes.number(30));
    }
  }

  bool measured() const {
    bool finite = true;
    for (int i = 0; i < n; ++i) {
      finite = finite && std::isfinite(input_.q[i]) && std::isfinite(input_.qd[i]);
    }
    if constexpr (Robot::kForce) {
      for (const auto f : input_.force) finite = finite && std::isfinite(f);
    }
    return finite;
  }

  void check(const typename Robot::Output& last) {
    constexpr std::uint32_t kMeasurement = 1, kConfig = 512, kUntrusted = 1 | 8 | 64 | 128 | 512;
    constexpr int kFaulted = 3, kReset = 3;
    std::int32_t index = 0;
    const bool sound = Robot::check_config(config_, index) == 0;
    const typename Robot::Config& used = sound ? config_ : defaults_;
    for (int i = 0; i < n; ++i) {
      const double tau = output_.tau[i], before = last.tau[i];
      demand(std::isfinite(tau), "the torque is finite");
      demand(std::isfinite(current_of(output_, i, 0)), "the current is finite");
      demand(std::fabs(tau) <= used.torque[i], "the torque is within its limit");
      // Where the limit itself has come down the torque comes with it.
      const double from = std::fmin(std::fmax(before, -used.torque[i]), used.torque[i]);
      const double most = used.torque_rate[i] * used.period;
      demand(!stepped_ || std::fabs(tau - from) <= most * (1 + 1e-6) + 1e-6 * used.torque[i],
             "the torque changes no faster than its rate");
    }
    demand(output_.mode >= 0 && output_.mode <= kFaulted, "the mode is one");
    demand((output_.mode == kFaulted) == (output_.faults != 0), "faults are the mode faulted's");
    demand((output_.reason != 0) == (output_.faults != 0), "faults have a reason");
    const bool reset = input_.command.kind == kReset && output_.refused == 0 &&
                       input_.command.sequence != sequence_;
    sequence_ = input_.command.sequence;
    demand(reset || (output_.faults & last.faults) == last.faults, "no fault is lost");
    demand(reset || output_.brakes != 0 || last.brakes == 0, "brakes stay closed until a reset");
    demand(measured() || (output_.faults & kMeasurement) != 0, "what is not finite is a fault");
    demand(sound || (output_.faults & kConfig) != 0, "a config that is not sound is a fault");
    demand((output_.faults & kUntrusted) == 0 || output_.brakes != 0, "brakes are called for");
    demand(output_.refused >= 0 && output_.refused <= 9, "a refusal has a reason");
    demand(output_.factor >= 0 && output_.factor <= 1, "the factor is a share");
  }

  typename Robot::Config config_{}, defaults_{};
  typename Robot::State state_{};
  typename Robot::Input input_{};
  typename Robot::Output output_{};
  double q_[n] = {}, qd_[n] = {};
  std::uint32_t sequence_ = 0;
  bool stepped_ = false;
};

template <class Robot>
void run(Bytes& bytes) {
  Run<Robot> robot;
  for (int k = 0; k < 600 && !bytes.used_up(); ++k) robot.step(bytes);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, size);
  if (bytes.byte() % 2 == 0) {
    run<puma_arm::Controller>(bytes);
  } else {
    run<gantry::Controller>(bytes);
  }
  return 0;
}
