#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "interpreter/digits50.hpp"
#include "interpreter/task_law.hpp"
#include "oracle/draw_state.hpp"
#include "oracle/subject.hpp"
#include "recursion/methods/task_law.hpp"

namespace treeline {

/// A subject with the gravity, payloads, inertial parameters, tools and contacts of a state. If
/// the state has none of them, it is the given subject, which must live as long; else it is a
/// copy.
template <class Scalar>
class SubjectAt {
 public:
  SubjectAt(const Subject<Scalar>& subject, const State& state);

  const Subject<Scalar>& operator*() const { return changed_ ? *changed_ : *given_; }

 private:
  const Subject<Scalar>* given_;
  std::optional<Subject<Scalar>> changed_;
};

extern template class SubjectAt<float>;
extern template class SubjectAt<double>;
extern template class SubjectAt<Digits50>;

/// Task law of a generated function in the interpreter's types, with the axes that it has at `q`
/// and with the operational points where arguments have them. If `law` is null, no row is relaxed.
interpreter::TaskLaw<interpreter::Digits50> law_at(const TaskLaw* law, const std::vector<double>& q,
                                                   const GivenTools& tools = {});

/// Task law for finding the sizes of a function's results. Scales of forces follow from Lambda, so
/// a law on the Jacobian is replaced by the one on Lambda^-1. Null if `law` is.
std::shared_ptr<const TaskLaw> law_of_sizes(const std::shared_ptr<const TaskLaw>& law);

}  // namespace treeline
