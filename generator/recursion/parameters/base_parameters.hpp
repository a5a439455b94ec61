#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <vector>

#include "recursion/parameters/model_parameter.hpp"

namespace treeline {

/// A linear combination of parameters: coefficients by index into a list of them.
using Combination = std::map<std::size_t, Digits50>;

/// A combination of parameters that the motion can tell from all others. Its column of a regressor
/// is that of the parameter that it is named after, whose coefficient is one.
struct BaseParameter {
  std::size_t parameter = 0;  ///< index into `BaseParameters::parameters`
  Combination combination;
};

/// The base inertial parameters of a robot (Gautier & Khalil 1990; Mayeda, Yoshida & Osuka 1990).
struct BaseParameters {
  std::vector<ModelParameter> parameters;   ///< all, of all links that move
  std::vector<BaseParameter> base;          ///< in the order of the parameters
  std::vector<std::size_t> without_effect;  ///< parameters on which no motion depends
};

/// Finds the combinations of parameters on which joint forces depend, for any tree, from its
/// structure: what a joint does not make felt of a link's inertia (`felt_motions`) adds to the link
/// before it, and at the base it is lost. `asked` says whether rotors and friction count; its links
/// do not matter, since what is lost on one adds to others. With gravity as an argument it may have
/// any direction.
///
/// Friction of joints that share a velocity adds up where it has the same shape: all that is
/// viscous, and Coulomb friction of the same width.
///
/// Where joints mimic others, the links that they share coordinates with may depend on each other
/// in further ways, such as two fingers that always move alike. These dependencies are decided by
/// the energies of these links in 50 digits at more states than there are parameters: energies are
/// analytic, so what vanishes at all of them vanishes everywhere but for a set of states of measure
/// zero.
BaseParameters find_base_parameters(const Mechanism& mechanism, const SceneRegressor& asked);

/// Base parameters for `Mechanism::regressor`, found once for a mechanism and all its copies:
/// reductions do not change them.
std::shared_ptr<const BaseParameters> base_parameters_of(const Mechanism& mechanism);

/// Value of a parameter according to the files. Not for payloads, which no file has.
Digits50 value_in_files(const ModelParameter& parameter, const Mechanism& mechanism);
/// Value of a base parameter according to the files: the sum of its combination.
Digits50 value_in_files(const BaseParameter& base, const BaseParameters& found,
                        const Mechanism& mechanism);

/// `link2 Izz + 0.0225 link3 m - link3 Ixx`: of the parameter that it is named after first.
std::string describe(const BaseParameter& base, const BaseParameters& found);

}  // namespace treeline
