#pragma once

#include <string>
#include <vector>

#include "measure.hpp"
#include "report/plot.hpp"
#include "report/table.hpp"

namespace treeline::stress {

/// A curve over the finding's x, in the panel with this title.
struct Curve {
  std::string panel, name;
  std::vector<double> y;
  bool dashed = false;
};

inline constexpr const char* kDigitsLeft = "decimal digits left";

/// Result of an experiment.
struct Finding {
  std::string name;  ///< of its files
  std::string title;
  std::string x_label;
  std::string y_label = kDigitsLeft;
  std::vector<double> x;
  std::vector<Curve> curves;
  std::vector<std::string> said;    ///< figures for the record
  std::vector<std::string> broken;  ///< claims that do not hold
};

/// A value of x and the losses there.
struct Sample {
  double x = 0;
  std::vector<Loss> losses;
};

/// Makes a finding with the digits that each algorithm keeps over x (dashed: what the condition
/// number alone would leave), and the claim that no algorithm loses more than `allowed` ulp times
/// the condition number.
Finding make_finding(std::string name, std::string title, std::string x_label,
                     const std::vector<Sample>& samples, double allowed);

/// Records `claim` as broken unless it `holds`.
void claim(bool holds, const std::string& claim, Finding& finding);

report::Table table_of(const Finding& finding);
report::Plot plot_of(const Finding& finding);

}  // namespace treeline::stress
