#pragma once

#include <optional>
#include <string>
#include <vector>

namespace treeline {

/// A member of a struct, as an emitted header of C declares it.
struct StructMember {
  std::string type;  ///< `int32_t`, or `NAME_number`
  std::string name;
  bool is_array = false;
  std::string meaning;  ///< the comment behind it, in one line; may be empty
};

/// Lists the members of the struct `type` in the text of a header; nothing where it has none.
std::vector<StructMember> list_members(const std::string& header, const std::string& type);

/// An enumerator of an emitted header of C.
struct HeaderEnumerator {
  std::string name;
  int value = 0;
};

/// Lists the enumerators of the enumeration `type` in the text of a header.
std::vector<HeaderEnumerator> list_enumerators(const std::string& header, const std::string& type);

}  // namespace treeline
