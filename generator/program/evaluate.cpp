#include "program/evaluate.hpp"

namespace treeline {

template float evaluate_node(const Node&, const std::vector<float>&, const std::vector<float>&);
template double evaluate_node(const Node&, const std::vector<double>&, const std::vector<double>&);
template std::vector<std::vector<float>> evaluate(const Program&,
                                                  const std::vector<std::vector<float>>&);
template std::vector<std::vector<double>> evaluate(const Program&,
                                                   const std::vector<std::vector<double>>&);
template std::vector<std::vector<long double>> evaluate(
    const Program&, const std::vector<std::vector<long double>>&);

}  // namespace treeline
