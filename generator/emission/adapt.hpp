#pragma once

#include <initializer_list>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "emission/emission_context.hpp"

namespace treeline {

/// How the headers of runtime/emitted are written for a robot.
struct Adaptation {
  Language language = Language::cpp;
  std::string name;      ///< the robot's: prefix in C, namespace in C++
  std::string contract;  ///< the header that the reader is sent to
  /// What stands for words of the header: `real` -> `double`, `TL_ZERO` -> `0.0`.
  std::map<std::string, std::string, std::less<>> words;
  std::string suffix = {};      ///< of literals, which headers write as `TL_REAL(1.5)`
  bool constants_of_c = false;  ///< constants are called in C++ as they are in C
  std::string part = {};        ///< prefix behind the name in C, namespace in `detail` in C++
};

/// The words that every header of runtime/emitted has: the type of numbers, small numbers, and what
/// stands before a function.
Adaptation make_adaptation(const EmissionContext& context, const std::string& contract);

/// A word and the number that stands for it, as it is written: `{"TL_HALF", "0.5"}`.
using WordOfNumber = std::pair<const char*, const char*>;

/// Adds words for numbers, as literals of the context's type.
void add_literals(const EmissionContext& context, std::initializer_list<WordOfNumber> numbers,
                  Adaptation& own);

/// Adds the words for how numbers are made of bits: `TlBits`, an integer of their size, and sizes
/// of their fields.
void add_number_format(const EmissionContext& context, Adaptation& own);

/// `UNKNOWNS` as a constant of the robot's is called: `ARM_UNKNOWNS`, in C++ `kUnknowns`.
std::string constant_name(const Adaptation& own, std::string_view name);

/// Whether a name may have this character.
bool belongs_to_word(char c);

/// The text without branches that a robot does not have, and without the conditions of those that
/// it has: of `#if TL_TASK`, and of `if (TL_TASK) {`, whose words are 1 or 0.
std::string choose_branches(std::string_view text, const Adaptation& own);

/// The text of a header of runtime/emitted with the robot's names. `tl_root`, `TlConeRow` and
/// `TL_UNKNOWNS` become `arm_root`, `arm_cone_row` and `ARM_UNKNOWNS`, in C++ `root`, `ConeRow` and
/// `kUnknowns`; words of `own` become what it says, names of headers end as the language's do, but
/// for the contract's. Branches are chosen.
std::string adapt_words(std::string_view text, const Adaptation& own);

/// A whole header: in C++ what is behind its includes is in the namespace `arm::detail`.
std::string adapt(std::string_view header, const Adaptation& own);

/// Several headers as one: the last, with what the others declare behind its includes.
std::string join_headers(std::span<const std::string_view> others, std::string_view last);

/// What is behind a header's includes, for another file.
std::string adapt_declarations(std::string_view header, const Adaptation& own);

}  // namespace treeline
