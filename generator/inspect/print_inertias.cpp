#include "inspect/print_inertias.hpp"

#include <fmt/format.h>

#include <cmath>

#include "text/align_columns.hpp"

namespace treeline {
namespace {

using Rows = std::vector<std::vector<std::string>>;

std::string effect(const LinkReport& link) {
  if (link.felt) return "the motion feels it";
  return link.nearest ? "hidden: possible bodies move the same" : "";
}

std::string print_unphysical(const Report& report) {
  Rows rows;
  bool felt = false;
  for (const LinkReport& link : report.links) {
    if (!link.unphysical) continue;
    rows.push_back({link.name, effect(link)});
    rows.push_back({"  " + *link.unphysical, ""});
    felt = felt || link.felt;
  }
  if (rows.empty()) return {};
  std::string text =
      "\ninertias that are not physical\n" + align_columns({{"link"}, {""}}, rows, page_columns());
  if (felt) {
    text +=
        "  The nearest possible inertia of those that the motion feels keeps mass and centre of\n"
        "  mass and changes the second moments of mass by the least Frobenius norm. A patch of "
        "the\n"
        "  URDF follows below; `--repair FILE` writes the URDF with it.\n";
  }
  return text;
}

std::string print_flat(const Report& report) {
  Rows rows;
  for (const LinkReport& link : report.links) {
    if (link.flat) rows.push_back({link.name, *link.flat});
  }
  if (rows.empty()) return {};
  return "\nbodies without extent in some direction (possible, no fault)\n" +
         align_columns({{"link"}, {"all mass is in"}}, rows, page_columns());
}

}  // namespace

std::string print_inertias(const Report& report) {
  return print_unphysical(report) + print_flat(report);
}

}  // namespace treeline
