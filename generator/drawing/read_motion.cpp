#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string_view>

#include "description/read_number.hpp"
#include "drawing/recorded_motion.hpp"
#include "text/read_text_file.hpp"

namespace treeline {
namespace {

constexpr const char* kForms =
    "Columns are `time` (or `time_s`) and q0, q1, ... or q_JOINT, separated by commas, below a "
    "line with their names, as `treeline simulate --csv` and the page of `treeline drive` write "
    "them; "
    "or give a file of `treeline drive --record`.";

std::vector<std::string> split_cells(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) {
    cells.emplace_back(trimmed(cell));
  }
  return cells;
}

/// A column's name without the unit behind it, in brackets.
std::string without_unit(const std::string& name) {
  return name.substr(0, name.ends_with(']') ? name.rfind(" [") : std::string::npos);
}

/// What stands before the first blank: `q0` of `q0 base.x`.
std::string first_word(const std::string& name) {
  return name.substr(0, name.find(' '));
}

/// Whether this is q with digits, the name of a coordinate of some robot.
bool is_numbered(const std::string& name) {
  return name.size() > 1 && name.front() == 'q' &&
         name.find_first_not_of("0123456789", 1) == std::string::npos;
}

/// Whether this is qd with digits, the name of a velocity.
bool is_rate(const std::string& name) {
  return name.size() > 2 && name.starts_with("qd") && is_numbered("q" + name.substr(2));
}

/// Reads a file line by line.
class MotionReading {
 public:
  MotionReading(std::string path, const std::vector<std::string>& joints,
                const std::vector<double>& home, Diagnostics& diagnostics)
      : path_(std::move(path)), joints_(joints), home_(home), diagnostics_(diagnostics) {}

  std::optional<RecordedMotion> read(const std::string& text) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";  // as spreadsheets write it
    std::istringstream lines(
        text.substr(text.rfind(kByteOrderMark, 0) == 0 ? kByteOrderMark.size() : 0));
    bool well = true;
    for (std::string line; well && std::getline(lines, line);) {
      ++number_;
      if (trimmed(line).empty()) continue;
      if (line.front() == '{') {
        well = read_record(line);
      } else {
        well = names_.empty() ? read_names(line) : read_row(line);
      }
    }
    if (well && motion_.times.empty()) well = fail("there is no row of numbers");
    if (!well) return std::nullopt;
    return std::move(motion_);
  }

 private:
  bool fail(std::string fault) {
    diagnostics_.add({Severity::error, path_, number_, "", std::move(fault), kForms});
    return false;
  }

  bool add(double time, std::vector<double> q) {
    if (!motion_.times.empty() && time < motion_.times.back()) return fail("time runs backwards");
    motion_.times.push_back(time);
    motion_.q.push_back(std::move(q));
    return true;
  }

  /// Other lines of a record, of commands for instance, have no coordinates.
  bool read_record(const std::string& line) {
    const auto json = nlohmann::json::parse(line, nullptr, false);
    if (json.is_discarded()) return fail("this line is not JSON");
    if (!json.contains("q") || !json.contains("time")) return true;
    const auto& q = json["q"];
    const bool numbers =
        json["time"].is_number() && q.is_array() &&
        std::all_of(q.begin(), q.end(), [](const auto& e) { return e.is_number(); });
    if (!numbers || q.size() != home_.size()) {
      return fail(fmt::format("`q` has to be {} numbers, those of this robot", home_.size()));
    }
    return add(json["time"].get<double>(), q.get<std::vector<double>>());
  }

  /// Coordinate of a column: -1 if it has none.
  [[nodiscard]] int coordinate_of(const std::string& name) const {
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      const bool single = std::count(joints_.begin(), joints_.end(), joints_[i]) == 1;
      if (first_word(name) == fmt::format("q{}", i) || (single && name == "q_" + joints_[i])) {
        return static_cast<int>(i);
      }
    }
    return -1;
  }

  /// Whether q0 is among the columns, as in a table of whole states.
  [[nodiscard]] bool columns_with_first() const {
    return std::count(columns_.begin(), columns_.end(), 0) > 0;
  }

  bool read_names(const std::string& line) {
    names_ = split_cells(line);
    bool has_time = false;
    std::size_t coordinates = 0;
    bool has_rates = false;
    for (const std::string& cell : names_) {
      const std::string name = without_unit(cell);
      const bool is_time = name == "time" || name == "time_s";
      has_time = has_time || is_time;
      columns_.push_back(is_time ? kTime : coordinate_of(name));
      coordinates += columns_.back() >= 0 ? 1 : 0;
      has_rates = has_rates || is_rate(first_word(name));
      if (columns_.back() == kNone && is_numbered(first_word(name))) {
        return fail(fmt::format("there is no coordinate `{}`: the robot has {}, from q0 on", name,
                                home_.size()));
      }
    }
    if (!has_time) return fail("there is no column `time`");
    if (has_rates && columns_with_first() && coordinates != home_.size()) {
      return fail(fmt::format("it has the state of a robot with {} coordinates, this one has {}",
                              coordinates, home_.size()));
    }
    return coordinates > 0 || fail("no column is a coordinate of this robot");
  }

  bool read_row(const std::string& line) {
    const std::vector<std::string> cells = split_cells(line);
    if (cells.size() != names_.size()) {
      return fail(
          fmt::format("{} numbers are expected, there are {}", names_.size(), cells.size()));
    }
    double time = 0;
    std::vector<double> q = home_;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (columns_[i] == kNone) continue;
      const auto value = read_number(cells[i]);
      if (!value) return fail(fmt::format("`{}` is not a number", cells[i]));
      (columns_[i] == kTime ? time : q[static_cast<std::size_t>(columns_[i])]) = *value;
    }
    return add(time, std::move(q));
  }

  static constexpr int kNone = -1;
  static constexpr int kTime = -2;

  std::string path_;
  const std::vector<std::string>& joints_;
  const std::vector<double>& home_;
  Diagnostics& diagnostics_;
  int number_ = 0;
  std::vector<std::string> names_;
  std::vector<int> columns_;
  RecordedMotion motion_;
};

}  // namespace

std::optional<RecordedMotion> read_motion(const std::string& path,
                                          const std::vector<std::string>& joints,
                                          const std::vector<double>& home,
                                          Diagnostics& diagnostics) {
  const auto text = read_text_file(path, diagnostics);
  if (!text) return std::nullopt;
  return MotionReading(shown_path(path), joints, home, diagnostics).read(*text);
}

}  // namespace treeline
