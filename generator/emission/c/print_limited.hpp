#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "emission/contents.hpp"
#include "emission/generated_file.hpp"

namespace treeline::c {

/// NAME_limited.h and limited_control_torque.c, composed of others of the functions. `context` has
/// `limits`. Throws std::logic_error where a function that is called is missing.
std::vector<GeneratedFile> print_limited(const Contents& contents);

/// NAME_batch_limited.h and batch_limited_control_torque.c: limited control of several states, from
/// their functions.
std::vector<GeneratedFile> print_batch_limited(const Contents& contents);

/// Lists the texts for the holes in the templates of limited control in every language.
std::map<std::string, std::string> list_limit_holes(const EmissionContext& context);

/// The template with those of the holes that it has.
std::string fill_limits(std::string_view text, const std::map<std::string, std::string>& holes);

}  // namespace treeline::c
