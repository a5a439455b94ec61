#pragma once
// A loop in simulated time, for robots that are written by hand.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "drive/drive_loop.hpp"

namespace treeline::test {

inline constexpr double kNone = std::numeric_limits<double>::infinity();

/// A loop of 1 kHz that runs from its second cycle on. Joints have a common range and no other
/// limits unless `change` sets some.
template <class F>
class Rig {
 public:
  static constexpr drive::ReportLayout kLayout = drive::DriveLoop<F>::kLayout;
  using Change = std::function<void(drive::LoopOptions&)>;

  explicit Rig(std::vector<double> start, const Change& change = {}, double range = kNone)
      : start_(std::move(start)) {
    lower_.fill(-range);
    upper_.fill(range);
    velocity_.fill(kNone);
    torque_.fill(kNone);
    drive::LoopOptions options;
    options.real_time = false;
    options.start = start_.data();
    options.lower = lower_.data();
    options.upper = upper_.data();
    options.velocity = velocity_.data();
    options.torque = torque_.data();
    if (change) change(options);
    loop_ = std::make_unique<drive::DriveLoop<F>>(options);
    run(0.01);
    command(servo::MessageKind::start);
    run(0.01);
  }

  void command(servo::MessageKind kind) {
    servo::Message message;
    message.kind = kind;
    ASSERT_TRUE(loop_->send(message));
  }
  static servo::Message message(drive::Instruction instruction,
                                std::initializer_list<double> values, double duration = 0) {
    servo::Message made = drive::make_message(instruction);
    made.duration = duration;
    std::copy(values.begin(), values.end(), made.values.begin());
    return made;
  }
  void send(drive::Instruction instruction, std::initializer_list<double> values,
            double duration = 0) {
    ASSERT_TRUE(loop_->send(message(instruction, values, duration)));
  }
  void step() {
    loop_->step();
    const std::array<double, kLayout.size> before = numbers_;
    loop_->receive(head_, numbers_.data());
    for (int k = 0; k < F::kVelocities; ++k) {
      step_ = std::max(step_, std::fabs(at(kLayout.tau + k) -
                                        before[static_cast<std::size_t>(kLayout.tau + k)]));
    }
  }
  void run(double seconds) {
    for (int i = 0; i < static_cast<int>(std::lround(1000 * seconds)); ++i) step();
  }
  double at(int i) const { return numbers_[static_cast<std::size_t>(i)]; }
  double q(int i) const { return at(kLayout.q + i); }
  double qd(int i) const { return at(kLayout.qd + i); }
  double tau(int i) const { return at(kLayout.tau + i); }
  const drive::ReportHead& head() const { return head_; }
  /// The largest change of a torque from cycle to cycle since the last call.
  double take_step() { return std::exchange(step_, 0.0); }
  drive::DriveLoop<F>& loop() { return *loop_; }

 private:
  std::vector<double> start_;
  std::array<double, F::kCoordinates> lower_{}, upper_{};
  std::array<double, F::kVelocities> velocity_{}, torque_{};
  std::unique_ptr<drive::DriveLoop<F>> loop_;
  drive::ReportHead head_;
  std::array<double, kLayout.size> numbers_{};
  double step_ = 0.0;
};

}  // namespace treeline::test
