#include "report/svg.hpp"

#include <fmt/format.h>

namespace treeline::report {

std::string escape_xml(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

std::string open_svg(double width, double height, std::string_view attributes) {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
      "viewBox=\"0 0 {0:.0f} {1:.0f}\" {2}>\n",
      width, height, attributes);
}

std::string svg_page(double width, double height, std::string_view attributes,
                     std::string_view body, std::string_view ground) {
  return fmt::format("{}<rect width=\"100%\" height=\"100%\" fill=\"{}\"/>\n{}</svg>\n",
                     open_svg(width, height, attributes), ground, body);
}

std::string svg_text_at(double x, double y, std::string_view attributes, std::string_view text) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" {}>{}</text>\n", x, y, attributes, text);
}

std::string svg_line(double x1, double y1, double x2, double y2, std::string_view colour) {
  return fmt::format(
      "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\"/>\n", x1, y1, x2,
      y2, colour);
}

std::string svg_frame(double x, double y, double width, double height, std::string_view colour) {
  return fmt::format(
      "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"none\" "
      "stroke=\"{}\"/>\n",
      x, y, width, height, colour);
}

std::string svg_disc(double x, double y, double radius, std::string_view fill,
                     std::string_view title) {
  const std::string disc =
      fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:g}\" fill=\"{}\"", x, y, radius, fill);
  return title.empty() ? disc + "/>\n"
                       : disc + fmt::format("><title>{}</title></circle>\n", escape_xml(title));
}

}  // namespace treeline::report
