// Stands in for rclcpp: what a generated controller calls of it, and no more.
#pragma once

#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace rclcpp {

class Time {};

class Duration {
 public:
  explicit Duration(double seconds) : seconds_(seconds) {}
  double seconds() const { return seconds_; }

 private:
  double seconds_;
};

/// Lines that were logged.
inline std::vector<std::string>& logged() {
  static std::vector<std::string> lines;
  return lines;
}

class Logger {
 public:
  template <class... Arguments>
  void log(const char* format, Arguments... arguments) const {
    char line[512];
    std::snprintf(line, sizeof line, format, arguments...);
    logged().emplace_back(line);
  }
};

struct SubscriptionBase {
  using SharedPtr = std::shared_ptr<SubscriptionBase>;
  virtual ~SubscriptionBase() = default;
};
struct ServiceBase {
  using SharedPtr = std::shared_ptr<ServiceBase>;
  virtual ~ServiceBase() = default;
};
struct TimerBase {
  using SharedPtr = std::shared_ptr<TimerBase>;
  virtual ~TimerBase() = default;
  virtual void execute() = 0;
};

}  // namespace rclcpp

#define RCLCPP_ERROR(logger, ...) (logger).log(__VA_ARGS__)
#define RCLCPP_INFO(logger, ...) (logger).log(__VA_ARGS__)
