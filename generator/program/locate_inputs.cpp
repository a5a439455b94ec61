#include <charconv>
#include <string_view>

#include "program/evaluate.hpp"

namespace treeline {
namespace {

InputPlace locate(const Program& program, std::string_view name) {
  const std::size_t bracket = name.find('[');
  std::size_t element = 0;
  const bool has_index =
      bracket != std::string_view::npos && name.back() == ']' &&
      std::from_chars(name.data() + bracket + 1, name.data() + name.size() - 1, element).ptr ==
          name.data() + name.size() - 1;
  for (std::size_t i = 0; has_index && i < program.arguments.size(); ++i) {
    const Argument& argument = program.arguments[i];
    if (argument.name == name.substr(0, bracket) &&
        element <
            static_cast<std::size_t>(argument.rows) * static_cast<std::size_t>(argument.cols)) {
      return {i, element};
    }
  }
  throw std::logic_error("`" + std::string(name) + "` is no element of an argument of `" +
                         program.name + "`");
}

}  // namespace

std::vector<InputPlace> locate_inputs(const Program& program) {
  std::vector<InputPlace> places;
  for (const std::string& name : program.graph.inputs()) {
    places.push_back(locate(program, name));
  }
  return places;
}

}  // namespace treeline
