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
    const std::string error = servo::write_text(file.path, file.text);
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

void add_outputs(CLI::App& app, OutputPaths& paths, const std::string& csv_help,
                 const std::string& svg_help) {
  app.add_option("--csv", paths.csv, csv_help);
  app.add_option("--svg", paths.svg, svg_help);
}

void add_output_folder(CLI::App& app, std::string& folder, const std::string& content) {
  app.add_option("--output", folder, "existing folder for " + content)
      ->check(CLI::ExistingDirectory);
}

void add_substeps(CLI::App& app, int& substeps) {
  app.add_option("--substeps", substeps, "integration steps per cycle")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
}

std::string file_in(const std::string& folder, const std::string& name) {
  return folder.empty() ? "" : folder + "/" + name;
}

OutputFile csv_file(const std::string& path, const servo::Table& table) {
  return {path, path.empty() ? "" : servo::csv_text(table)};
}

OutputFile svg_file(const std::string& path, const servo::Plot& figure) {
  return {path, path.empty() ? "" : servo::svg_text(figure)};
}

std::vector<OutputFile> files_of(const OutputPaths& paths, const servo::Table& table,
                                 const servo::Plot& figure) {
  return {csv_file(paths.csv, table), svg_file(paths.svg, figure)};
}

std::vector<OutputFile> files_of_both(const OutputPaths& paths, const servo::Table& table,
                                      const std::string& suffix, const servo::Table& compared,
                                      const servo::Plot& figure) {
  const std::string other = paths.csv.empty() ? "" : paths.csv + suffix;
  return {csv_file(paths.csv, table), csv_file(other, compared), svg_file(paths.svg, figure)};
}

int run_experiment(CLI::App& app, int argc, char** argv, const std::function<Findings()>& run) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
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
