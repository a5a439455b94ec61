#include "compilation/write_work_file.hpp"

#include <fstream>
#include <system_error>

namespace treeline {

bool write_work_file(const std::filesystem::path& path, const std::string& bytes,
                     Diagnostics& diagnostics) {
  std::error_code ignored;  // the stream tells
  std::filesystem::create_directories(path.parent_path(), ignored);
  std::ofstream stream(path, std::ios::binary);
  stream << bytes;
  stream.close();
  if (stream) return true;
  diagnostics.add({Severity::error, path, 0, "", "cannot be written to its end",
                   "free some space there, or name a folder with more: --output, TMPDIR"});
  return false;
}

}  // namespace treeline
