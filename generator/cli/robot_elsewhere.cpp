#include "cli/robot_elsewhere.hpp"

#include <fmt/format.h>

#include <atomic>

#include "cli/find_bent_start.hpp"
#include "cli/find_start.hpp"
#include "cli/loop_handle.hpp"
#include "cli/write_output.hpp"
#include "interruption/clean_up.hpp"
#include "text/printable.hpp"

namespace treeline {
namespace {

std::atomic<bool> asked_to_rest{false};

/// Closes the loops near `start`; empty, with an error, where that is not possible.
std::vector<double> closed(const LaunchedRobot& robot, std::vector<double> start,
                           Diagnostics& diagnostics) {
  constexpr double kClosed = 1e-6;  // m or rad
  const double error = robot.library.functions().close_loops(start.data());
  if (error <= kClosed) return start;
  diagnostics.add(
      {Severity::error, "", 0, "--q",
       fmt::format("the loops cannot be closed near this place: {:.2g} m or rad are left", error),
       "Give --q with coordinates at which they nearly are."});
  return {};
}

/// Where all joints are at 0, or as near as the robot can hold its weight and move its points.
std::vector<double> choose_start(const LaunchedRobot& robot) {
  const drive::RobotLibrary& library = robot.library.functions();
  std::vector<double> start = default_start(robot.description);
  if (const auto better = find_holdable_start(library, robot.description, start)) {
    print_message(
        "with all joints at 0 the robot cannot hold its weight: it starts elsewhere; --q "
        "chooses the place\n");
    start = *better;
  }
  if (const auto better = find_bent_start(library, robot.description, start)) {
    print_message(
        "with its joints near 0 the robot cannot move its points in every direction: it "
        "starts bent; --q chooses the place\n");
    start = *better;
  }
  return start;
}

}  // namespace

bool has_as_many(const drive::RobotDescription& robot, const std::vector<double>& given,
                 Diagnostics& diagnostics) {
  const std::size_t size = robot.coordinates.size();
  if (given.empty() || given.size() == size) return true;
  diagnostics.add({Severity::error, "", 0, "--q",
                   fmt::format("{} numbers are given, the robot has {}", given.size(), size),
                   "`treeline inspect` lists the joints in their order."});
  return false;
}

std::vector<double> start_of(const LaunchedRobot& robot, const std::vector<double>& given,
                             Diagnostics& diagnostics) {
  if (!has_as_many(robot.description, given, diagnostics)) return {};
  return closed(robot, given.empty() ? choose_start(robot) : given, diagnostics);
}

std::unique_ptr<drive::UdpRobot> find_robot(const LaunchedRobot& robot, const std::string& address,
                                            Diagnostics& diagnostics) {
  constexpr double kPatience = 5;  // s
  std::string error;
  auto found = drive::UdpRobot::open(address, robot.description.checksum,
                                     static_cast<int>(robot.description.coordinates.size()),
                                     robot.description.velocities, error);
  if (found && found->wait_for_state(kPatience)) return found;
  diagnostics.add({Severity::error, "", 0, "--robot",
                   found ? fmt::format("no robot answers at {} within {} s", address, kPatience)
                         : fmt::format("\"{}\": {}", address, error),
                   "`treeline drive --act-as-robot HOST:PORT`, with the same URDF and scene, is a "
                   "simulated one."});
  return nullptr;
}

bool act_as_robot(const LaunchedRobot& robot, const std::vector<double>& given, double rate,
                  const SimulationNumbers& simulation, const std::string& address,
                  Diagnostics& diagnostics) {
  const std::vector<double> start = start_of(robot, given, diagnostics);
  if (start.empty()) return false;
  const drive::RobotLibrary& library = robot.library.functions();
  const LoopNumbers numbers(robot.description);
  drive::LoopOptions options = options_for(robot.description, numbers, start);
  options.rate = rate;
  options.simulation = simulation.options();
  const std::unique_ptr<void, void (*)(void*)> simulated(library.create_robot(&options),
                                                         library.destroy_robot);
  drive::RobotSide side;
  side.address = address;
  side.checksum = robot.description.checksum;
  side.rate = rate;
  side.nq = library.coordinates;
  side.nv = library.velocities;
  side.advance = [&](const double* tau, double seconds) {
    library.advance_robot(simulated.get(), tau, seconds);
  };
  side.read = [&](double* state) { library.read_robot(simulated.get(), state); };
  asked_to_rest = false;
  answer_signals([] { asked_to_rest = true; });
  print_message("the simulated robot listens at " + printable(address) + "\n");
  const std::string error = drive::run_robot_side(side, asked_to_rest);
  answer_signals(nullptr);
  if (error.empty()) return true;
  diagnostics.add({Severity::error, "", 0, "--act-as-robot",
                   fmt::format("{} cannot be listened on: {}", address, error),
                   "Name an address of this machine as a number, and a free port."});
  return false;
}

}  // namespace treeline
