#pragma once

#include <array>
#include <string>
#include <vector>

#include "carry_plan.hpp"
#include "report/plot.hpp"
#include "report/table.hpp"

namespace treeline::experiments {

/// Who computes the torques of two robots that carry one object.
enum class Law {
  central,    ///< one computer, from the joints of both, by the augmented object (Chang table 7.1)
  decentral,  ///< each robot by itself, see `control_share`
  hybrid      ///< each by itself, but they exchange the forces that their hands feel
};
inline constexpr std::array kLaws = {Law::central, Law::decentral, Law::hybrid};
const char* name_of(Law law);

/// What is not as the laws assume.
struct Trouble {
  const char* name = "none";
  double shift = 0;  ///< error of the second robot's belief where its base is along x, m
  double turn = 0;   ///< and about z, rad
  double delay = 0;  ///< of every message between computers, s
};
/// None; a second base that is 1 mm and 1 mrad off; messages that take 10 ms; both.
extern const std::array<Trouble, 4> kTroubles;

/// Largest errors of a run from half a second on. The object is where it is, not where a robot
/// believes it to be.
struct CooperationErrors {
  double position = 0;  ///< m
  double rotation = 0;  ///< rad
  double tension = 0;   ///< N
  double moments = 0;   ///< N m
};

/// A run: time, position error, tension commanded and acting.
struct Cooperation {
  CooperationErrors errors;
  report::Table table;
};

/// The hybrid law exchanges forces so often, s, and takes this share of what is missing of the
/// commanded internal forces into its commands each time.
inline constexpr double kExchangePeriod = 0.02;
inline constexpr double kExchangeShare = 0.3;

/// Carries the object of `carry_object` by this law. The run ends early if an error exceeds 1 m.
Cooperation cooperate(const CarryPlan& plan, Law law, const Trouble& trouble);

/// All laws in all troubles: by trouble, then by law.
struct Comparison {
  std::vector<std::vector<Cooperation>> runs;
};
Comparison compare_laws(const CarryPlan& plan);

/// Whether the runs show what the page says: equal laws without trouble; with a base that is off,
/// the exchange of forces brings tension within a tenth of what it is without; late messages make
/// the central law's object err ten times as much, and the hybrid law's not.
bool claims_hold(const Comparison& comparison);
std::string summary(const Comparison& comparison);
std::string csv_text(const Comparison& comparison);  ///< the errors, a run a line
report::Plot figure(const Comparison& comparison);

}  // namespace treeline::experiments
