#include "command_line/run_experiment.hpp"

#include <fmt/core.h>

#include <cstdio>
#include <filesystem>

namespace treeline::experiments {
namespace {

/// Writes the files that have a path. Returns what could not be written; empty if all could.
std::string write_files(const std::vector<OutputFile>& files) {
  for (const OutputFile& file : files) {
    if (file.path.empty()) continue;
    const std::string error = report::write_text(file.path, file.text);
    if (!error.empty()) return error;
  }
  return "";
}

}  // namespace

Findings bad_input(const std::string& error) {
  Findings findings;
  findings.error = error;
  return findings;
}

void add_outputs(CommandLine& command, OutputPaths& paths, const std::string& csv_help,
                 const std::string& svg_help) {
  command.add_text("--csv", paths.csv, csv_help);
  command.add_text("--svg", paths.svg, svg_help);
}

void add_page_table(CommandLine& command, std::string& path) {
  command.add_text("--table", path, "write the table of the robot's page into this file");
}

void add_output_folder(CommandLine& command, std::string& folder, const std::string& content) {
  command.add_folder("--output", folder, "existing folder for " + content);
}

void add_substeps(CommandLine& command, int& substeps) {
  command.add_count("--substeps", substeps, 1000, "integration steps per cycle");
}

std::string file_in(const std::string& folder, const std::string& name) {
  return folder.empty() ? "" : folder + "/" + name;
}

OutputFile csv_file(const std::string& path, const report::Table& table) {
  return {path, path.empty() ? "" : report::csv_text(table)};
}

OutputFile svg_file(const std::string& path, const report::Plot& figure) {
  return {path, path.empty() ? "" : report::svg_text(figure)};
}

std::vector<OutputFile> files_of(const OutputPaths& paths, const report::Table& table,
                                 const report::Plot& figure) {
  return {csv_file(paths.csv, table), svg_file(paths.svg, figure)};
}

std::vector<OutputFile> files_of_both(const OutputPaths& paths, const report::Table& table,
                                      const std::string& suffix, const report::Table& compared,
                                      const report::Plot& figure) {
  const std::string other = paths.csv.empty() ? "" : paths.csv + suffix;
  return {csv_file(paths.csv, table), csv_file(other, compared), svg_file(paths.svg, figure)};
}

int run_experiment(CommandLine& command, int argc, char** argv,
                   const std::function<Findings()>& run) {
  if (const auto status = command.parse(argc, argv)) return *status;
  const std::string program = std::filesystem::path(argv[0]).filename().string();
  const Findings findings = run();
  fmt::print("{}", findings.summary);
  for (const std::string& error : {write_files(findings.files), findings.error}) {
    if (error.empty()) continue;
    fmt::print(stderr, "{}: {}\n", program, error);
    return 1;
  }
  return findings.claims_hold ? 0 : 3;
}

}  // namespace treeline::experiments
