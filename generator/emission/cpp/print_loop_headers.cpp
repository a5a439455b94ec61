#include "emission/cpp/print_loop_headers.hpp"

#include <string>
#include <string_view>
#include <utility>

#include "emission/cpp/print_loops.hpp"
#include "emission/cpp/templates.hpp"
#include "emission/inline_links.hpp"
#include "emission/keep_called.hpp"
#include "emission/parse_loops.hpp"
#include "emission/print_link_table.hpp"

namespace treeline::cpp {
namespace {

constexpr std::string_view kFolder = "core/";
constexpr std::string_view kNamespace = "namespace treeline::core::loops {\n";

/// What uses the loops: the functions' bodies and the robot's tables.
std::string print_callers(const EmissionContext& context, std::span<const Program> programs) {
  std::string text;
  for (const Program& program : programs) {
    if (program.loops) text += print_loop_body(context, program);
  }
  for (const GeneratedFile& file : print_loops(context, programs)) text += file.text;
  return text;
}

LoopHeader read_header(const std::string& name, const std::string& text) {
  LoopHeader header{std::string(kFolder) + name, text.substr(0, text.find(kNamespace)), {}};
  for (const LoopItem& item : parse_loops(text)) {
    header.items.push_back({item.name(), !item.is_struct(), item.source});
  }
  return header;
}

std::string print_kept(const LoopHeader& header) {
  std::string text = header.opening + std::string(kNamespace);
  for (const LoopDeclaration& item : header.items) text += "\n" + item.text;
  return text + "\n}  // namespace treeline::core::loops\n";
}

}  // namespace

std::vector<GeneratedFile> print_loop_headers(const EmissionContext& context,
                                              std::span<const Program> programs) {
  std::vector<std::pair<const char*, std::string_view>> texts = {
      {"link_articulation.hpp", templates::kLinkArticulation},
      {"link_factors.hpp", templates::kLinkFactors},
      {"link_friction.hpp", templates::kLinkFriction},
      {"link_functions.hpp", templates::kLinkFunctions},
      {"link_inertia.hpp", templates::kLinkInertia},
      {"link_motion.hpp", templates::kLinkMotion},
      {"link_pose.hpp", templates::kLinkPose},
      {"link_rows.hpp", templates::kLinkRows},
      {"link_table.hpp", templates::kLinkTable},
      {"link_vectors.hpp", templates::kLinkVectors}};
  if (has_inputs(programs)) texts.emplace_back("link_inputs.hpp", templates::kLinkInputs);
  std::vector<LoopHeader> headers;
  for (const auto& [name, text] : texts) {
    headers.push_back(read_header(name, settle_inlining(context, text)));
  }
  keep_called(print_callers(context, programs), headers);
  std::vector<GeneratedFile> files;
  for (const LoopHeader& header : headers) {
    files.push_back({header.name.substr(kFolder.size()), print_kept(header)});
  }
  return files;
}

}  // namespace treeline::cpp
