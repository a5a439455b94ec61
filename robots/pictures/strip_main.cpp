// Draws a robot at several moments of a recorded motion. Exit status: 0 drawn, 1 bad input, 2
// usage.
#include <fmt/core.h>
#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

#include <CLI/CLI.hpp>
#include <fstream>

#include "draw_strip.hpp"

namespace {

using namespace treeline;  // NOLINT: a program, not a header

struct Options {
  std::string urdf, csv, svg;
  pictures::StripSettings strip;
};

int fail(const std::string& error) {
  fmt::print(stderr, "draw_strip: {}\n", error);
  return 1;
}

int run(const Options& options) {
  const auto robot = urdf::parseURDFFile(options.urdf);
  if (!robot) return fail(options.urdf + ": cannot be read as URDF");
  std::string error;
  const pictures::Motion motion = pictures::read_motion(options.csv, error);
  if (!error.empty()) return fail(error);
  const std::string text = pictures::draw_strip(*robot, motion, options.strip, error);
  if (!error.empty()) return fail(error);
  std::ofstream file(options.svg, std::ios::binary);
  file << text << std::flush;
  return file ? 0 : fail(options.svg + ": cannot be written");
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Draw a robot at several moments of a motion, side by side, as SVG"};
  Options options;
  app.add_option("urdf", options.urdf, "the robot")->required();
  app.add_option("csv", options.csv, "the motion: columns time and q_JOINT")->required();
  app.add_option("--svg", options.svg, "file to write")->required();
  app.add_option("--times", options.strip.times, "s, a picture each")->delimiter(',')->required();
  app.add_option("--path", options.strip.path, "columns x,y,z of a point whose path is drawn")
      ->delimiter(',')
      ->expected(3);
  app.add_option("--azimuth", options.strip.azimuth, "of the camera, rad")->capture_default_str();
  app.add_option("--elevation", options.strip.elevation, "of the camera, rad")
      ->capture_default_str();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  return run(options);
}
