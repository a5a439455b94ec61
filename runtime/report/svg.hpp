#pragma once

#include <string>
#include <string_view>

namespace treeline::report {

/// A text as it may stand in an element or an attribute.
std::string escape_xml(std::string_view text);

/// Opens a picture of its own, SVG 1.1. Sizes are in pixels; `attributes` are more of the root's.
std::string open_svg(double width, double height, std::string_view attributes);

/// A picture of its own: `body` on a ground of one colour.
std::string svg_page(double width, double height, std::string_view attributes,
                     std::string_view body, std::string_view ground = "white");

/// A line of text. What is no markup of SVG must be escaped.
std::string svg_text_at(double x, double y, std::string_view attributes, std::string_view text);

/// A straight line of one pixel.
std::string svg_line(double x1, double y1, double x2, double y2, std::string_view colour);

/// A rectangle that is not filled, as around axes.
std::string svg_frame(double x, double y, double width, double height, std::string_view colour);

/// A disc. `title` is what a browser shows for it: text, not markup; empty: nothing.
std::string svg_disc(double x, double y, double radius, std::string_view fill,
                     std::string_view title = {});

}  // namespace treeline::report
