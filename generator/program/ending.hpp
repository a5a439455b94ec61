#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "program/program.hpp"

namespace treeline {

/// What a function may call behind its straight lines, a row of `list_routines` each.
enum class Routine { solve_columns, mass_matrix, force_derivatives, acceleration_derivatives };

/// Constants that a routine reads: places in arrays, or numbers.
struct Table {
  std::string name;
  std::variant<std::vector<std::int16_t>, std::vector<double>> values;
};

/// How a function is emitted that ends with a routine of `runtime/emitted`: straight lines, then
/// the call. The program's graph has the operations of both.
struct Ending {
  Routine routine{};
  /// The straight lines. Their results are arrays that the routine reads, and results of the
  /// function that it changes.
  Program lines;
  std::vector<Argument> results;  ///< of the function
  std::vector<Table> tables;      ///< in the order of the routine's parameters
  int velocities = 0;
  bool floats = false;      ///< whether the first six are those of a floating base
  int path = 8;             ///< length of rows that have what carries a freedom, and itself
  std::size_t work = 0;     ///< numbers of the work space, which some have in their arrays
  OperationCount executed;  ///< by the routine, with zeros too
};

/// Whether an array of the lines is read by the routine alone: it is no result of the function.
bool is_only_read(const Ending& ending, const Result& array);

/// What is printed as straight lines of a program: itself, or what stands before its ending.
const Program& printed_lines(const Program& program);

}  // namespace treeline
