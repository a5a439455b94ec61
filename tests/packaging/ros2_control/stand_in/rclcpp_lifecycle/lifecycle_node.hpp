// Stands in for rclcpp_lifecycle: a node that the test asks for what was subscribed and served.
#pragma once

#include <any>
#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <rclcpp/rclcpp.hpp>
#include <string>

namespace rclcpp_lifecycle {

class State {};

namespace node_interfaces {
struct LifecycleNodeInterface {
  enum class CallbackReturn : std::uint8_t { SUCCESS = 97, FAILURE = 98, ERROR = 99 };
};
}  // namespace node_interfaces

class LifecycleNode {
 public:
  template <class Message>
  struct Subscription : rclcpp::SubscriptionBase {
    std::function<void(const Message&)> receive;
  };
  template <class Type>
  struct Service : rclcpp::ServiceBase {
    std::function<void(std::shared_ptr<typename Type::Request>,
                       std::shared_ptr<typename Type::Response>)>
        serve;
  };
  struct Timer : rclcpp::TimerBase {
    std::function<void()> elapse;
    void execute() override { elapse(); }
  };

  rclcpp::Logger get_logger() const { return {}; }

  template <class Message, class Callback>
  std::shared_ptr<Subscription<Message>> create_subscription(const std::string& topic, int,
                                                             Callback callback) {
    auto made = std::make_shared<Subscription<Message>>();
    made->receive = std::move(callback);
    subscriptions[topic] = made;
    return made;
  }
  template <class Type, class Callback>
  std::shared_ptr<Service<Type>> create_service(const std::string& name, Callback callback) {
    auto made = std::make_shared<Service<Type>>();
    made->serve = std::move(callback);
    services[name] = made;
    return made;
  }
  template <class Callback>
  std::shared_ptr<Timer> create_wall_timer(std::chrono::milliseconds, Callback callback) {
    auto made = std::make_shared<Timer>();
    made->elapse = std::move(callback);
    timer = made;
    return made;
  }

  template <class Message>
  void publish(const std::string& topic, const Message& message) {
    dynamic_cast<Subscription<Message>&>(*subscriptions.at(topic)).receive(message);
  }
  template <class Type>
  bool call(const std::string& name) {
    auto response = std::make_shared<typename Type::Response>();
    dynamic_cast<Service<Type>&>(*services.at(name))
        .serve(std::make_shared<typename Type::Request>(), response);
    return response->success;
  }

  std::map<std::string, rclcpp::SubscriptionBase::SharedPtr> subscriptions;
  std::map<std::string, rclcpp::ServiceBase::SharedPtr> services;
  rclcpp::TimerBase::SharedPtr timer;
  std::map<std::string, std::any> overrides;  ///< of parameters
};

}  // namespace rclcpp_lifecycle
