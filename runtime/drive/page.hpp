#pragma once

#include <string_view>

namespace treeline::drive {

/// The page that the program carries; empty texts if it was built without Node.js and npm.
struct Page {
  std::string_view html, script, style;
};

Page carried_page();

}  // namespace treeline::drive
