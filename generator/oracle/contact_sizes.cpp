#include "oracle/contact_sizes.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "oracle/entries.hpp"
#include "oracle/interpret_contacts.hpp"
#include "oracle/term_sizes.hpp"

namespace treeline {
namespace {

/// Copies the subject with these points in place of the operational ones.
Subject<double> seen_at(const Subject<double>& subject, const interpreter::Points<double>& points) {
  Subject<double> seen = subject;
  seen.points = points;
  return seen;
}

/// Appends m^2 |n|^T |Lambda_c^-1| |n|: the change of m = 1 / (n^T Lambda_c^-1 n) due to an error
/// of the denominator. With a cap it is less, and m where that is more.
void append_masses(const Eigen::MatrixXd& Lambda_inverse, const Eigen::VectorXd& normals,
                   const std::vector<double>& masses, std::vector<double>& entries) {
  for (std::size_t i = 0; i < masses.size(); ++i) {
    const auto row = 3 * static_cast<Eigen::Index>(i);
    const Eigen::Vector3d n = normals.segment<3>(row);
    const double of_terms = masses[i] * n.dot(Lambda_inverse.block<3, 3>(row, row) * n);
    entries.push_back(masses[i] * std::max(of_terms, 1.0));
  }
}

/// Appends |J| |M^-1| |J|^T for each frame.
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
                                  const std::vector<double>& result) {
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
      append(terms.poses().head(J.rows()), entries);  // positions precede rotations
      append(J * magnitudes(state.qd), entries);
      break;
    case Function::contact_inverse_inertia:
      append(Lambda_inverse, entries);
      break;
    case Function::effective_mass:
      append_masses(Lambda_inverse, magnitudes(values_of(state, Quantity::normals)), result,
                    entries);
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
