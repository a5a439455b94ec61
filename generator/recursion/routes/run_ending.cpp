#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>

#include "core/emitted_endings.hpp"
#include "recursion/routes/trace_function.hpp"
#include "recursion/tree/counted.hpp"
#include "recursion/tree/plain_expression.hpp"

namespace treeline {
namespace {

/// Arrays that a routine is called with, in the order of its parameters.
template <class Number>
struct Arrays {
  std::vector<const std::int16_t*> places;
  std::vector<std::vector<Number>> constants;
  std::vector<std::vector<Number>> read;
  std::vector<Number> work;
  std::vector<std::vector<Number>> results;
};

template <class Number>
using Call = void (*)(core::EmittedEndings<Number>& routines, Arrays<Number>& of);

template <class Number>
void call_solve_columns(core::EmittedEndings<Number>& routines, Arrays<Number>& of) {
  routines.tl_solve_columns(of.places[0], of.places[1], of.places[2], of.places[3],
                            of.read[0].data(), of.read[1].data(), of.read[2].data(), of.work.data(),
                            of.results[0].data(), of.results[1].data(), of.results[2].data());
}

template <class Number>
void call_mass_matrix(core::EmittedEndings<Number>& routines, Arrays<Number>& of) {
  routines.tl_mass_in_common_frame(of.constants[0].data(), of.constants[1].data(),
                                   of.constants[2].data(), of.places[0], of.places[1], of.places[2],
                                   of.constants[3].data(), of.read[0].data(), of.read[1].data(),
                                   of.work.data(), of.results[0].data());
}

template <class Number>
void call_force_derivatives(core::EmittedEndings<Number>& routines, Arrays<Number>& of) {
  routines.tl_force_derivatives(of.constants[0].data(), of.constants[1].data(),
                                of.constants[2].data(), of.places[0], of.places[1], of.places[2],
                                of.constants[3].data(), of.read[0].data(), of.read[1].data(),
                                of.read[2].data(), of.work.data(), of.results[0].data(),
                                of.results[1].data(), of.results[2].data());
}

template <class Number>
void call_acceleration_derivatives(core::EmittedEndings<Number>& routines, Arrays<Number>& of) {
  routines.tl_acceleration_derivatives(
      of.constants[0].data(), of.constants[1].data(), of.constants[2].data(), of.places[0],
      of.places[1], of.places[2], of.constants[3].data(), of.places[3], of.places[4], of.places[5],
      of.places[6], of.places[7], of.places[8], of.read[0].data(), of.read[1].data(),
      of.read[2].data(), of.work.data(), of.results[0].data(), of.results[1].data(),
      of.results[2].data());
}

template <class Number>
Call<Number> call_of(Routine routine) {
  static constexpr std::pair<Routine, Call<Number>> kCalls[] = {
      {Routine::solve_columns, call_solve_columns<Number>},
      {Routine::mass_matrix, call_mass_matrix<Number>},
      {Routine::force_derivatives, call_force_derivatives<Number>},
      {Routine::acceleration_derivatives, call_acceleration_derivatives<Number>}};
  return std::find_if(std::begin(kCalls), std::end(kCalls),
                      [&](const auto& row) { return row.first == routine; })
      ->second;
}

/// Arrays without those of the lines; results have their size.
template <class Number>
Arrays<Number> make_arrays(const Ending& ending) {
  Arrays<Number> arrays;
  for (const Table& table : ending.tables) {
    if (const auto* places = std::get_if<std::vector<std::int16_t>>(&table.values)) {
      arrays.places.push_back(places->data());
    } else {
      const auto& numbers = std::get<std::vector<double>>(table.values);
      auto& constants = arrays.constants.emplace_back();
      for (const double number : numbers) constants.emplace_back(number);
    }
  }
  arrays.work.resize(ending.work);
  for (const Argument& result : ending.results) {
    arrays.results.emplace_back(static_cast<std::size_t>(result.rows * result.cols));
  }
  return arrays;
}

/// Gives the routine what the lines computed.
template <class Number>
void enter(const Ending& ending, const Result& from, const std::vector<Number>& values,
           Arrays<Number>& arrays) {
  if (is_only_read(ending, from)) {
    arrays.read.push_back(values);
    return;
  }
  for (std::size_t i = 0; i < ending.results.size(); ++i) {
    if (ending.results[i].name == from.argument.name) arrays.results[i] = values;
  }
}

template <class Number>
void run(const Ending& ending, Arrays<Number>& arrays) {
  core::EmittedEndings<Number> routines(ending.velocities, ending.path, ending.floats);
  call_of<Number>(ending.routine)(routines, arrays);
}

void count(Ending& ending) {
  auto arrays = make_arrays<Counted>(ending);
  for (const Result& result : ending.lines.results) {
    enter(ending, result, std::vector<Counted>(result.values.size()), arrays);
  }
  const CountedOperations operations;
  run(ending, arrays);
  ending.executed = operations.since();
}

std::vector<PlainExpression> plain(const std::vector<Expression>& values) {
  std::vector<PlainExpression> result;
  for (const Expression& value : values) result.emplace_back(value);
  return result;
}

}  // namespace

Program end_lines(Ending ending) {
  if (ending.executed.flops() == 0) count(ending);
  Program program = ending.lines;
  program.packs.clear();
  program.results.clear();
  {
    const Graph::Scope scope(program.graph);
    auto arrays = make_arrays<PlainExpression>(ending);
    for (const Result& result : ending.lines.results) {
      enter(ending, result, plain(result.values), arrays);
    }
    run(ending, arrays);
    for (std::size_t i = 0; i < ending.results.size(); ++i) {
      program.results.push_back({ending.results[i], {}});
      for (const PlainExpression& value : arrays.results[i]) {
        program.results.back().values.push_back(value.value());
      }
    }
  }
  program.ending = std::make_shared<const Ending>(std::move(ending));
  return program;
}

}  // namespace treeline
