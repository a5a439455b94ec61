#include "report/table.hpp"

#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>

namespace treeline::report {

std::vector<double> Table::column(std::size_t index) const {
  std::vector<double> numbers(rows());
  for (std::size_t row = 0; row < numbers.size(); ++row) {
    numbers[row] = at(row, index);
  }
  return numbers;
}

std::vector<std::string> with_coordinates(std::vector<std::string> names, int count) {
  for (int i = 0; i < count; ++i) names.push_back(std::string("q").append(std::to_string(i)));
  return names;
}

std::string csv_text(const Table& table) {
  std::string text;
  for (std::size_t i = 0; i < table.columns(); ++i) {
    text += (i == 0 ? "" : ",") + table.names()[i];
  }
  text += '\n';
  std::array<char, 32> digits;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    for (std::size_t i = 0; i < table.columns(); ++i) {
      const auto end =
          std::to_chars(digits.data(), digits.data() + digits.size(), table.at(row, i));
      text.append(i == 0 ? "" : ",").append(digits.data(), end.ptr);
    }
    text += '\n';
  }
  return text;
}

std::string write_text(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.flush();
  if (!file) {
    return "cannot write " + path + ": " + std::strerror(errno);
  }
  return {};
}

}  // namespace treeline::report
