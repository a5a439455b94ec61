#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "passes/passes.hpp"
#include "passes/rewriter.hpp"

namespace treeline {
namespace {

struct SineCosine {
  Expression sine, cosine;
};

class SineTaker {
 public:
  explicit SineTaker(const Graph& graph) : graph_(graph) {}

  /// Returns sine and cosine of node `angle` of the old graph, expressed by the inputs. Nothing if
  /// the inputs do not determine them.
  std::optional<SineCosine> take(std::uint32_t angle) {
    const Node& node = graph_.nodes()[angle];
    switch (node.op) {
      case Op::constant:
        return SineCosine{std::sin(node.value), std::cos(node.value)};
      case Op::input:
        return take_input(graph_.inputs()[node.a]);
      case Op::neg: {
        const auto a = take(node.a);
        if (!a) return std::nullopt;
        return SineCosine{-a->sine, a->cosine};
      }
      case Op::add:
      case Op::sub:
        return take_sum(node);
      default:
        return std::nullopt;
    }
  }

 private:
  static std::optional<SineCosine> take_input(const std::string& input) {
    if (!input.starts_with("q[")) return std::nullopt;
    const std::string element = input.substr(1);
    Graph& taken = Graph::current();
    return SineCosine{taken.input("sin_q" + element), taken.input("cos_q" + element)};
  }

  std::optional<SineCosine> take_sum(const Node& node) {
    const auto a = take(node.a);
    const auto b = take(node.b);
    if (!a || !b) return std::nullopt;
    const Expression crossed = a->cosine * b->sine;
    const Expression squared = a->sine * b->sine;
    const Expression sine = a->sine * b->cosine;
    const Expression cosine = a->cosine * b->cosine;
    return node.op == Op::add ? SineCosine{sine + crossed, cosine - squared}
                              : SineCosine{sine - crossed, cosine + squared};
  }

  const Graph& graph_;
};

bool reads_sines(const Program& program) {
  return std::any_of(program.graph.inputs().begin(), program.graph.inputs().end(),
                     [](const std::string& input) { return input.starts_with("sin_q["); });
}

}  // namespace

void declare_sines(Program& program) {
  if (!reads_sines(program)) return;
  const auto q = std::find_if(program.arguments.begin(), program.arguments.end(),
                              [](const Argument& argument) { return argument.name == "q"; });
  const int rows = q->rows;
  const auto behind =
      program.arguments.insert(q + 1, {"sin_q", rows, 1, "sines of q; read for angles only"});
  program.arguments.insert(behind + 1, {"cos_q", rows, 1, "cosines of q; read for angles only"});
}

Program take_sines(const Program& program) {
  SineTaker taker(program.graph);
  Program taken = Rewriter(program).run([&](std::uint32_t node, const Rewriter& r) {
    const Node& what = program.graph.nodes()[node];
    if (is_trigonometric(what.op)) {
      const auto given = taker.take(what.a);
      if (given) return what.op == Op::sin ? given->sine : given->cosine;
    }
    return r.copy(node);
  });
  declare_sines(taken);
  return taken;
}

}  // namespace treeline
