#include <sstream>

#include "bench/peers/pinocchio/record.hpp"

namespace treeline::peer::pin {
namespace {

std::vector<std::string> names_of_inputs(const Shape& shape) {
  std::vector<std::string> names;
  for (std::size_t k = 0; k < shape.inputs.size(); ++k) {
    for (std::size_t i = 0; i < shape.inputs[k]; ++i) {
      names.push_back("in" + std::to_string(k) + "[" + std::to_string(i) + "]");
    }
  }
  return names;
}

CppAD::ADFun<Code> record_tape(const Solver<double>& solver, const Shape& shape, Route route) {
  Solver<Recorded> recorder(solver.model.cast<Recorded>(), solver.points, solver.place,
                            solver.floating);
  const auto count = names_of_inputs(shape).size();
  CppAD::vector<Recorded> x(count), y(shape.output);
  // The state at which the code is recorded does not matter, but a singular one would be taken for
  // an error.
  for (std::size_t i = 0; i < count; ++i) x[i] = Recorded(0.3 + 0.1 * static_cast<double>(i % 7));
  CppAD::Independent(x);
  std::vector<const Recorded*> in;
  std::size_t at = 0;
  for (const std::size_t size : shape.inputs) {
    in.push_back(x.data() + at);
    at += size;
  }
  route(recorder, in.data(), y.data());
  CppAD::ADFun<Code> tape(x, y);
  tape.optimize("no_compare_op");
  return tape;
}

}  // namespace

Tool recording_tool() {
  return {"CppADCodeGen", &CPPAD_CG_VERSION[sizeof "cppadcg"]};
}

std::string record(const Solver<double>& solver, const Shape& shape, Route route) {
  auto tape = record_tape(solver, shape, route);
  CppAD::cg::CodeHandler<double> handler;
  CppAD::vector<Code> x(tape.Domain());
  handler.makeVariables(x);
  CppAD::vector<Code> y = tape.Forward(0, x);
  CppAD::cg::LanguageC<double> language("double");
  language.setParameterPrecision(17);
  CppAD::cg::LangCCustomVariableNameGenerator<double> names({}, names_of_inputs(shape));
  std::ostringstream statements;
  handler.generateCode(statements, language, y, names);
  const auto temporaries =
      names.getMaxTemporaryVariableID() + 1 - names.getMinTemporaryVariableID();
  std::string code =
      "#include <math.h>\n\nvoid recorded(void* solver, const double* const* in, double* "
      "__restrict y) "
      "{\n";
  for (std::size_t k = 0; k < shape.inputs.size(); ++k) {
    const std::string name = "in" + std::to_string(k);
    code += "  const double* __restrict " + name + " = in[" + std::to_string(k) + "];\n";
  }
  return code + "  double v[" + std::to_string(temporaries) + "];\n" + statements.str() + "}\n";
}

}  // namespace treeline::peer::pin
