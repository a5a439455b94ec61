#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace treeline::report {

/// Numbers recorded cycle by cycle, in named columns. Rows are reserved in advance, so that
/// recording does not allocate.
class Table {
 public:
  Table(std::vector<std::string> names, std::size_t capacity)
      : names_(std::move(names)), capacity_(capacity) {
    numbers_.reserve(names_.size() * capacity_);
  }

  /// Appends a row of `columns()` numbers. Returns false, and records nothing, if the table is
  /// full.
  bool append(const double* row) noexcept {
    if (rows() == capacity_) {
      return false;
    }
    numbers_.insert(numbers_.end(), row, row + names_.size());
    return true;
  }

  const std::vector<std::string>& names() const noexcept { return names_; }
  std::size_t columns() const noexcept { return names_.size(); }
  std::size_t rows() const noexcept { return numbers_.size() / names_.size(); }
  double at(std::size_t row, std::size_t column) const noexcept {
    return numbers_[row * names_.size() + column];
  }
  std::vector<double> column(std::size_t index) const;

 private:
  std::vector<std::string> names_;
  std::size_t capacity_;
  std::vector<double> numbers_;
};

/// `names` and the names q0, q1, ... of `count` coordinates, as `treeline drive --replay` reads
/// them.
std::vector<std::string> with_coordinates(std::vector<std::string> names, int count);

/// Prints the table as comma-separated text: a line of names, then a line per row. Each number has
/// the fewest digits that read back as the same number.
std::string csv_text(const Table& table);

/// Writes `text` to the file `path`. Returns the error in words, or an empty text.
std::string write_text(const std::string& path, const std::string& text);

}  // namespace treeline::report
