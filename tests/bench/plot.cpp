#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "report.hpp"
#include "report/decades.hpp"
#include "report/svg.hpp"

namespace treeline::bench {
namespace {

struct Family {
  std::string_view begins, contains, label, colour;
};

/// An implementation belongs to the first family whose name fits.
constexpr Family kFamilies[] = {
    {"generated", "a call", "generated, eight states a call", "#1b9e77"},
    {"generated", "", "generated", "#0b5394"},
    {"CppADCodeGen", "", "CppADCodeGen", "#e69f00"},
    {"Pinocchio", "", "Pinocchio", "#cc0000"},
    {"KDL", "", "KDL", "#8e63b8"},
    {"DART", "", "DART", "#7a5230"},
    {"interpreter", "", "interpreter", "#9a9a9a"}};

const Family* family_of(const Row& row) {
  const std::string_view name = row.subject->implementation;
  const auto fits = [&](const Family& each) {
    return name.starts_with(each.begins) && name.find(each.contains) != std::string_view::npos;
  };
  const auto* found = std::find_if(std::begin(kFamilies), std::end(kFamilies), fits);
  return found == std::end(kFamilies) ? nullptr : found;
}

constexpr double kLeft = 300, kWidth = 640, kTop = 78, kStep = 17;
constexpr report::Decades kAxis{0, 7};  // nanoseconds

double x_of(double nanoseconds) {
  return kLeft + kWidth * std::clamp(kAxis.at(nanoseconds), 0.0, 1.0);
}

std::string text_at(double x, double y, std::string_view anchor, std::string_view text) {
  return report::svg_text_at(x, y, fmt::format("text-anchor=\"{}\"", anchor),
                             report::escape_xml(text));
}

std::string draw_axis(double bottom) {
  std::string text;
  for (int decade = kAxis.first; decade <= kAxis.last; ++decade) {
    const double x = x_of(std::pow(10.0, decade));
    text += report::svg_line(x, kTop - 12, x, bottom, "#dddddd");
    text += text_at(x, kTop - 16, "middle", report::time_name(decade));
  }
  return text;
}

std::string draw_legend() {
  std::string text;
  double x = 20;
  for (const Family& each : kFamilies) {
    text += report::svg_disc(x, 36, 4.5, each.colour);
    text += text_at(x + 9, 40, "start", each.label);
    x += 34 + 7.0 * static_cast<double>(each.label.size());
  }
  return text;
}

/// Draws the dots of rows [first, last), which belong to one function of one robot.
std::string draw_dots(const Row* first, const Row* last, double y, bool least) {
  std::string text;
  for (const Family& family : kFamilies) {
    std::optional<double> fastest;
    for (const Row* row = first; row != last; ++row) {
      const auto warm = row->time(Mode::warm, least);
      if (family_of(*row) == &family && warm) fastest = std::min(fastest.value_or(*warm), *warm);
    }
    if (!fastest) continue;
    text += report::svg_disc(x_of(*fastest), y, 4.5, family.colour,
                             fmt::format("{}: {:.1f} ns", family.label, *fastest));
  }
  return text;
}

}  // namespace

std::string draw_plot(const std::vector<Row>& rows, const Machine& machine, bool least) {
  std::string lines;
  double y = kTop;
  for (std::size_t i = 0, next = 0; i < rows.size(); i = next) {
    const Row& row = rows[i];
    const auto same = [&](const Row& other) {
      return other.measured == row.measured && other.function == row.function;
    };
    while (next < rows.size() && same(rows[next])) ++next;
    if (i > 0 && rows[i - 1].measured != row.measured) y += kStep / 2;
    lines +=
        text_at(kLeft - 10, y + 4, "end", row.measured->robot.robot + ' ' + name_of(row.function));
    lines += draw_dots(rows.data() + i, rows.data() + next, y, least);
    y += kStep;
  }
  const std::string title =
      text_at(20, 18, "start",
              fmt::format("Time a state, warm, {} of interleaved runs, the fastest of each family; "
                          "{}, one core",
                          least ? "least" : "median", machine.processor));
  return report::svg_page(970, y + 10, "font-family=\"sans-serif\" font-size=\"12\"",
                          title + draw_legend() + draw_axis(y - kStep / 2) + lines);
}

}  // namespace treeline::bench
