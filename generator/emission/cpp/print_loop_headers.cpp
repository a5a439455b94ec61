#include "emission/cpp/print_loop_headers.hpp"

#include "emission/cpp/print_loops.hpp"
#include "emission/cpp/templates.hpp"
#include "emission/describe_program.hpp"
#include "emission/inline_links.hpp"
#include "emission/keep_called.hpp"
#include "emission/parse_loops.hpp"
#include "emission/print_link_table.hpp"

namespace treeline::cpp {
namespace {

constexpr std::string_view kFolder = "core/";
constexpr std::string_view kNamespace = "namespace treeline::core::loops {\n";

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

std::vector<LoopTemplate> list_loop_templates(std::span<const Program> programs) {
  std::vector<LoopTemplate> headers = {{"link_vectors", templates::kLinkVectors},
                                       {"link_table", templates::kLinkTable},
                                       {"link_pose", templates::kLinkPose},
                                       {"link_factors", templates::kLinkFactors},
                                       {"link_friction", templates::kLinkFriction},
                                       {"link_motion", templates::kLinkMotion},
                                       {"link_inertia", templates::kLinkInertia},
                                       {"link_matrix", templates::kLinkMatrix},
                                       {"link_articulation", templates::kLinkArticulation},
                                       {"link_rows", templates::kLinkRows},
                                       {"link_functions", templates::kLinkFunctions}};
  if (has_inputs(programs)) headers.push_back({"link_inputs", templates::kLinkInputs});
  return headers;
}

std::vector<GeneratedFile> print_loop_headers(const EmissionContext& context,
                                              std::span<const Program> programs) {
  // `prefetch` loads a function with what it calls: each has the loops in its own section.
  const Sharing sharing =
      count_loops(programs) > 1 && !context.prefetch ? Sharing::linkers : Sharing::compilers;
  std::vector<LoopHeader> headers;
  for (const LoopTemplate& each : list_loop_templates(programs)) {
    headers.push_back(
        read_header(each.stem + ".hpp", settle_inlining(context, each.text, sharing)));
  }
  const auto print_body = [&](const Program& program) { return print_loop_body(context, program); };
  keep_called(join_callers(programs, print_body, print_loops(context, programs)), headers);
  std::vector<GeneratedFile> files;
  for (const LoopHeader& header : headers) {
    files.push_back({header.name.substr(kFolder.size()), print_kept(header)});
  }
  return files;
}

}  // namespace treeline::cpp
