#include "recursion/routes/solve_for_columns.hpp"

#include <map>
#include <memory>
#include <utility>

#include "core/emitted_columns.hpp"
#include "recursion/tree/counted.hpp"
#include "recursion/tree/plain_expression.hpp"

namespace treeline {
namespace {

/// Arrays by name, those of the lines and the results.
template <class Number>
using Arrays = std::map<std::string, std::vector<Number>>;

template <class Number>
void run(const ColumnSolve& columns, Arrays<Number>& arrays) {
  using Solve = core::EmittedColumns<Number>;
  for (const Argument& result : columns.results) {
    arrays[result.name].resize(static_cast<std::size_t>(result.rows * result.cols));
  }
  const auto array = [&](const std::string& name) { return arrays.at(name).data(); };
  const auto sums = [](const RowSums& from) {
    return typename Solve::TlRowSums{from.ends.data(), from.entries.data()};
  };
  const auto above = sums(columns.above);
  const auto below = sums(columns.below);
  std::vector<Number> rows(columns.count_work());
  Solve(columns.velocities)
      .tl_solve_columns(&above, &below, array(kColumnFactors), array(kColumnPivots), rows.data(),
                        array(columns.results[0].name), array(columns.results[1].name),
                        array(columns.results[2].name));
}

void count(ColumnSolve& columns) {
  Arrays<Counted> arrays;
  for (const Result& result : columns.lines.results) {
    arrays[result.argument.name].resize(result.values.size());
  }
  const CountedOperations operations;
  run(columns, arrays);
  columns.adds = operations.since().add;
  columns.muls = operations.since().mul;
}

}  // namespace

Program solve_for_columns(ColumnSolve columns) {
  if (columns.muls == 0) count(columns);
  Program program = columns.lines;
  program.packs.clear();
  program.results.clear();
  Arrays<PlainExpression> arrays;
  for (const Result& result : columns.lines.results) {
    for (const Expression& value : result.values) {
      arrays[result.argument.name].emplace_back(value);
    }
  }
  {
    const Graph::Scope scope(program.graph);
    run(columns, arrays);
  }
  for (const Argument& result : columns.results) {
    program.results.push_back({result, {}});
    for (const PlainExpression& value : arrays.at(result.name)) {
      program.results.back().values.push_back(value.value());
    }
  }
  program.columns = std::make_shared<const ColumnSolve>(std::move(columns));
  return program;
}

}  // namespace treeline
