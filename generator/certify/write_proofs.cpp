#include "certify/write_proofs.hpp"

#include <fmt/format.h>

#include <system_error>

#include "compilation/write_work_file.hpp"

namespace treeline {

namespace fs = std::filesystem;

bool write_proofs(const fs::path& folder, const std::string& function,
                  const std::vector<ProofStep>& steps, Precision precision,
                  Diagnostics& diagnostics) {
  const fs::path own = folder / function;
  std::error_code none;  // a folder that is not there has no old steps
  for (const auto& entry : fs::directory_iterator(own, none)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("step_") && entry.path().extension() == ".g") fs::remove(entry.path());
  }
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const fs::path file = own / fmt::format("step_{:04}.g", i + 1);
    if (!write_work_file(file, print_step(steps[i], precision, false), diagnostics)) return false;
  }
  return true;
}

}  // namespace treeline
