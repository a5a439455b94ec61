#pragma once

#include <string>

#include "emission/emission_context.hpp"
#include "program/program.hpp"

namespace treeline {

/// `mark ` before every line; no blank at the end of an empty one.
std::string comment(const std::string& mark, const std::string& text);

/// A source file's text without what names from elsewhere could do to a compiler: characters that
/// nobody sees are written as `\x0d` (see `printable`), a backslash that would join a comment to
/// the next line as `\x5c`, and trigraphs, one of which is such a backslash, with `\x3f`.
std::string harmless(const std::string& source);

/// Lines of so many columns, broken at blanks; those behind the first are indented.
std::string wrap_text(const std::string& text, std::size_t columns);

/// Text within a comment of C: no end and no begin of one, lines of the width of the rest.
std::string in_comment(std::string text, std::size_t columns = 94);

/// "By recursive Newton-Euler.", wrapped, with a line break; empty where the program does not say.
std::string describe_method(const Program& program);

/// Start of a source file: name, equation and method of its function, as comments.
std::string describe_source(const Program& program);

/// Text of the context about the rounding errors of a source, wrapped, if there is any.
std::string describe_rounding(const EmissionContext& context, const std::string& source);

}  // namespace treeline
