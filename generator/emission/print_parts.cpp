#include "emission/print_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "emission/body_printer.hpp"
#include "emission/c_family_syntax.hpp"
#include "emission/emitted_text.hpp"

namespace treeline {
namespace {

/// Most angles of one call for sines and cosines, so that the call fits into one part.
constexpr std::size_t kMostAngles = 16;

bool needs_name(double constant) {
  constexpr std::array<double, 4> kPlain = {0, 0.5, 1, 2};
  return std::find(kPlain.begin(), kPlain.end(), std::abs(constant)) == kPlain.end();
}

/// Units of one part, and what they read and write together.
struct Piece {
  BodyUnit sum;
  std::set<std::uint32_t> defines;
};

class Parter {
 public:
  Parter(const Program& program, const Syntax& syntax, const std::set<std::string>& taken)
      : program_(program), syntax_(syntax), printer_(program, syntax, taken, kMostAngles) {
    for (const BodyUnit& unit : printer_.list_units()) add(unit);
  }

  /// Nodes that one piece defines and others read, in order.
  [[nodiscard]] std::set<std::uint32_t> find_shared() const {
    std::set<std::uint32_t> shared;
    for (const Piece& piece : pieces_) {
      for (const std::uint32_t value : piece.sum.values) {
        if (!piece.defines.contains(value)) shared.insert(value);
      }
    }
    return shared;
  }

  PartedBody print(const std::string& before) {
    PartedBody body;
    shared_ = find_shared();
    for (const std::uint32_t node : shared_) {
      body.values.push_back(printer_.name_of(node));
      printer_.keep_in(node, before + printer_.name_of(node));
    }
    for (const Piece& piece : pieces_) body.parts.push_back(print_piece(piece, body.parts.size()));
    if (body.parts.size() == 1) {
      body.statements = body.parts.front().statements;
      body.parts.clear();
    }
    for (std::size_t i = 0; i < body.parts.size(); ++i) body.calls.push_back(i);
    while (body.calls.size() >= kMostStatements) group(body);  // one declares shared values
    return body;
  }

 private:
  static int count_new(const std::set<std::uint32_t>& constants,
                       const std::set<std::uint32_t>& known) {
    return static_cast<int>(std::count_if(constants.begin(), constants.end(),
                                          [&](auto node) { return !known.contains(node); }));
  }

  void add(BodyUnit unit) {
    std::erase_if(unit.constants,
                  [this](auto node) { return !needs_name(printer_.constant(node)); });
    const bool fits =
        !pieces_.empty() && pieces_.back().sum.statements + unit.statements +
                                    count_new(unit.constants, pieces_.back().sum.constants) <=
                                kMostStatements;
    if (!fits) {
      pieces_.emplace_back();
      pieces_.back().sum.first = unit.first;
    }
    Piece& piece = pieces_.back();
    BodyUnit& sum = piece.sum;
    sum.end = unit.end;
    sum.statements += unit.statements + count_new(unit.constants, sum.constants);
    sum.values.merge(unit.values);
    sum.constants.merge(unit.constants);
    sum.arguments.merge(unit.arguments);
    sum.results.merge(unit.results);
    for (std::uint32_t node = unit.first; node < unit.end; ++node) {
      if (printer_.has_statement(node)) piece.defines.insert(node);
    }
  }

  const std::string& name_constant(std::uint32_t node) {
    std::string& name = constants_[node];
    if (!name.empty()) return name;
    const auto known = printer_.known_constants().find(node);
    name = known != printer_.known_constants().end()
               ? known->second
               : fmt::format("constant_{}", constants_.size());
    return name;
  }

  BodyPart print_piece(const Piece& piece, std::size_t index) {
    BodyPart part;
    part.name = fmt::format("{}_part_{}", program_.name, index + 1);
    part.arguments = piece.sum.arguments;
    part.results = piece.sum.results;
    for (const std::uint32_t node : shared_) {
      const bool own = piece.defines.contains(node);
      part.writes_values = part.writes_values || own;
      part.reads_values = part.reads_values || (!own && piece.sum.values.contains(node));
    }
    NamedConstants constants;
    for (const std::uint32_t node : piece.sum.constants) constants[node] = name_constant(node);
    part.statements = printer_.print(piece.sum.first, piece.sum.end, constants);
    return part;
  }

  /// Parts that call as many of the last level as may be.
  static void group(PartedBody& body) {
    std::vector<std::size_t> groups;
    for (std::size_t first = 0; first < body.calls.size(); first += kMostStatements) {
      const std::size_t end = std::min<std::size_t>(first + kMostStatements, body.calls.size());
      BodyPart whole;
      for (std::size_t i = first; i < end; ++i) {
        const BodyPart& part = body.parts[body.calls[i]];
        whole.calls.push_back(body.calls[i]);
        whole.arguments.insert(part.arguments.begin(), part.arguments.end());
        whole.results.insert(part.results.begin(), part.results.end());
        whole.reads_values = whole.reads_values || part.reads_values;
        whole.writes_values = whole.writes_values || part.writes_values;
      }
      const std::string& from = body.parts[whole.calls.front()].name;
      const std::string& to = body.parts[whole.calls.back()].name;
      whole.name = fmt::format("{}_to_{}", from, to.substr(to.rfind('_') + 1));
      groups.push_back(body.parts.size());
      body.parts.push_back(std::move(whole));
    }
    body.calls = groups;
  }

  const Program& program_;
  const Syntax& syntax_;
  BodyPrinter printer_;
  std::vector<Piece> pieces_;
  std::set<std::uint32_t> shared_;
  std::map<std::uint32_t, std::string> constants_;
};

}  // namespace

std::size_t count_shared_values(const Program& program) {
  const Syntax syntax = make_c_family_syntax(false);
  return Parter(program, syntax, {}).find_shared().size();
}

std::string list_arguments(
    const Program& program, const BodyPart& part, const std::string& values,
    const std::function<std::string(const Argument&, const char* qualifier)>& print) {
  std::string list;
  const auto append = [&](const std::string& text) { list += (list.empty() ? "" : ", ") + text; };
  for (const Argument& argument : program.arguments) {
    if (part.arguments.contains(argument.name)) append(print(argument, "const "));
  }
  if (part.reads_values || part.writes_values) append(values);
  for (const Result& result : program.results) {
    if (part.results.contains(result.argument.name)) append(print(result.argument, ""));
  }
  return list;
}

PartedBody print_parts(const Program& program, const Syntax& syntax,
                       const std::set<std::string>& taken, const std::string& values) {
  return Parter(program, syntax, taken).print(values);
}

}  // namespace treeline
