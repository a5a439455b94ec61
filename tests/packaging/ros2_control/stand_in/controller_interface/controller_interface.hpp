// Stands in for controller_interface and hardware_interface: of Humble with HUMBLE, else as they
// are since Jazzy.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <rclcpp/rclcpp.hpp>
#include <rclcpp_lifecycle/lifecycle_node.hpp>
#include <string>
#include <utility>
#include <vector>

namespace hardware_interface {

class Handle {
 public:
  Handle(std::string name, double* value) : name_(std::move(name)), value_(value) {}
#ifdef HUMBLE
  const std::string get_name() const {
    return name_;
  }
  double get_value() const {
    return *value_;
  }
  void set_value(double value) {
    *value_ = value;
  }
#else
  const std::string& get_name() const {
    return name_;
  }
  template <typename T = double>
  [[nodiscard]] std::optional<T> get_optional(unsigned int = 10) const {
    return *value_ == kBusy ? std::nullopt : std::optional<T>(*value_);
  }
  template <typename T>
  [[nodiscard]] bool set_value(const T& value, unsigned int = 10) {
    *value_ = value;
    return true;
  }
#endif
  static constexpr double kBusy = 1e300;  ///< somebody else holds the interface

 private:
  std::string name_;
  double* value_;
};

class LoanedStateInterface : public Handle {
 public:
  using Handle::Handle;
  LoanedStateInterface(const LoanedStateInterface&) = delete;
  LoanedStateInterface(LoanedStateInterface&&) = default;
};
class LoanedCommandInterface : public Handle {
 public:
  using Handle::Handle;
  LoanedCommandInterface(const LoanedCommandInterface&) = delete;
  LoanedCommandInterface(LoanedCommandInterface&&) = default;
};

}  // namespace hardware_interface

namespace controller_interface {

using CallbackReturn = rclcpp_lifecycle::node_interfaces::LifecycleNodeInterface::CallbackReturn;
enum class return_type : std::uint8_t { OK = 0, ERROR = 1 };
enum class interface_configuration_type : std::uint8_t { ALL = 0, INDIVIDUAL = 1, NONE = 2 };
struct InterfaceConfiguration {
  interface_configuration_type type;
  std::vector<std::string> names = {};
};

class ControllerInterface {
 public:
  virtual ~ControllerInterface() = default;
  virtual InterfaceConfiguration command_interface_configuration() const = 0;
  virtual InterfaceConfiguration state_interface_configuration() const = 0;
  virtual CallbackReturn on_init() = 0;
  virtual CallbackReturn on_configure(const rclcpp_lifecycle::State&) = 0;
  virtual CallbackReturn on_activate(const rclcpp_lifecycle::State&) = 0;
  virtual CallbackReturn on_deactivate(const rclcpp_lifecycle::State&) = 0;
  virtual return_type update(const rclcpp::Time&, const rclcpp::Duration&) = 0;

  std::shared_ptr<rclcpp_lifecycle::LifecycleNode> get_node() { return node_; }
  std::shared_ptr<const rclcpp_lifecycle::LifecycleNode> get_node() const { return node_; }
  unsigned int get_update_rate() const { return update_rate; }

  void assign_interfaces(std::vector<hardware_interface::LoanedCommandInterface>&& commands,
                         std::vector<hardware_interface::LoanedStateInterface>&& states) {
    command_interfaces_ = std::move(commands);
    state_interfaces_ = std::move(states);
  }
  unsigned int update_rate = 0;

 protected:
  std::vector<hardware_interface::LoanedCommandInterface> command_interfaces_;
  std::vector<hardware_interface::LoanedStateInterface> state_interfaces_;

 private:
  std::shared_ptr<rclcpp_lifecycle::LifecycleNode> node_ =
      std::make_shared<rclcpp_lifecycle::LifecycleNode>();
};

}  // namespace controller_interface
