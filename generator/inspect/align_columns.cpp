#include "inspect/align_columns.hpp"

#include <algorithm>

namespace treeline {
namespace {

std::size_t width_of(const std::string& text) {
  const auto starts = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; };
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), starts));
}

std::string padded(const std::string& cell, const Column& column, std::size_t width) {
  const std::string space(width - width_of(cell), ' ');
  return column.right ? space + cell : cell + space;
}

}  // namespace

std::string align_columns(const std::vector<Column>& columns,
                          const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths(columns.size(), 0);
  for (const auto& row : rows) {
    for (std::size_t c = 0; c < columns.size(); ++c) {
      widths[c] = std::max(widths[c], width_of(row[c]));
    }
  }
  std::string text;
  const auto add_line = [&](const auto& cell_of) {
    std::string line;
    for (std::size_t c = 0; c < columns.size(); ++c) {
      if (widths[c] == 0) continue;
      line += "  " + padded(cell_of(c), columns[c], std::max(widths[c], width_of(columns[c].head)));
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  };
  add_line([&](std::size_t c) { return columns[c].head; });
  for (const auto& row : rows) add_line([&](std::size_t c) { return row[c]; });
  return text;
}

}  // namespace treeline
