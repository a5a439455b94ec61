#pragma once

#include <cstddef>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "emission/syntax.hpp"
#include "program/program.hpp"

namespace treeline {

/// The most statements of a function where its length is bounded, constants among them: what the
/// metrics of the Hersteller Initiative Software (HIS) ask.
inline constexpr int kMostStatements = 50;

/// A function that computes a part of another: by its own statements, or by calls of further parts.
struct BodyPart {
  std::string name;                 ///< `gravity_part_3`, `gravity_parts_1_to_50`
  std::string statements;           ///< indented by two blanks; empty where it calls others
  std::vector<std::size_t> calls;   ///< of parts that are listed before it
  std::set<std::string> arguments;  ///< of the function that it reads
  std::set<std::string> results;    ///< of the function that it writes
  bool reads_values = false;        ///< that other parts have computed
  bool writes_values = false;       ///< that other parts read
};

/// The body of a function of bounded length.
struct PartedBody {
  std::string statements;           ///< where they are few: then there are no parts
  std::vector<std::string> values;  ///< names of numbers that one part computes and others read
  std::vector<BodyPart> parts;
  std::vector<std::size_t> calls;  ///< of the function itself
};

/// Prints the statements of `print_body` in functions of at most `kMostStatements`. Each constant
/// but 0, 1/2, 1 and 2 has a name. `values` is the prefix of values that parts share, such as
/// `values->`. `taken` are identifiers that a local may not have.
PartedBody print_parts(const Program& program, const Syntax& syntax,
                       const std::set<std::string>& taken, const std::string& values);

/// The list of what the part takes, in the order of the function's arguments, the shared `values`
/// and its results; `print` writes one argument, constant or not.
std::string list_arguments(
    const Program& program, const BodyPart& part, const std::string& values,
    const std::function<std::string(const Argument&, const char* qualifier)>& print);

/// How many numbers the parts of the program share.
std::size_t count_shared_values(const Program& program);

}  // namespace treeline
