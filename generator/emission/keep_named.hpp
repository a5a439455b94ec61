#pragma once

#include <set>
#include <span>
#include <string>
#include <string_view>

namespace treeline {

/// Names as runtime/emitted has them: `tl_move_links`, `TlLinkMotion`.
using NameSet = std::set<std::string, std::less<>>;

/// The text of headers of runtime/emitted without types and functions that neither the users, each
/// by what it names, nor what stays name. Each of these stands between empty lines, with its
/// comment; all else stays. The word before a function that one user alone comes to begins with
/// `TL_OWN_` then, such as `TL_OWN_INLINE`.
std::string keep_named(std::string_view text, std::span<const NameSet> users);

}  // namespace treeline
