#include "emission/print_body.hpp"

#include <limits>

#include "emission/body_printer.hpp"

namespace treeline {
namespace {

/// Constants that are known and that statements read.
NamedConstants list_constants(const BodyPrinter& printer) {
  NamedConstants read;
  for (const BodyUnit& unit : printer.list_units()) {
    for (const std::uint32_t node : unit.constants) {
      const auto known = printer.known_constants().find(node);
      if (known != printer.known_constants().end()) read.insert(*known);
    }
  }
  return read;
}

}  // namespace

std::string print_body(const Program& program, const Syntax& syntax,
                       const std::set<std::string>& taken) {
  BodyPrinter printer(program, syntax, taken, std::numeric_limits<std::size_t>::max());
  const NamedConstants none;
  return printer.print(0, printer.count(), syntax.names_constants ? list_constants(printer) : none);
}

}  // namespace treeline
