#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "command_line/command_line.hpp"
#include "report/plot.hpp"
#include "report/table.hpp"

namespace treeline::experiments {

/// A file that an experiment writes if its user gave a path for it.
struct OutputFile {
  std::string path;  ///< empty: not written
  std::string text;
};

/// What an experiment found.
struct Findings {
  std::string summary = {};            ///< for the screen, with its line ends
  std::vector<OutputFile> files = {};  ///< written in this order, until one cannot be written
  bool claims_hold = false;
  std::string error = {};  ///< bad input, or why the run stopped; empty: neither
};

/// Findings that say only that the input is bad, and why.
Findings bad_input(const std::string& error);

/// Paths of the two files that most experiments write.
struct OutputPaths {
  std::string csv = {};
  std::string svg = {};
};

/// Adds the options --csv and --svg with an explanation each.
void add_outputs(CommandLine& command, OutputPaths& paths,
                 const std::string& csv_help = "write every cycle to this file",
                 const std::string& svg_help = "draw the figure into this file");

/// Adds the option --table: a table of the robot's page, which `report_tables` puts there.
void add_page_table(CommandLine& command, std::string& path);

/// Adds the option --output, an existing folder for `content`, such as "RUN.csv of each run".
void add_output_folder(CommandLine& command, std::string& folder, const std::string& content);

/// Adds the option --substeps, the integration steps per cycle.
void add_substeps(CommandLine& command, int& substeps);

/// The path of a file in `folder`. Empty if `folder` is: then the file is not written.
std::string file_in(const std::string& folder, const std::string& name);

/// The table as CSV and the figure as SVG. Text that is not written is not made.
OutputFile csv_file(const std::string& path, const report::Table& table);
OutputFile svg_file(const std::string& path, const report::Plot& figure);

/// The files of one run.
std::vector<OutputFile> files_of(const OutputPaths& paths, const report::Table& table,
                                 const report::Plot& figure);

/// The files of a run and of one that it is compared with, whose CSV file gets `suffix` behind its
/// name. The figure shows both.
std::vector<OutputFile> files_of_both(const OutputPaths& paths, const report::Table& table,
                                      const std::string& suffix, const report::Table& compared,
                                      const report::Plot& figure);

/// Adds the files of some runs that share a figure: the tables of `runs` in `folder` as `name` with
/// an ending each, and the figure as `name`.svg.
template <class Run, std::size_t count>
void add_runs(Findings& findings, const std::string& folder, const std::string& name,
              const char* const (&endings)[count], const std::vector<Run>& runs,
              const report::Plot& figure) {
  for (std::size_t i = 0; i < runs.size() && i < count; ++i) {
    findings.files.push_back(csv_file(file_in(folder, name + endings[i]), runs[i].table));
  }
  findings.files.push_back(svg_file(file_in(folder, name + ".svg"), figure));
}

/// Reads the command line, runs the experiment, prints its summary and writes its files. Returns
/// the exit status: 0 the claims hold, 1 bad input or a file cannot be written, 2 usage, 3 a claim
/// is broken. Errors are printed behind the program's name.
int run_experiment(CommandLine& command, int argc, char** argv,
                   const std::function<Findings()>& run);

}  // namespace treeline::experiments
