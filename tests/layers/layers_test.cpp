// Would catch: a folder that includes one above it, so that neither can be understood, built or
// replaced without the other; and a row of the table below that is outdated.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace treeline::tests {
namespace {

namespace fs = std::filesystem;

/// A folder and all other folders that its files may include.
struct Layer {
  std::string folder;
  std::set<std::string> includes;
};

/// From the bottom up: every folder includes only folders listed above its row.
const std::vector<Layer> kLayers = {
    // What runs on the robot, its records, and its reference.
    {"emitted", {}},
    {"core", {"emitted"}},
    {"report", {}},
    {"batch", {}},
    {"digits", {}},
    {"interpreter", {"digits"}},
    {"firmware", {"core"}},
    {"servo", {"core"}},
    {"show", {"core"}},
    {"drive", {"core", "servo", "show"}},
    {"simulation", {"core", "interpreter"}},
    // The path of the data: files, mechanism, program, text.
    {"text", {}},
    {"interruption", {}},
    {"functions", {}},
    {"joint", {}},
    {"target", {}},
    {"description", {"text", "functions", "joint", "target", "drive"}},
    {"terminal", {"text", "description"}},
    {"mechanism", {"digits", "joint", "description"}},
    {"program", {"core", "emitted"}},
    {"recursion", {"functions", "core", "description", "mechanism", "program"}},
    {"passes", {"program", "target"}},
    {"bounds", {"text", "functions", "description", "mechanism", "program"}},
    {"choice",
     {"text", "functions", "core", "target", "description", "mechanism", "program", "recursion",
      "passes", "bounds"}},
    {"emission", {"text", "core", "interruption", "target", "description", "program", "passes"}},
    {"generation",
     {"text", "functions", "description", "mechanism", "program", "recursion", "passes", "bounds",
      "choice", "emission"}},
    {"packaging", {"text", "target", "description", "program", "passes", "emission", "generation"}},
    // What tries, judges and explains it.
    {"oracle",
     {"text", "functions", "interpreter", "description", "mechanism", "program", "recursion",
      "bounds", "choice", "emission"}},
    {"trial", {"text", "functions", "description", "mechanism", "choice", "oracle", "generation"}},
    {"compilation", {"text", "interruption", "emission", "generation", "oracle"}},
    {"inspect",
     {"text", "functions", "interpreter", "description", "mechanism", "recursion", "bounds",
      "oracle"}},
    {"drawing", {"text", "report", "interpreter", "description", "mechanism", "oracle"}},
    {"comparison", {"text", "interpreter", "description", "bounds", "oracle"}},
    {"check",
     {"text", "functions", "core", "interpreter", "description", "program", "passes", "bounds",
      "choice", "emission", "generation", "oracle", "compilation"}},
    {"board",
     {"text", "core", "target", "emission", "generation", "oracle", "compilation", "check"}},
    {"certify",
     {"text", "functions", "description", "program", "bounds", "emission", "generation",
      "compilation"}},
    {"safety", {"text", "description", "bounds", "emission", "generation"}},
    {"timing", {"text", "choice", "emission", "generation", "oracle", "compilation"}},
    {"bench",
     {"text", "report", "interpreter", "description", "mechanism", "choice", "emission",
      "generation", "oracle", "compilation", "check", "timing"}},
    {"launch",
     {"text", "drive", "description", "mechanism", "emission", "generation", "oracle", "trial",
      "compilation"}},
    {"driving",
     {"text", "terminal", "report", "servo", "drive", "interruption", "description", "drawing",
      "launch"}},
    {"cli", {"text",       "functions",    "target",     "interpreter", "drive",       "launch",
             "simulation", "interruption", "board",      "description", "mechanism",   "program",
             "passes",     "emission",     "generation", "oracle",      "compilation", "inspect",
             "drawing",    "comparison",   "check",      "timing",      "bench",       "packaging",
             "certify",    "safety",       "report",     "choice",      "trial",       "terminal",
             "driving"}},
};

/// Folders within a folder from the bottom up: files include their own folder and those before it.
struct Inside {
  std::string folder;
  std::vector<std::string> parts;  ///< "" are the files beside them
  bool headers_only;
};
const std::vector<Inside> kInside = {
    // A source may call what stands above: base parameters about mimics are told apart by energies.
    {"recursion", {"algebra", "parameters", "tree", "methods", "routes"}, true},
    {"emission", {"", "misra", "c", "opencl", "cpp", "languages"}, false}};

bool is_source(const fs::path& path) {
  return path.extension() == ".cpp" || path.extension() == ".hpp" || path.extension() == ".h";
}

bool has_sources(const fs::path& folder) {
  const fs::recursive_directory_iterator files(folder);
  return std::any_of(begin(files), end(files), [](const auto& e) { return is_source(e.path()); });
}

/// Folders that the files of one folder include, each with a file that does.
std::map<std::string, std::string> included_by(const fs::path& folder) {
  constexpr std::string_view kInclude = "#include \"";
  std::map<std::string, std::string> found;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!is_source(entry.path())) continue;
    std::ifstream stream(entry.path());
    for (std::string line; std::getline(stream, line);) {
      const auto slash = line.find('/');
      if (!line.starts_with(kInclude) || slash == std::string::npos) continue;
      found[line.substr(kInclude.size(), slash - kInclude.size())] = entry.path().string();
    }
  }
  found.erase(folder.filename().string());
  return found;
}

