#pragma once

#include <tinyxml2.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "text/diagnostic.hpp"

namespace treeline {

/// Limits on a URDF's content; `read_text_file` limits its bytes, `read_urdf` its links. Within
/// these the document of a file of 64 MiB takes less than 1 GiB and seconds.
inline constexpr std::size_t kMostTags = 400'000;  ///< with end tags and comments
inline constexpr std::size_t kMostAttributes = 1'000'000;
inline constexpr std::size_t kMostAttributesOfElement = 64;  ///< they are compared with each other

/// Excess of a URDF, in words, and the byte at which it begins.
struct XmlExcess {
  std::string fault;
  std::size_t at = 0;
};

/// Looks for more than the bounds, before a document is built of the text.
std::optional<XmlExcess> find_excess(std::string_view text);

/// Content of a file that is not the XML asked for, and what to do about it.
struct StrayText {
  std::string fault, remedy;
};

/// Recognises what stands in the place of a file that did not arrive: a pointer of Git LFS, a
/// web page, or the path that a symbolic link leads to, where the link was copied as text. Else
/// nothing.
std::optional<StrayText> describe_stray_text(std::string_view text);

/// A tag that the reader of XML understands otherwise than it is written.
struct MisreadTag {
  int line = 0;  ///< from 1 on
  std::string fault, remedy;
};

/// The first tag of `text` that tinyxml2 let pass though it is no XML, or read as another element
/// than it says. It ends its reading, without a word, at an end tag that closes nothing; it takes
/// `</link name="a"/>` as an empty element, and `</link name="a">` as `</link>`. Where nothing is
/// returned, the elements of `document` are those that `next_tag` finds, in the same order.
std::optional<MisreadTag> find_misread_tag(const tinyxml2::XMLDocument& document,
                                           std::string_view text);

/// An element whose start tag has been read and whose end tag has not.
struct OpenElement {
  std::string name;
  std::string tag;  ///< `<link name="arm">`, or `<link>` without a name
  int line = 0;     ///< of the start tag, from 1 on
};

/// Element without its end tag in text that is no XML, and what stands in place of the end tag.
struct UnclosedElement {
  OpenElement open;
  std::string instead;  ///< the end tag that comes in place of its own; empty: the text ends
  int line = 0;         ///< of that
};

/// The first element that is not closed by its own end tag. Comments, CDATA, declarations and
/// quoted attributes are passed over. Nothing where tags fit, or where another fault comes first.
std::optional<UnclosedElement> find_unclosed_element(std::string_view text);

/// The innermost element that is open where that line begins; nothing outside the root.
std::optional<OpenElement> find_open_element(std::string_view text, int line);

/// References of the form `&name;` in attributes, to entities that XML itself does not define.
/// tinyxml2 leaves them as they are written; strict readers refuse the file.
struct UndefinedEntities {
  int line = 0;           ///< of the first, from 1 on
  std::string attribute;  ///< that has it
  std::string first;      ///< as written
  std::size_t count = 0;  ///< of all
};

/// Finds the undefined entities of the text; nothing when there are none.
std::optional<UndefinedEntities> find_undefined_entities(std::string_view text);

/// Remains of xacro in a URDF, which other readers ignore.
struct LeftoverXacro {
  int line = 0;         ///< of the first; 0: there is none
  std::string element;  ///< the first
  std::string fault;    ///< what was passed over, with counts
  std::string remedy;   ///< how to expand the file
};

/// Finds elements `<xacro:...>` and `${...}`, `$(...)` in the element `<robot>`. Where they stand
/// in what makes the mechanism (in a number, a type, a name that the file does not define; an
/// element of xacro inside a link or a joint, or one that holds or would add links or joints) there
/// is an error in `diagnostics`; all else can be passed over, and is listed.
LeftoverXacro find_leftover_xacro(const tinyxml2::XMLElement& robot, const std::string& file,
                                  Diagnostics& diagnostics);

}  // namespace treeline
