#pragma once

#include "program/program.hpp"

namespace treeline {

/// A number that is not there: operations with it are counted, whatever their operands are.
struct Counted {
  Counted() = default;
  explicit Counted(double /*value*/) {}

  static OperationCount& total() {
    static thread_local OperationCount count;
    return count;
  }

  Counted operator-() const { return {}; }
  friend Counted operator+(const Counted& /*a*/, const Counted& /*b*/) {
    ++total().add;
    return {};
  }
  friend Counted operator-(const Counted& /*a*/, const Counted& /*b*/) {
    ++total().add;
    return {};
  }
  friend Counted operator*(const Counted& /*a*/, const Counted& /*b*/) {
    ++total().mul;
    return {};
  }
  friend Counted operator/(const Counted& /*a*/, const Counted& /*b*/) {
    ++total().div;
    return {};
  }
  friend void sin_cos(const Counted& /*angle*/, Counted& /*sine*/, Counted& /*cosine*/) {
    ++total().sin_cos;
  }
};

/// The operations of this thread since the object was made.
class CountedOperations {
 public:
  CountedOperations() : before_(Counted::total()) {}
  [[nodiscard]] OperationCount since() const {
    const OperationCount& now = Counted::total();
    return {now.add - before_.add, now.mul - before_.mul, now.div - before_.div,
            now.sin_cos - before_.sin_cos};
  }

 private:
  OperationCount before_;
};

}  // namespace treeline