fs::path find_folder(const std::string& name) {
  for (const char* parent : {"generator", "runtime"}) {
    const fs::path path = fs::path(TREELINE_SOURCE_DIR) / parent / name;
    if (fs::is_directory(path)) return path;
  }
  return {};
}

TEST(Layers, IncludeOnlyWhatStandsBelow) {
  std::set<std::string> below;
  for (const Layer& layer : kLayers) {
    for (const std::string& folder : layer.includes) {
      EXPECT_TRUE(below.contains(folder)) << layer.folder << " may not include " << folder;
    }
    below.insert(layer.folder);
  }
}

TEST(Layers, AreThoseOfTheSources) {
  for (const Layer& layer : kLayers) {
    const fs::path path = find_folder(layer.folder);
    ASSERT_FALSE(path.empty()) << layer.folder << " is no folder";
    std::set<std::string> seen;
    for (const auto& [folder, file] : included_by(path)) {
      // Peers of `bench`, and files whose folder is not here, belong to other libraries.
      if (find_folder(folder).empty()) continue;
      EXPECT_TRUE(layer.includes.contains(folder)) << file << " includes " << folder;
      seen.insert(folder);
    }
    for (const std::string& folder : layer.includes) {
      EXPECT_TRUE(seen.contains(folder)) << layer.folder << " no longer includes " << folder;
    }
  }
}

/// Parts of the folder that a file includes.
std::vector<std::string> parts_included_by(const fs::path& file, const std::string& folder) {
  const std::string include = "#include \"" + folder + "/";
  std::vector<std::string> parts;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    if (!line.starts_with(include)) continue;
    const auto slash = line.find('/', include.size());
    parts.push_back(
        slash == std::string::npos ? "" : line.substr(include.size(), slash - include.size()));
  }
  return parts;
}

TEST(Layers, PartsOfAFolderIncludeOnlyWhatStandsBefore) {
  for (const Inside& inside : kInside) {
    const fs::path folder = find_folder(inside.folder);
    std::set<std::string> before;
    for (const std::string& part : inside.parts) {
      before.insert(part);
      ASSERT_TRUE(has_sources(folder / part)) << folder / part;
      for (const auto& entry : fs::directory_iterator(folder / part)) {
        const bool is_header = entry.path().extension() == ".hpp";
        if (!is_header && (inside.headers_only || !is_source(entry.path()))) continue;
        for (const std::string& included : parts_included_by(entry.path(), inside.folder)) {
          EXPECT_TRUE(before.contains(included)) << entry.path() << " includes " << included;
        }
      }
    }
    for (const auto& entry : fs::directory_iterator(folder)) {
      if (!entry.is_directory()) continue;
      EXPECT_TRUE(before.contains(entry.path().filename().string())) << entry << " has no row";
    }
  }
}

TEST(Layers, HaveARowEach) {
  for (const char* parent : {"generator", "runtime"}) {
    for (const auto& entry : fs::directory_iterator(fs::path(TREELINE_SOURCE_DIR) / parent)) {
      if (!entry.is_directory() || !has_sources(entry.path())) continue;
      const std::string name = entry.path().filename().string();
      const bool listed = std::any_of(kLayers.begin(), kLayers.end(),
                                      [&](const Layer& layer) { return layer.folder == name; });
      EXPECT_TRUE(listed) << name << " has no row in the table above";
    }
  }
}

}  // namespace
}  // namespace treeline::tests
