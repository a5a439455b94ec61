#include <iterator>

#include "generated_subjects.hpp"
#include "peers.hpp"

namespace treeline::bench {

std::vector<Subject> all_subjects(const Case& robot) {
  std::vector<Subject> subjects = generated_subjects(robot.robot);
  subjects.push_back(interpreter_subject(robot));
  const auto append = [&](std::vector<Subject> more) {
    std::move(more.begin(), more.end(), std::back_inserter(subjects));
  };
#ifdef TREELINE_BENCH_KDL
  append(kdl_subjects(robot));
#endif
#ifdef TREELINE_BENCH_DART
  append(dart_subjects(robot));
#endif
  return subjects;
}

}  // namespace treeline::bench
