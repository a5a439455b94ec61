#pragma once

#include <string>
#include <vector>

#include "report/plot.hpp"
#include "report/table.hpp"
#include "tumbler.hpp"

/// Chang chapter 8: the tumbler, flying freely, is struck at each of its links in turn.
namespace treeline::experiments {

/// One blow and the flight after it.
struct StruckLink {
  std::string link;
  double mass = 0;             ///< effective mass along the blow, kg
  double energy = 0;           ///< gained according to the velocities, J
  double work = 0;             ///< gained, y . (v + v') / 2, J
  double momentum_error = 0;   ///< gained momentum minus impulse and moment, N s and N m s
  double flight_momentum = 0;  ///< largest change in the flight that follows, N s and N m s
  double flight_energy = 0;    ///< largest change in the flight that follows, J
  double steps = 0;            ///< steps of the adaptive integrator in flight
  report::Table flight;        ///< time, speed of the struck point, energy, momentum along the blow
};

struct StrikeRun {
  double impulse = 0;  ///< N s
  std::vector<StruckLink> links;
};

StrikeRun run_strikes(const simulation::Model& model, double impulse, double flight);

std::string strike_summary(const StrikeRun& run);
std::string strike_csv(const StrikeRun& run);
report::Plot strike_figure(const StrikeRun& run);
bool strike_claims_hold(const StrikeRun& run);

}  // namespace treeline::experiments
