#include <bit>
#include <cstdint>

#include "description/mesh/mesh.hpp"
#include "description/read_number.hpp"
#include "drive/stl_form.hpp"

namespace treeline {
namespace {

/// The float at a place, least byte first.
double float_at(std::string_view bytes, std::size_t at) {
  std::uint32_t bits = 0;
  for (std::size_t i = 4; i-- > 0;) bits = bits << 8U | static_cast<unsigned char>(bytes[at + i]);
  return std::bit_cast<float>(bits);
}

std::string read_binary(std::string_view bytes, std::size_t count,
                        std::vector<Triangle>& triangles) {
  constexpr std::size_t kNormal = 12;  // bytes before the corners
  for (std::size_t t = 0; t < count; ++t) {
    Triangle triangle;
    std::size_t at = drive::StlForm::kHead + drive::StlForm::kFacet * t + kNormal;
    for (Eigen::Vector3d& corner : triangle.corners) {
      for (double& coordinate : corner) {
        coordinate = float_at(bytes, at);
        at += 4;
      }
    }
    triangles.push_back(triangle);
  }
  return {};
}

/// The next word at `at`, which moves behind it; empty at the end.
std::string_view next_word(std::string_view text, std::size_t& at) {
  constexpr std::string_view kBlanks = " \t\r\n";
  const std::size_t begin = std::min(text.find_first_not_of(kBlanks, at), text.size());
  at = std::min(text.find_first_of(kBlanks, begin), text.size());
  return text.substr(begin, at - begin);
}

std::string read_words(std::string_view text, std::vector<Triangle>& triangles) {
  Triangle triangle;
  std::size_t corners = 0;
  std::size_t at = text.find('\n');  // behind `solid` and a name
  while (at < text.size()) {
    if (next_word(text, at) != "vertex") continue;
    for (double& coordinate : triangle.corners[corners]) {
      const auto number = read_number(next_word(text, at));
      if (!number) return "a vertex is not three numbers";
      coordinate = *number;
    }
    if (++corners < 3) continue;
    triangles.push_back(triangle);
    corners = 0;
  }
  return corners == 0 ? "" : "it is cut short within a triangle";
}

}  // namespace

std::string read_stl(std::string_view bytes, std::vector<Triangle>& triangles) {
  const auto form = drive::stl_form(bytes.substr(0, drive::StlForm::kHead), bytes.size());
  if (!form.problem.empty()) return form.problem;
  return form.in_words ? read_words(bytes, triangles)
                       : read_binary(bytes, form.triangles, triangles);
}

}  // namespace treeline
