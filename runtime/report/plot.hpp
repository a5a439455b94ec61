#pragma once

#include <string>
#include <vector>

namespace treeline::report {

/// A curve over the plot's x. Dashed curves, for desired values, are thin and dark and lie on top.
struct PlotLine {
  std::string name;  ///< name in the legend; empty: not listed
  std::vector<double> values;
  bool dashed = false;
  std::vector<double> x = {};  ///< own abscissae, if the panel is a path
};

/// One set of axes.
struct PlotPanel {
  std::string title;
  std::string y_label;  ///< with unit
  std::vector<PlotLine> lines;
  double least_span = 0.0;  ///< smallest span of the y axis, so that rounding errors are not
                            ///< magnified
  std::string path_x_label =
      {};  ///< label with unit; not empty: a path in a plane, whose lines have their own x; it is
           ///< taller and has equal scales in both directions
};

/// Panels on top of each other that share the x axis. Paths have x axes of their own.
struct Plot {
  std::string title;
  std::string x_label;  ///< with unit
  std::vector<double> x;
  std::vector<PlotPanel> panels;
};

/// Draws the plot as a stand-alone SVG 1.1 file. Curves are thinned to what a pixel column can
/// show. Values that are not finite interrupt a curve.
std::string svg_text(const Plot& plot);

}  // namespace treeline::report
