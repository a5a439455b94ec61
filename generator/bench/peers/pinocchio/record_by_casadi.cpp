#include <utility>

#include "bench/peers/pinocchio/record.hpp"

namespace treeline::peer::pin {
namespace {

using Elements = std::vector<casadi::SXElem>;

/// Replaces the place of each result among those that are not zero, `res[0][k]`, by that among all.
std::string place_results(const std::string& code, const std::vector<std::size_t>& places) {
  const std::string before = "res[0][";
  std::string placed;
  std::size_t done = 0;
  for (auto at = code.find(before); at != std::string::npos; at = code.find(before, done)) {
    const std::size_t from = at + before.size();
    placed.append(code, done, from - done);
    placed += std::to_string(places.at(std::stoul(code.substr(from, 20))));
    done = code.find(']', from);
  }
  return placed.append(code, done);
}

}  // namespace

Tool recording_tool() {
  return {"CasADi", casadi::CasadiMeta::version()};
}

std::string record(const Solver<double>& solver, const Shape& shape, Route route) {
  Solver<Recorded> recorder(solver.model.cast<Recorded>(), solver.points, solver.place,
                            solver.floating);
  std::vector<casadi::SX> symbols;
  std::vector<std::vector<Recorded>> inputs;
  std::vector<const Recorded*> in;
  for (const std::size_t size : shape.inputs) {
    symbols.push_back(casadi::SX::sym("in" + std::to_string(in.size()), casadi_int(size)));
    const Elements& elements = symbols.back().nonzeros();
    inputs.emplace_back(elements.begin(), elements.end());
    in.push_back(inputs.back().data());
  }
  std::vector<Recorded> y(shape.output, Recorded(0));
  route(recorder, in.data(), y.data());
  Elements results;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < y.size(); ++i) {
    if (y[i].is_zero()) continue;
    results.push_back(y[i].scalar());
    places.push_back(i);
  }
  const casadi::Function function("called", symbols, {casadi::SX(results)});
  casadi::CodeGenerator generator("code");
  generator.add(function);
  const std::string work = std::to_string(function.sz_w() + 1);
  return place_results(generator.dump(), places) +
         "\nvoid recorded(void* solver, const double* const* in, double* y) {\n  static double w[" +
         work + "];\n  double* res[] = {y};\n  called((const double**)in, res, 0, w, 0);\n}\n";
}

}  // namespace treeline::peer::pin
