#include "driving/simulation_options.hpp"

#include <fmt/format.h>

#include <cmath>

#include "description/read_number.hpp"
#include "terminal/option_values.hpp"
#include "text/suggest_name.hpp"

namespace treeline {
namespace {

struct Part {
  const char* option;
  std::vector<std::string> SimulationTexts::*text;
  std::vector<double> SimulationNumbers::*numbers;
  const char* help;
  double initial = 0;
};

constexpr Part kParts[] = {
    {"--friction", &SimulationTexts::friction, &SimulationNumbers::friction,
     "Coulomb friction of the drives, N m or N"},
    {"--viscous-friction", &SimulationTexts::viscous, &SimulationNumbers::viscous,
     "Viscous friction of the drives, N m s/rad or N s/m"},
    {"--backlash", &SimulationTexts::backlash, &SimulationNumbers::backlash,
     "Play of the gears, rad or m; encoders are then at the motors; needs --rotor"},
    {"--rotor", &SimulationTexts::rotor, &SimulationNumbers::rotor,
     "Inertia of the rotors behind gears with play, seen from the joint, kg m^2 or kg"},
    {"--gear-stiffness", &SimulationTexts::gear_stiffness, &SimulationNumbers::gear_stiffness,
     "Of the teeth of gears with play, N m/rad or N/m; 10000 unless given", 1e4},
    {"--sensor-noise", &SimulationTexts::noise, &SimulationNumbers::noise,
     "Standard deviation of measured positions, rad or m"},
    {"--quantisation", &SimulationTexts::quantisation, &SimulationNumbers::quantisation,
     "Step of measured positions, rad or m"}};

/// Reads one part of a list: NUMBER or JOINT=NUMBER.
class PartReader {
 public:
  PartReader(const Part& part, const drive::RobotDescription& robot, Diagnostics& diagnostics)
      : part_(part), robot_(robot), diagnostics_(diagnostics) {
    for (const drive::DrivenCoordinate& coordinate : robot.coordinates) {
      if (drive::is_single(coordinate)) names_.push_back(coordinate.name);
    }
  }

  void read(const std::string& given, std::vector<double>& numbers) const {
    const std::size_t equals = given.find('=');
    const std::string name = equals == std::string::npos ? "" : given.substr(0, equals);
    const std::string text = equals == std::string::npos ? given : given.substr(equals + 1);
    const auto value = read_number(text);
    if (!value || !std::isfinite(*value) || *value < 0) {
      return refuse(fmt::format("\"{}\" is no number from 0 on", text),
                    "Write a number for all joints, or JOINT=NUMBER, separated by commas.");
    }
    bool known = name.empty();
    for (const drive::DrivenCoordinate& coordinate : robot_.coordinates) {
      if (!drive::is_single(coordinate) || !(name.empty() || name == coordinate.name)) continue;
      numbers[static_cast<std::size_t>(coordinate.velocity_index)] = *value;
      known = true;
    }
    if (!known) {
      refuse(fmt::format("the robot has no joint \"{}\"", name),
             suggest_name(name, names_, "the joints are"));
    }
  }

 private:
  void refuse(std::string fault, std::string remedy) const {
    diagnostics_.add({Severity::error, "", 0, part_.option, std::move(fault), std::move(remedy)});
  }

  const Part& part_;
  const drive::RobotDescription& robot_;
  Diagnostics& diagnostics_;
  std::vector<std::string> names_;
};

void check_rotors(const SimulationNumbers& numbers, const drive::RobotDescription& robot,
                  Diagnostics& diagnostics) {
  for (const drive::DrivenCoordinate& coordinate : robot.coordinates) {
    if (!drive::is_single(coordinate)) continue;
    const auto v = static_cast<std::size_t>(coordinate.velocity_index);
    if (!(numbers.backlash[v] > 0)) continue;
    const bool has_rotor = numbers.rotor[v] > 0;
    if (has_rotor && numbers.gear_stiffness[v] > 0) continue;
    diagnostics.add({Severity::error, "", 0, "--backlash",
                     fmt::format("the gear of {} has play, but its {}", coordinate.name,
                                 has_rotor ? "teeth do not push" : "rotor has no inertia"),
                     fmt::format("Give --{} {}={}, seen from the joint's side.",
                                 has_rotor ? "gear-stiffness" : "rotor", coordinate.name,
                                 has_rotor ? "STIFFNESS" : "INERTIA")});
    return;
  }
}

}  // namespace

std::string SimulationTexts::first_given() const {
  for (const Part& part : kParts) {
    if (!(this->*part.text).empty()) return part.option;
  }
  return delay > 0 ? "--delay" : "";
}

void add_simulation_options(CLI::App& command, SimulationTexts& texts) {
  const char* const kGroup = "The simulated robot (NUMBER for all joints, or JOINT=NUMBER,...)";
  for (const Part& part : kParts) {
    command.add_option(part.option, texts.*part.text, part.help)->delimiter(',')->group(kGroup);
  }
  command.add_option("--delay", texts.delay, "From a command to its effect, s; whole cycles")
      ->check(between(0, 1))
      ->capture_default_str()
      ->group(kGroup);
}

drive::SimulationOptions SimulationNumbers::options() const {
  drive::SimulationOptions options;
  options.coulomb = friction.data();
  options.viscous = viscous.data();
  options.play = backlash.data();
  options.rotor = rotor.data();
  options.gear_stiffness = gear_stiffness.data();
  options.noise = noise.data();
  options.quantum = quantisation.data();
  options.delay = delay;
  return options;
}

std::optional<SimulationNumbers> read_simulation(const SimulationTexts& texts,
                                                 const drive::RobotDescription& robot, double rate,
                                                 Diagnostics& diagnostics) {
  SimulationNumbers numbers;
  for (const Part& part : kParts) {
    const PartReader reader(part, robot, diagnostics);
    auto& list = numbers.*part.numbers;
    list.resize(static_cast<std::size_t>(robot.velocities), part.initial);
    for (const std::string& given : texts.*part.text) reader.read(given, list);
  }
  if (robot.on_ground && !texts.backlash.empty()) {
    diagnostics.add({Severity::error, "", 0, "--backlash", "on a ground gears have no play",
                     "Leave it out, or the ground."});
  }
  const double cycles = std::round(texts.delay * rate);
  if (cycles > drive::kLongestDelay) {
    diagnostics.add(
        {Severity::error, "", 0, "--delay",
         fmt::format("{:.0f} cycles are more than {}", cycles, drive::kLongestDelay),
         fmt::format("Give at most {:.4g} s at this --rate.", drive::kLongestDelay / rate)});
  }
  numbers.delay = static_cast<int>(cycles);
  check_rotors(numbers, robot, diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  return numbers;
}

}  // namespace treeline
