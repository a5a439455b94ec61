#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "bounds/bound_rounding.hpp"
#include "program/evaluate.hpp"
#include "random_mechanism.hpp"

namespace treeline::tests {

/// Searches the inputs for which a program's rounding errors are largest. The errors during the
/// search are those of double compared with long double, which has 11 bits more. Constants are used
/// as they are in the graph, so the result is a lower bound of the largest error.
class HillClimber {
 public:
  using Inputs = std::vector<std::vector<double>>;

  /// Given sines and cosines either belong to angles or, with `Given::in_box`, are any numbers up
  /// to one.
  enum class Given { on_circle, in_box };

  HillClimber(const Program& program, const Domain& domain, std::uint64_t seed,
              Given given = Given::on_circle)
      : program_(program), domain_(domain), rng_(seed), given_(given) {
    std::size_t entries = 0;
    for (const Result& result : program.results) entries += result.values.size();
    worst.assign(entries, 0);
    at.resize(entries);
  }

  /// First increases the magnitude of entry `target` from its worst inputs so far, or from random
  /// ones, because errors grow with it, although irregularly. Then increases the error itself.
  void hill_climb(std::size_t target, int steps) {
    Inputs best = at[target].empty() ? draw() : at[target];
    for (const bool by_size : {true, false}) {
      double height = 0;
      for (int i = 0; i < steps; ++i) {
        Inputs next = i == 0                        ? best
                      : by_size && i < steps / 8    ? draw()
                      : by_size || rng_.chance(0.3) ? change(best)
                                                    : shake(best);
        const Trial trial = try_at(next);
        const double value = by_size ? trial.sizes[target] : trial.errors[target];
        if (value < height) continue;
        height = value;
        best = std::move(next);
      }
    }
  }

  std::vector<double> worst;  ///< of each entry, the largest error seen
  std::vector<Inputs> at;     ///< where

 private:
  const std::vector<double>& sizes(std::size_t argument) const {
    return domain_.sizes.find(program_.arguments[argument].name)->second;
  }

  /// Draws mostly corners of the domain, where values are largest, except for angles.
  double draw_entry(const std::string& argument, double size) {
    if (argument != "q" && rng_.chance(0.7)) return rng_.chance(0.5) ? size : -size;
    return rng_.uniform(-size, size);
  }

  Inputs draw() {
    Inputs inputs;
    for (std::size_t i = 0; i < program_.arguments.size(); ++i) {
      const Argument& argument = program_.arguments[i];
      std::vector<double>& entries = inputs.emplace_back();
      for (int k = 0; k < argument.rows; ++k) {
        entries.push_back(draw_entry(argument.name, sizes(i)[static_cast<std::size_t>(k)]));
      }
    }
    return normalised(std::move(inputs));
  }

  /// Replaces given sines and cosines by those of the nearest angles.
  void put_on_circle(std::vector<double>& sines, std::vector<double>& cosines) const {
    for (std::size_t i = 0; given_ == Given::on_circle && i < sines.size(); ++i) {
      const double angle = std::atan2(sines[i], cosines[i]);
      sines[i] = std::sin(angle);
      cosines[i] = std::cos(angle);
    }
  }

  /// Returns the inputs with quaternions of length 1.
  Inputs normalised(Inputs inputs) const {
    for (std::size_t i = 1; i < inputs.size(); ++i) {
      if (program_.arguments[i].name == "cos_q") put_on_circle(inputs[i - 1], inputs[i]);
    }
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      for (const auto& [quantity, first] : domain_.quaternions) {
        if (program_.arguments[i].name != symbol_of(quantity)) continue;
        double norm = 0;
        for (std::size_t k = first; k < first + 4; ++k) norm = std::hypot(norm, inputs[i][k]);
        for (std::size_t k = first; k < first + 4; ++k) inputs[i][k] /= norm;
      }
    }
    return inputs;
  }

  /// Draws one or two entries anew or changes them slightly, because the last bits determine the
  /// rounding.
  Inputs change(Inputs inputs) {
    const int count = 1 + rng_.below(3);
    for (int i = 0; i < count; ++i) {
      const auto argument = static_cast<std::size_t>(rng_.below(static_cast<int>(inputs.size())));
      const auto k =
          static_cast<std::size_t>(rng_.below(static_cast<int>(inputs[argument].size())));
      const double size = sizes(argument)[k];
      double& entry = inputs[argument][k];
      entry = rng_.chance(0.4) ? draw_entry(program_.arguments[argument].name, size)
                               : entry * (1 + rng_.uniform(-1, 1) * std::pow(10, -rng_.below(9)));
      entry = std::clamp(entry, -size, size);
    }
    return normalised(std::move(inputs));
  }

  /// Moves every entry slightly inward. The roundings change but the sizes hardly do.
  Inputs shake(Inputs inputs) {
    const double most = std::pow(10, -1 - rng_.below(6));
    for (std::vector<double>& entries : inputs) {
      for (double& entry : entries) entry *= 1 - most * rng_.unit();
    }
    return normalised(std::move(inputs));
  }

  /// Errors of all entries.
  struct Trial {
    std::vector<double> errors, sizes;
  };

  Trial try_at(const Inputs& inputs) {
    std::vector<std::vector<long double>> wide;
    for (const auto& entries : inputs) wide.emplace_back(entries.begin(), entries.end());
    const auto rough = evaluate<double>(program_, inputs);
    const auto exact = evaluate<long double>(program_, wide);  // sines of the C library
    Trial trial;
    for (std::size_t i = 0; i < rough.size(); ++i) {
      for (std::size_t k = 0; k < rough[i].size(); ++k) {
        const std::size_t entry = trial.errors.size();
        trial.sizes.push_back(std::abs(rough[i][k]));
        trial.errors.push_back(static_cast<double>(std::abs(rough[i][k] - exact[i][k])));
        if (trial.errors[entry] <= worst[entry]) continue;
        worst[entry] = trial.errors[entry];
        at[entry] = inputs;
      }
    }
    return trial;
  }

  const Program& program_;
  const Domain& domain_;
  Rng rng_;
  Given given_;
};

}  // namespace treeline::tests
