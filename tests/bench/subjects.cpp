#include <algorithm>
#include <iterator>

#include "generated_subjects.hpp"
#include "peers.hpp"

namespace treeline::bench {

namespace {

/// Keeps the functions that are generated, and M^-1, which is not generated but belongs to the
/// derivatives.
void keep_what_is_measured(std::vector<Subject>& subjects) {
  auto wanted = subjects.front().routines;
  if (wanted.contains(Function::forward_dynamics_derivatives)) {
    wanted[Function::mass_matrix_inverse] = {};
  }
  for (Subject& subject : subjects) {
    std::erase_if(subject.routines, [&](const auto& each) { return !wanted.contains(each.first); });
  }
}

}  // namespace

std::vector<Subject> all_subjects(const Case& robot) {
  std::vector<Subject> subjects = generated_subjects(robot.robot);
  subjects.push_back(interpreter_subject(robot));
  std::ranges::move(peer_subjects(robot), std::back_inserter(subjects));
  keep_what_is_measured(subjects);
  return subjects;
}

}  // namespace treeline::bench
