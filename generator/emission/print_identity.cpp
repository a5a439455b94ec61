#include <fmt/format.h>

#include <algorithm>

#include "emission/backend.hpp"
#include "emission/emitted_text.hpp"
#include "emission/generated_file.hpp"
#include "emission/print_files.hpp"
#include "emission/print_manifest.hpp"
#include "emission/templates.hpp"

namespace treeline {
namespace {

/// Text that precedes the digest.
std::string print_what_it_is(const EmissionContext& context) {
  return fmt::format("treeline {} {} sha256 ", generator_version(), context.name);
}

}  // namespace

std::string digest_of_files(const std::vector<GeneratedFile>& files) {
  std::vector<std::string> lines;
  for (const GeneratedFile& file : files) {
    const std::string stem = file.name.substr(0, file.name.find('.'));
    if (file.name == kManifestName || stem == kIdentityStem) continue;
    lines.push_back(fmt::format("{}  {}\n", digest(file.text), file.name));
  }
  constexpr std::size_t kDigits = 64;
  std::sort(lines.begin(), lines.end(), [](const std::string& a, const std::string& b) {
    return a.substr(kDigits) < b.substr(kDigits);
  });
  std::string list;
  for (const std::string& line : lines) list += line;
  return digest(list);
}

std::size_t size_of_identity(const EmissionContext& context) {
  return print_what_it_is(context).size() + digest({}).size() + 1;
}

GeneratedFile print_identity(const EmissionContext& context,
                             const std::vector<GeneratedFile>& files) {
  const Backend& backend = backend_of(context.language);
  return {
      kIdentityStem + std::string(backend.source),
      fill_template(templates::kIdentity, {{"name", context.name},
                                           {"header", context.name + std::string(backend.header)},
                                           {"constant", std::string(backend.constant)},
                                           {"size", std::to_string(size_of_identity(context))},
                                           {"what", print_what_it_is(context)},
                                           {"digest", digest_of_files(files)}})};
}

}  // namespace treeline
