#include "emission/print_body.hpp"

#include <limits>

#include "emission/body_printer.hpp"

namespace treeline {

std::string print_body(const Program& program, const Syntax& syntax,
                       const std::set<std::string>& taken) {
  BodyPrinter printer(program, syntax, taken, std::numeric_limits<std::size_t>::max());
  return printer.print(0, printer.count());
}

}  // namespace treeline
