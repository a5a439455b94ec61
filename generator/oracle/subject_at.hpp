#pragma once

#include <optional>

#include "oracle/draw_state.hpp"
#include "oracle/subject.hpp"

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

}  // namespace treeline
