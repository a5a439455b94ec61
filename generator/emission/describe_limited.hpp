#pragma once

#include <span>
#include <string>
#include <vector>

#include "emission/emission_context.hpp"
#include "emission/syntax.hpp"
#include "program/program.hpp"

namespace treeline {

/// A function that `limited_control_torque` calls, and the array that takes its result.
struct LimitedCall {
  const Program* program;
  const char* result;
};

/// `supported_control_torque`. Throws std::logic_error where it is not among the programs.
const Program& find_supported(std::span<const Program> programs);

/// The functions whose results the program of limits needs: M, and J_s and J_t where there are held
/// rows and a task. Throws std::logic_error where one of them is missing.
std::vector<LimitedCall> list_limited_calls(const EmissionContext& context,
                                            std::span<const Program> programs);

/// Whether constraints hold any rows.
bool holds_rows(const EmissionContext& context);

/// Freedoms of torques and internal forces, at least one.
int count_freedoms(const LimitFacts& facts);

/// How a language writes what `print_shares` prints.
struct ShareWords {
  std::string scope;  ///< of functions
  std::string type, whole;
  bool by_address = false;  ///< arrays are handed on as `&array[0]`
  bool of_batch = false;    ///< for state k of several
};

/// Statements that declare `layout`, the constant one with the shares that the arguments give;
/// nothing where none come and go.
std::string print_shares(const EmissionContext& context, const Program& supported,
                         const ShareWords& words);

/// Lines for comments: the cost of a call, of one for a batch; the cones.
std::string describe_limited_cost(const EmissionContext& context,
                                  std::span<const Program> programs);
std::string describe_batch_limited_cost(const EmissionContext& context,
                                        std::span<const Program> batch);
std::string describe_cones(const LimitFacts& facts);

/// Initialisers of the structures for limits and for what is constant, without the outer braces.
/// `no_limit` stands for an infinite torque, `no_cones` where there are none.
std::string print_torque_limits(const LimitFacts& facts, const Syntax& syntax,
                                const std::string& no_limit, const std::string& no_cones);
std::string print_support_layout(const LimitFacts& facts, const Syntax& syntax);

}  // namespace treeline
