#include "oracle/contact_sizes.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "interpreter/instances.hpp"
#include "oracle/entries.hpp"
#include "oracle/interpret_contacts.hpp"
#include "oracle/term_sizes.hpp"

namespace treeline {
namespace {

/// The subject with other points in place of the operational ones.
Subject<double> seen_at(const Subject<double>& subject, const interpreter::Points<double>& points) {
  Subject<double> seen = subject;
  seen.points = points;
  return seen;
}

/// The largest effective masses that there are next to the state: each itself, but where it yields
/// the peak of `bounded_inverse`.
std::vector<double> steepest_masses(const Subject<double>& subject, const State& state,
                                    const interpreter::TaskLaw<double>& law,
                                    std::vector<double> masses) {
  if (law.borders.empty()) return masses;
  const Eigen::VectorXd c = interpreter::mobilities_along<double>(
      subject.model, subject.contacts, vector_of<double>(state.q),
      vector_of<double>(values_of(state, Quantity::normals)));
  const double peak = std::pow(law.power - 1.0, 1.0 / law.power);
  for (std::size_t i = 0; i < masses.size(); ++i) {
    const double at = peak * law.borders[i];
    if (c(static_cast<Eigen::Index>(i)) < at) {
      masses[i] = interpreter::bounded_inverse<double>(at, law.borders[i], law.power);
    }
  }
  return masses;
}

/// m^2 |n|^T |Lambda_c^-1| |n|: what an error of the denominator makes of m = 1 / (n^T .. n).
void append_masses(const Eigen::MatrixXd& Lambda_inverse, const Eigen::VectorXd& normals,
                   const std::vector<double>& masses, std::vector<double>& entries) {
  for (std::size_t i = 0; i < masses.size(); ++i) {
    const auto row = 3 * static_cast<Eigen::Index>(i);
    const Eigen::Vector3d n = normals.segment<3>(row);
    entries.push_back(masses[i] * masses[i] * n.dot(Lambda_inverse.block<3, 3>(row, row) * n));
  }
}

/// |J| |M^-1| |J|^T of each frame.
void append_blocks(const Eigen::MatrixXd& J, const Eigen::MatrixXd& M_inverse,
                   std::vector<double>& entries) {
  for (Eigen::Index row = 0; row < J.rows(); row += 6) {
    const Eigen::MatrixXd own = J.middleRows(row, 6);
    append(own * M_inverse * own.transpose(), entries);
  }
}

}  // namespace

std::vector<double> contact_sizes(Function function, const Subject<double>& subject,
                                  const State& state, const Eigen::MatrixXd& M_inverse,
                                  const std::vector<double>& result,
                                  const interpreter::TaskLaw<double>& law) {
  std::vector<double> entries;
  if (function == Function::link_inverse_inertias) {
    const Subject<double> links = seen_at(subject, link_frames(subject.model));
    append_blocks(TermSizes(links, state.q).jacobian(), M_inverse, entries);
    return entries;
  }
  const Subject<double> contacts = seen_at(subject, subject.contacts);
  const TermSizes terms(contacts, state.q);
  const Eigen::MatrixXd J = terms.jacobian();
  const Eigen::MatrixXd Lambda_inverse = J * M_inverse * J.transpose();
  switch (function) {
    case Function::contact_motion:
      append(terms.poses().head(J.rows()), entries);  // positions come first
      append(J * magnitudes(state.qd), entries);
      break;
    case Function::contact_inverse_inertia:
      append(Lambda_inverse, entries);
      break;
    case Function::effective_mass:
      append_masses(Lambda_inverse, magnitudes(values_of(state, Quantity::normals)),
                    steepest_masses(subject, state, law, result), entries);
      break;
    case Function::impulse_response:
      append(M_inverse * (J.transpose() * magnitudes(values_of(state, Quantity::impulse))),
             entries);
      break;
    default:
      throw std::logic_error(std::string(function_name(function)) + " is not about contacts");
  }
  return entries;
}

}  // namespace treeline
