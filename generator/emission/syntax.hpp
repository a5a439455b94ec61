#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "program/expression.hpp"

namespace treeline {

/// Operations within others that stand in parentheses: where the language needs them, products in
/// sums as well, or all.
enum class Parentheses { needed, products, all };

/// How a language writes what stands in the body of a function: numbers, expressions, statements.
struct Syntax {
  std::string number;        ///< type of a local number: `Real`
  std::string prefix;        ///< of names at file scope; empty where namespaces keep robots apart
  std::string_view comment;  ///< what a comment begins with: `//`
  Parentheses parentheses = Parentheses::needed;
  /// Whether constants of the robot are locals with names. Where `number` is a vector of states, a
  /// constant is none.
  bool names_constants = true;

  /// A number without its sign.
  std::string (*literal)(double value);
  /// Sign between the two operands of an operation, or before its only one.
  std::string_view (*sign)(Op op);
  /// A value of the type that is named once and stays: `const Real x = value;`.
  std::string (*keep)(const std::string& type, const std::string& name, const std::string& value);
  /// An element of a result: `y[2] = value;`.
  std::string (*store)(const Syntax& own, const std::string& target, const std::string& value);
  /// A number that is read from an array, where reading it takes more than its name.
  std::string (*read)(const std::string& element);

  /// The type of so many lanes.
  std::string (*lanes)(const Syntax& own, std::size_t count);
  /// Lanes of the numbers in `list`, which has commas between.
  std::string (*make_lanes)(const Syntax& own, std::size_t count, const std::string& list);
  /// One lane of a value that has so many.
  std::string (*lane)(const Syntax& own, std::size_t count, const std::string& value,
                      std::size_t index);
  /// An operation on lanes where the language has no operators for them; null where it has. `b` is
  /// empty for an operation on one operand.
  std::string (*combine_lanes)(const Syntax& own, std::size_t count, Op op, const std::string& a,
                               const std::string& b) = nullptr;
  /// One number in all lanes, as an operand of `combine_lanes`.
  std::string (*spread)(const Syntax& own, std::size_t count, const std::string& number) = nullptr;

  /// Statements that declare the arrays anglesSUFFIX, sinesSUFFIX and cosinesSUFFIX, which hold
  /// `count` numbers, fill the first with `list` and the others by a call.
  std::vector<std::string> (*take_sines)(const Syntax& own, const std::string& suffix,
                                         std::size_t count, const std::string& list);
  std::string sin_cos;  ///< the function that it calls
};

}  // namespace treeline
