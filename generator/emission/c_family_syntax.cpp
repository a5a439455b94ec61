#include "emission/c_family_syntax.hpp"

#include <fmt/format.h>

#include <cctype>
#include <cmath>
#include <stdexcept>

#include "program/format_literal.hpp"
#include "text/identifier.hpp"

namespace treeline {
namespace {

std::string float_literal(double value) {
  return format_literal(static_cast<float>(value));
}

/// Literal of type float, with its suffix in capitals.
std::string safe_float_literal(double value) {
  std::string text = float_literal(value);
  text.back() = 'F';
  return text;
}

std::string double_literal(double value) {
  return format_literal(value);
}

std::string_view c_sign(Op op) {
  switch (op) {
    case Op::add:
      return "+";
    case Op::sub:
    case Op::neg:
      return "-";
    case Op::mul:
      return "*";
    case Op::div:
      return "/";
    default:
      throw std::logic_error("no sign stands for this operation");
  }
}

std::string keep_constant(const std::string& type, const std::string& name,
                          const std::string& value) {
  return fmt::format("const {} {} = {};", type, name, value);
}

std::string assign(const Syntax& /*own*/, const std::string& target, const std::string& value) {
  return fmt::format("{} = {};", target, value);
}

std::string read_plainly(const std::string& element) {
  return element;
}

}  // namespace

Syntax make_c_family_syntax(bool single_precision) {
  Syntax syntax{};
  syntax.comment = "//";
  syntax.literal = single_precision ? float_literal : double_literal;
  syntax.sign = c_sign;
  syntax.keep = keep_constant;
  syntax.store = assign;
  syntax.read = read_plainly;
  return syntax;
}

void follow_misra(bool single_precision, Syntax& syntax) {
  syntax.parentheses = Parentheses::all;
  if (single_precision) syntax.literal = safe_float_literal;
}

std::string number_literal(const EmissionContext& context, const char* digits) {
  return std::string(digits) + (context.single_precision ? "F" : "");
}

std::string signed_literal(const Syntax& syntax, double value) {
  if (value == 0) return syntax.literal(0);
  return (value < 0 ? "-" : "") + syntax.literal(std::abs(value));
}

std::string in_pascal_case(std::string_view name) {
  std::string words;
  bool starts_word = true;
  for (const char c : name) {
    if (c != '_') {
      words += starts_word ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    }
    starts_word = c == '_';
  }
  return words;
}

std::string in_snake_case(std::string_view name) {
  std::string text;
  for (const char c : name) {
    const bool capital = std::isupper(static_cast<unsigned char>(c)) != 0;
    if (capital && !text.empty()) text += '_';
    text += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return text;
}

std::string name_in_capitals(const EmissionContext& context) {
  return in_capitals(context.name);
}

}  // namespace treeline
