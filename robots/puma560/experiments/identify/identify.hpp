#pragma once

#include <string>

#include "excite.hpp"
#include "report/plot.hpp"
#include "report/table.hpp"

namespace treeline::experiments {

using Parameters = Eigen::Matrix<double, kColumns, 1>;

/// What the identification of a simulated PUMA 560 with rotors and friction finds.
struct Identification {
  double condition = 0;                   ///< of the exciting motion's rows, columns of unit length
  Parameters truth = Parameters::Zero();  ///< from torques without noise
  double model_error = 0;                 ///< largest torque that `truth` leaves there, N m
  Parameters found = Parameters::Zero();  ///< from noisy torques
  Parameters deviations = Parameters::Zero();  ///< standard deviations of `found`
  JointVector noise = JointVector::Zero();     ///< of the torques, N m, as found
  JointVector held_out_error =
      JointVector::Zero();  ///< root mean square over another motion, N m, against no noise
  JointVector held_out_torque = JointVector::Zero();  ///< root mean square of the torques there
  JointVector urdf_error =
      JointVector::Zero();  ///< the error there of inverse dynamics with rotors, no friction
  report::Table held_out;   ///< t, torques with noise, torques that `found` gives
};

/// Moves the arm by an exciting motion for two periods at 200 Hz, adds noise of 1 % of the joints'
/// torque limits to its torques, and finds the parameters by weighted least squares (Gautier 1997):
/// each joint's rows are weighted with the noise that plain least squares leaves there.
Identification identify();

/// Whether the regressor describes the arm to rounding, the parameters are found within what their
/// standard deviations say, and torques of another motion are predicted far below the noise.
bool identify_claim_holds(const Identification& result);
std::string identify_summary(const Identification& result);
/// The table of the page.
std::string identify_page_table(const Identification& result);
report::Plot identify_figure(const Identification& result);

}  // namespace treeline::experiments
