#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "case.hpp"
#include "facts.hpp"
#include "limits.hpp"
#include "measure.hpp"
#include "subject.hpp"
#include "times.hpp"

namespace treeline::bench {

struct Measured {
  Case robot;
  std::vector<Subject> subjects;
};

/// Measurements of one function of one implementation.
struct Row {
  const Measured* measured = nullptr;
  const Subject* subject = nullptr;
  Function function{};
  std::array<std::optional<double>, 4> median, least;  ///< nanoseconds per state, by Mode
  Facts facts;                                         ///< zeros if it was not generated
  long instructions = 0;  ///< per call, in the variant where they are counted; otherwise 0
  double flops_a_cycle = 0, code_a_cycle = 0;

  [[nodiscard]] const std::optional<double>& time(Mode mode, bool shortest) const {
    return (shortest ? least : median)[static_cast<std::size_t>(mode)];
  }
};

/// Collects the rows in the order of the table: by robot, function, implementation. Only what was
/// timed has a row. `counts` are instructions by "robot/function".
std::vector<Row> collect_rows(const std::vector<Measured>& robots, const AllTimes& times,
                              const std::map<std::string, long>& counts, const Limits& limits);

}  // namespace treeline::bench
