#include "emission/cpp/print_loop_headers.hpp"

#include "emission/cpp/print_core_header.hpp"
#include "emission/cpp/print_loops.hpp"
#include "emission/describe_program.hpp"
#include "emission/inline_links.hpp"
#include "emission/keep_called.hpp"
#include "emission/loop_templates.hpp"
#include "emission/misra/follow_rules.hpp"
#include "emission/parse_loops.hpp"

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

std::vector<GeneratedFile> print_loops(const Contents& contents) {
  const EmissionContext& context = contents.context;
  const std::vector<Program>& programs = contents.all;
  // `prefetch` loads a function with what it calls: each has the loops in its own section.
  const Sharing sharing =
      count_loops(programs) > 1 && !context.prefetch ? Sharing::linkers : Sharing::compilers;
  std::vector<LoopHeader> headers;
  for (const LoopTemplate& each : list_loop_templates(programs)) {
    headers.push_back(
        read_header(each.stem + ".hpp", settle_inlining(context, each.text, sharing)));
  }
  const auto print_body = [&](const Program& program) { return print_loop_body(context, program); };
  std::vector<GeneratedFile> files = {print_link_tables(context, programs)};
  keep_called(join_callers(programs, print_body, files), headers);
  for (const LoopHeader& header : headers) {
    const std::string text = print_core_header(context, print_kept(header));
    files.push_back({header.name.substr(kFolder.size()),
                     context.misra ? misra::follow_rules(context, text) : text});
  }
  return files;
}

}  // namespace treeline::cpp
