#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "driving/latency.hpp"
#include "report/svg.hpp"
#include "text/json_text.hpp"
#include "text/printable.hpp"

namespace treeline {
namespace {

using Json = nlohmann::ordered_json;

/// Counts in bins of equal width; the last has all that are longer.
struct Bins {
  double first = 0, width = 10;  ///< us
  std::vector<std::uint64_t> counts;
};

Bins count_bins(const LatencySeries& series) {
  constexpr std::size_t kBins = 100;
  Bins bins;
  bins.counts.resize(kBins);
  if (series.name == "period") {
    const double middle = summarise(series).median;
    bins.first = std::max(0.0, std::round(middle / 10) * 10 - 500);
  }
  for (const float sample : series.samples) {
    const double place = std::floor((static_cast<double>(sample) - bins.first) / bins.width);
    ++bins.counts[static_cast<std::size_t>(std::clamp(place, 0.0, kBins - 1.0))];
  }
  return bins;
}

/// One histogram, in a picture of its own.
std::string draw_histogram(const LatencySeries& series, double left) {
  constexpr double kWidth = 300, kHeight = 180, kMargin = 36;
  const Bins bins = count_bins(series);
  const std::uint64_t most = *std::max_element(bins.counts.begin(), bins.counts.end());
  const double decades = std::max(1.0, std::ceil(std::log10(static_cast<double>(most) + 1)));
  const double bar = (kWidth - 2 * kMargin) / static_cast<double>(bins.counts.size());
  const double base = kHeight - kMargin;
  const auto height = [&](double count) {
    return (kHeight - 2 * kMargin) * std::log10(count + 1) / decades;
  };
  std::string text = fmt::format(
      "<svg x=\"{:.0f}\" width=\"{:.0f}\" height=\"{:.0f}\">\n<text x=\"{:.0f}\" y=\"20\" "
      "text-anchor=\"middle\">{}</text>\n",
      left, kWidth, kHeight, kWidth / 2, series.name);
  for (int decade = 0; decade <= static_cast<int>(decades); ++decade) {
    const double y = base - height(std::pow(10.0, decade) - (decade == 0 ? 1 : 0));
    text += fmt::format(
        "<line x1=\"{0}\" x2=\"{1}\" y1=\"{2:.1f}\" y2=\"{2:.1f}\" stroke=\"#ddd\"/>\n<text "
        "x=\"{3}\" y=\"{4:.1f}\" text-anchor=\"end\" font-size=\"9\">{5}</text>\n",
        kMargin, kWidth - kMargin, y, kMargin - 4, y + 3,
        decade == 0 ? "0" : fmt::format("1e{}", decade));
  }
  for (std::size_t i = 0; i < bins.counts.size(); ++i) {
    if (bins.counts[i] == 0) continue;
    const double h = height(static_cast<double>(bins.counts[i]));
    text += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"#3e7bfa\"/>\n",
        kMargin + bar * static_cast<double>(i), base - h, bar, h);
  }
  const double last = bins.first + bins.width * static_cast<double>(bins.counts.size());
  return text + fmt::format(
                    "<text x=\"{0}\" y=\"{1:.0f}\" font-size=\"10\">{2:.0f}</text>\n<text "
                    "x=\"{3}\" y=\"{1:.0f}\" font-size=\"10\" text-anchor=\"end\">{4:.0f} µs and "
                    "more</text>\n</svg>\n",
                    kMargin, base + 14, bins.first, kWidth - kMargin, last - bins.width);
}

}  // namespace

LatencySummary summarise(const LatencySeries& series) {
  if (series.samples.empty()) return {};
  std::vector<float> sorted = series.samples;
  std::sort(sorted.begin(), sorted.end());
  const auto at = [&sorted](double share) {
    const double rank = share * static_cast<double>(sorted.size() - 1);
    return static_cast<double>(sorted[static_cast<std::size_t>(rank)]);
  };
  return {at(0.5), at(0.99), at(0.999), at(0), at(1)};
}

std::string print_text(const LatencyReport& report) {
  std::string text = fmt::format(
      "{}: {} cycles at {:g} Hz in {:.4g} s, {} late\n"
      "load: {} threads of this program, load average {:.1f}{}\n"
      "{:<10}{:>10}{:>10}{:>10}{:>10}{:>10}  us\n",
      printable(report.robot), report.cycles, report.rate, report.seconds, report.late,
      report.load_threads, report.load_average,
      report.refused.empty() ? "" : "; refused: " + report.refused, "", "median", "99 %", "99.9 %",
      "least", "largest");
  for (const LatencySeries& series : report.series) {
    const LatencySummary s = summarise(series);
    text += fmt::format("{:<10}{:>10.1f}{:>10.1f}{:>10.1f}{:>10.1f}{:>10.1f}\n", series.name,
                        s.median, s.p99, s.p999, s.least, s.largest);
  }
  if (!report.fault.empty()) text += "the loop ended in a fault: " + report.fault + "\n";
  return text;
}

std::string print_json(const LatencyReport& report) {
  Json json = {{"robot", report.robot},
               {"rate", report.rate},
               {"seconds", report.seconds},
               {"cycles", report.cycles},
               {"late", report.late},
               {"load_threads", report.load_threads},
               {"load_average", report.load_average},
               {"refused", report.refused},
               {"fault", report.fault}};
  for (const LatencySeries& series : report.series) {
    const LatencySummary s = summarise(series);
    const Bins bins = count_bins(series);
    json[series.name + "_us"] = {{"median", s.median},      {"p99", s.p99},
                                 {"p999", s.p999},          {"least", s.least},
                                 {"largest", s.largest},    {"bins_from", bins.first},
                                 {"bin_width", bins.width}, {"bins", bins.counts}};
  }
  return json_text(json);
}

std::string print_svg(const LatencyReport& report) {
  constexpr double kWidth = 300;
  std::string text;
  for (std::size_t i = 0; i < report.series.size(); ++i) {
    text += draw_histogram(report.series[i], kWidth * static_cast<double>(i));
  }
  return report::svg_page(kWidth * static_cast<double>(report.series.size()), 200,
                          "font-family=\"sans-serif\" font-size=\"12\"", text);
}

}  // namespace treeline
