#pragma once

#include <string>
#include <vector>

namespace treeline::servo {

/// A curve over the plot's x. Dashed curves are thin and dark and lie on top: what was wanted.
struct PlotLine {
  std::string name;  ///< in the legend; without one, not there
  std::vector<double> values;
  bool dashed = false;
  std::vector<double> x = {};  ///< its own abscissae, in a panel that is a path
};

/// One set of axes.
struct PlotPanel {
  std::string title;
  std::string y_label;  ///< with the unit
  std::vector<PlotLine> lines;
  double least_span = 0.0;  ///< of the y axis, so that rounding errors are not blown up
  std::string path_x_label =
      {};  ///< not empty: a path in a plane, its lines over their own x, with
           ///< the unit; drawn taller and with one scale for both directions
};

/// Panels above each other that share the x axis; paths have their own.
struct Plot {
  std::string title;
  std::string x_label;  ///< with the unit
  std::vector<double> x;
  std::vector<PlotPanel> panels;
};

/// The plot as a stand-alone SVG 1.1 file. Curves are thinned to what a pixel column can show;
/// values that are not finite interrupt them.
std::string svg_text(const Plot& plot);

}  // namespace treeline::servo
