#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace treeline::drive {

/// How an STL is written, as its beginning and its size tell.
struct StlForm {
  static constexpr std::size_t kHead = 84;   ///< bytes before the first triangle
  static constexpr std::size_t kFacet = 50;  ///< bytes of a triangle

  bool in_words = false;        ///< ASCII
  std::uint32_t triangles = 0;  ///< stated in a binary one
  std::string problem;          ///< why a binary one cannot be whole; empty if it can
};

/// Tells the form of an STL of `size` bytes from its first `StlForm::kHead`, or fewer if it has no
/// more. A binary file may begin with `solid` too: then it is one if its size fits.
inline StlForm stl_form(std::string_view head, std::uintmax_t size) {
  StlForm form;
  form.in_words = head.starts_with("solid");
  if (head.size() < StlForm::kHead) {
    if (!form.in_words) {
      form.problem = "it is cut short: it has " + std::to_string(size) + " bytes";
    }
    return form;
  }
  for (std::size_t i = StlForm::kHead; i-- > StlForm::kHead - 4;) {
    form.triangles = form.triangles * 256 + static_cast<unsigned char>(head[i]);
  }
  const std::uintmax_t whole = StlForm::kHead + std::uintmax_t{StlForm::kFacet} * form.triangles;
  form.in_words = form.in_words && size != whole;
  if (size < whole && !form.in_words) {
    form.problem = "it is cut short: " + std::to_string(form.triangles) + " triangles take " +
                   std::to_string(whole) + " bytes, it has " + std::to_string(size);
  }
  return form;
}

}  // namespace treeline::drive
