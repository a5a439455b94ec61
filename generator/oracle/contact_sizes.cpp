#include <algorithm>
#include <array>

#include "functions/function_table.hpp"
#include "oracle/entries.hpp"
#include "oracle/group_sizes.hpp"
#include "oracle/interpret.hpp"
#include "oracle/term_sizes.hpp"

namespace treeline {
namespace {

/// Copies the subject with these points in place of the operational ones.
Subject<double> seen_at(const Subject<double>& subject, const interpreter::Points<double>& points) {
  Subject<double> seen = subject;
  seen.points = points;
  return seen;
}

/// A subject at one state, with magnitudes of M^-1 and the function's result.
struct ContactTerms {
  const Subject<double>& subject;
  const State& state;
  const Eigen::MatrixXd& M_inverse;
  const std::vector<double>& result;
  Subject<double> seen = seen_at(subject, subject.contacts);
  TermSizes terms{seen, state.q};
  Eigen::MatrixXd J = terms.jacobian();

  [[nodiscard]] Eigen::MatrixXd lambda_inverse() const { return J * M_inverse * J.transpose(); }
};

std::vector<double> size_motion(const ContactTerms& of) {
  std::vector<double> entries =
      entries_of(of.terms.poses().head(of.J.rows()));  // positions precede rotations
  append(of.J * magnitudes(of.state.qd), entries);
  return entries;
}

/// Returns m^2 |n|^T |Lambda_c^-1| |n|: the change of m = 1 / (n^T Lambda_c^-1 n) due to an error
/// of the denominator. With a cap it is less, and m where that is more.
std::vector<double> size_masses(const ContactTerms& of) {
  const Eigen::MatrixXd Lambda_inverse = of.lambda_inverse();
  const Eigen::VectorXd normals = magnitudes(values_of(of.state, Quantity::normals));
  std::vector<double> entries;
  for (std::size_t i = 0; i < of.result.size(); ++i) {
    const auto row = 3 * static_cast<Eigen::Index>(i);
    const Eigen::Vector3d n = normals.segment<3>(row);
    const double of_terms = of.result[i] * n.dot(Lambda_inverse.block<3, 3>(row, row) * n);
    entries.push_back(of.result[i] * std::max(of_terms, 1.0));
  }
  return entries;
}

std::vector<double> size_impulse_response(const ContactTerms& of) {
  const Eigen::VectorXd impulse = magnitudes(values_of(of.state, Quantity::impulse));
  return entries_of(of.M_inverse * (of.J.transpose() * impulse));
}

/// Returns |J| |M^-1| |J|^T for each link's frame.
std::vector<double> size_links(const ContactTerms& of) {
  const Subject<double> links = seen_at(of.subject, link_frames(of.subject.model));
  const Eigen::MatrixXd J = TermSizes(links, of.state.q).jacobian();
  std::vector<double> entries;
  for (Eigen::Index row = 0; row < J.rows(); row += 6) {
    const Eigen::MatrixXd own = J.middleRows(row, 6);
    append(own * of.M_inverse * own.transpose(), entries);
  }
  return entries;
}

struct ContactSizes {
  Function function;
  std::vector<double> (*sizes)(const ContactTerms& of);
};

constexpr auto kContactSizes = std::to_array<ContactSizes>({
    {Function::contact_motion, size_motion},
    {Function::contact_inverse_inertia,
     [](const ContactTerms& of) { return entries_of(of.lambda_inverse()); }},
    {Function::effective_mass, size_masses},
    {Function::impulse_response, size_impulse_response},
    {Function::link_inverse_inertias, size_links},
});
static_assert(covers<is_about<FunctionGroup::contacts, FunctionGroup::links>>(kContactSizes));

}  // namespace

std::vector<double> contact_sizes(Function function, const Subject<double>& subject,
                                  const State& state, const Eigen::MatrixXd& M_inverse,
                                  const std::vector<double>& result) {
  return find_row(kContactSizes, function)->sizes({subject, state, M_inverse, result});
}

}  // namespace treeline
