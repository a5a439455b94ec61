#include "certify/write_proofs.hpp"

#include <fmt/format.h>

#include <fstream>
#include <system_error>

namespace treeline {

namespace fs = std::filesystem;

bool write_proofs(const fs::path& folder, const std::string& function,
                  const std::vector<ProofStep>& steps, Precision precision,
                  Diagnostics& diagnostics) {
  const fs::path own = folder / function;
  std::error_code fault;
  fs::create_directories(own, fault);
  if (!fault) {
    for (const auto& entry : fs::directory_iterator(own, fault)) {
      const std::string name = entry.path().filename().string();
      if (name.starts_with("step_") && entry.path().extension() == ".g") fs::remove(entry.path());
    }
  }
  for (std::size_t i = 0; !fault && i < steps.size(); ++i) {
    std::ofstream file(own / fmt::format("step_{:04}.g", i + 1));
    file << print_step(steps[i], precision, false);
    file.close();
    if (!file) fault = std::make_error_code(std::errc::io_error);
  }
  if (!fault) return true;
  diagnostics.add({Severity::error, own.string(), 0, "", "cannot be written: " + fault.message(),
                   "Name another folder with --output."});
  return false;
}

}  // namespace treeline
