#include "oracle/law_at.hpp"

namespace treeline {
namespace {

using interpreter::Digits50;

interpreter::Matrix3<Digits50> matrix_of(const LawAxes& rows) {
  interpreter::Matrix3<Digits50> R;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      R(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = rows[i][j];
    }
  }
  return R;
}

}  // namespace

interpreter::TaskLaw<Digits50> law_at(const TaskLaw* law, const std::vector<double>& q,
                                      const GivenTools& tools) {
  interpreter::TaskLaw<Digits50> result;
  if (law == nullptr) return result;
  result.power = law->rule.power;
  result.borders.assign(law->rule.borders.begin(), law->rule.borders.end());
  for (const LawFrame& frame : law_frames(*law, q, tools)) {
    result.frames.push_back({matrix_of(frame.linear),
                             matrix_of(frame.angular),
                             {frame.shift[0], frame.shift[1], frame.shift[2]}});
  }
  for (std::size_t k = 0; k < law->pivots.size(); ++k) {
    const int first = law->kind == TaskLaw::Kind::jacobian && k >= 3 ? 3 : 0;
    result.pivots.emplace_back(first + static_cast<int>(law->pivots[k].row),
                               first + static_cast<int>(law->pivots[k].column));
  }
  return result;
}

std::shared_ptr<const TaskLaw> law_of_sizes(const std::shared_ptr<const TaskLaw>& law) {
  if (!law || law->kind != TaskLaw::Kind::jacobian) return law;
  return TaskLaws(*law->mechanism).find(TaskLaw::Kind::inverse_inertia, law->points, {});
}

}  // namespace treeline
