#include <algorithm>
#include <vector>

#include "emission/backend.hpp"
#include "emission/body_steps.hpp"
#include "emission/descriptions.hpp"
#include "emission/print_files.hpp"
#include "emission/print_link_inputs.hpp"
#include "emission/print_link_table.hpp"
#include "emission/templates.hpp"
#include "target/target.hpp"

namespace treeline {
namespace {

using Loops = std::vector<const LinkLoops*>;

Loops list_loops(const Contents& contents) {
  Loops loops;
  for (const Program& program : contents.all) {
    if (program.loops) loops.push_back(program.loops.get());
  }
  return loops;
}

template <class Is>
bool any(const Loops& loops, const Is& is) {
  return std::any_of(loops.begin(), loops.end(), [&](const LinkLoops* each) { return is(*each); });
}

/// The table that has what others have.
const LinkTableData& find_largest(const Loops& loops) {
  const auto found = std::find_if(loops.begin(), loops.end(),
                                  [](const auto* each) { return has_points(each->table); });
  return found == loops.end() ? loops.front()->table : (*found)->table;
}

/// What the robot's tables have.
void add_kinds(const Contents& contents, const Loops& loops, Adaptation& own) {
  const LinkTableData& table = find_largest(loops);
  const std::pair<const char*, bool> kinds[] = {
      {"TL_FLOATS", table.floats},
      {"TL_SLIDING", table.sliding},
      {"TL_DRIVEN", !table.drives.empty()},
      {"TL_RUBBING", !table.frictions.empty()},
      {"TL_COUPLED", !table.couplings.empty()},
      {"TL_ARTICULATED", table.couplings.empty()},
      {"TL_OWN_SINES", table.own_sines},
      {"TL_BALLS", !table.balls.empty()},
      {"TL_PUSHED", !table.pushed_points.empty()},
      {"TL_LOADED", !table.loaded_links.empty()},
      {"TL_SORTED", !table.row_entries.empty()},
      {"TL_STEPPED", any(loops, changes_rotors)},
      {"TL_GROUNDED", table.grounded},
      {"TL_FREED", table.freed},
      {"TL_TURNING", table.turning},
      {"TL_GIVEN_SINES", std::any_of(contents.all.begin(), contents.all.end(), takes_sines)}};
  for (const auto& [word, has] : kinds) own.words[word] = has ? "1" : "0";
}

/// Sizes of the arrays in which the functions compute, of which each has an entry.
std::string print_array_sizes(const Loops& loops, const std::string& text, const Adaptation& own) {
  const LinkTableData& table = find_largest(loops);
  const auto size = [](std::size_t count) {
    return static_cast<int>(std::max<std::size_t>(count, 1));
  };
  std::vector<Constant> sizes = {
      {"LINKS", size(table.links.size()), ""},
      {"SLOTS", table.slots, ""},
      {"TURNED", table.rotations, ""},
      {"POINTS", size(table.points.size()), ""},
      {"ROWS", size(table.rows.size()), ""},
      {"RANKED", any(loops, is_ranked) ? size(table.rows.size()) : 1, ""},
      {"BASE_ENTRIES", size(count_base_entries(table)), ""}};
  std::erase_if(sizes, [&](const Constant& each) {
    return text.find(std::string("TL_") + each.name) == text.npos;
  });
  std::string constants = print_constants(own, sizes);
  constants.pop_back();  // the end of the line, which the text has
  return "// Of the robot's tables.\n" + constants;
}

/// What compilers are told of the functions: which they inline, where that pays, and which several
/// functions share. What one function alone calls is static: compilers make less of it.
void add_inlining(const Contents& contents, Adaptation& own) {
  const EmissionContext& context = contents.context;
  const bool in_c = !backend_of(context.language).has_namespaces;
  const bool alone = in_c || count_loops(contents.all) == 1;
  const bool emulated = emulates(*find_target(context.target), number_bytes(context));
  const bool folds = !context.misra && !emulated;
  const auto add = [&](const std::string& prefix, const std::string& linkage) {
    own.words[prefix + "INLINE"] = linkage + "inline";
    own.words[prefix + "FOLDED"] = linkage + (folds ? "TREELINE_LINK_INLINE" : "inline");
    own.words[prefix + "SHARED"] = linkage + "inline";
  };
  add("TL_", alone ? "static " : "");
  add("TL_OWN_", "static ");
  if (!context.misra && !alone) own.words["TL_SHARED"] = "TREELINE_LINK_SHARED inline";
}

/// All headers, in the order in which they need each other.
std::string join_all(const EmissionContext& context, const Adaptation& own) {
  const std::string& plain = own.words.at("TL_INLINE");
  std::vector<std::string_view> headers;
  if (own.words.at("TL_FOLDED") != plain) headers.push_back(templates::kLinkInline);
  if (own.words.at("TL_SHARED") != plain) headers.push_back(templates::kLinkShared);
  headers.insert(headers.end(), {templates::kLinkTypes, "TL_SIZES\n", templates::kLinkWork});
  if (backend_of(context.language).has_references) headers.push_back(kSinesByPointers);
  headers.insert(headers.end(),
                 {templates::kLinkVectors, templates::kLinkJoints, templates::kLinkPose,
                  templates::kLinkFriction, templates::kLinkMotion, templates::kLinkInertia,
                  templates::kLinkInputs, templates::kLinkMatrix, templates::kLinkFactors,
                  templates::kLinkArticulation, templates::kLinkPoints, templates::kLinkRows,
                  templates::kLinkFactored});
  return join_headers(headers, templates::kLinkFunctions);
}

}  // namespace

bool takes_sines(const Program& program) {
  return program.loops && program.arguments.size() > 1 && program.arguments[1].name == "sin_q";
}

Adaptation name_loops(const EmissionContext& context) {
  Adaptation own = make_adaptation(context, header_name(context, context.name));
  own.part = "loops";
  return own;
}

std::string adapt_loops(const Contents& contents, std::span<const NameSet> named) {
  const EmissionContext& context = contents.context;
  const Loops loops = list_loops(contents);
  Adaptation own = name_loops(context);
  add_kinds(contents, loops, own);
  add_inlining(contents, own);
  if (!backend_of(context.language).has_references) {
    own.words["tl_sin_cos_of"] = context.name + "_sin_cos_of";
  }
  const std::string text = keep_named(choose_branches(join_all(context, own), own), named);
  own.words["TL_SIZES"] = print_array_sizes(loops, text, own);
  return adapt(text, own);
}

}  // namespace treeline
