#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "emission/emission_context.hpp"
#include "emission/parse_loops.hpp"

namespace treeline::c {

/// How a function of the loops takes an argument, or gives its result.
enum class Passing { value, reference, sines };

/// A parameter of such a function as C has it.
struct LoopParameter {
  std::string text;  ///< `const float* q`; empty for sines that are computed
  std::string name;
  Passing passing = Passing::value;
  bool is_number = false;  ///< a reference to a number, not to a struct
};

struct LoopSignature {
  std::string result;
  Passing returns = Passing::value;
  std::vector<LoopParameter> parameters;
};

/// Features that the tables of a robot have.
struct LoopTable {
  bool floats = false, sliding = false, driven = false, rubbing = false, coupled = false;
  bool own_sines = false, balls = false, pushed = false, loaded = false, sorted = false,
       stepped = false, grounded = false, freed = false, turning = false;
};

/// Writes the loops over links, runtime/core/link_*.hpp, in C: templates for one robot, references
/// as pointers, names with the robot's name before them. It understands the part of C++ that they
/// are written in, and throws std::logic_error where it meets another. Declarations have to come in
/// their order: it learns types and functions from them.
class LoopTranslator {
 public:
  /// `table` has what of the robot's tables the headers take for constants of templates.
  LoopTranslator(const EmissionContext& context, const LoopTable& table, bool given_sines);

  /// Empty for what C has no use for.
  std::string translate(const LoopItem& item);

 private:
  std::string translate_struct(const LoopItem& item);
  std::string translate_function(const LoopItem& item);
  void learn_signature(const LoopItem& item);
  [[nodiscard]] LoopParameter parameter(const std::string& text) const;
  [[nodiscard]] std::string type(const std::string& name) const;

  /// `lines` without the branches for other robots.
  [[nodiscard]] std::vector<std::string> choose_branches(std::vector<std::string> lines) const;
  std::string statement(const std::string& text);
  std::string rewrite(std::string_view text);
  std::string word(std::string_view text, std::size_t& at);
  std::string call(const std::string& function, std::string_view text, std::size_t& at);
  std::string take_sines(const std::vector<std::string>& arguments);
  std::string compute_sines(const std::vector<std::string>& arguments);
  /// Pointer to an expression that can be assigned to.
  std::string address(const std::string& expression);
  [[nodiscard]] bool is_reference(const std::string& name) const;

  std::string name_, capitals_, number_, suffix_;
  std::map<std::string, bool> table_;  ///< `Floats`, as in `Table::kFloats`
  bool given_sines_;
  std::map<std::string, std::string> types_;
  std::map<std::string, LoopSignature> functions_;
  // Of the function that is translated.
  std::set<std::string> structs_, numbers_;  ///< references
  Passing returns_ = Passing::value;
};

}  // namespace treeline::c
