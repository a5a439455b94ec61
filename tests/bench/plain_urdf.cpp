// Copies a URDF without shapes and mimic tags: plain_urdf IN OUT. DART would search for the meshes,
// and the peers do not support mimic joints. So all measure the same robot.
#include <tinyxml2.h>

#include <iostream>
#include <string>

namespace {

void strip(tinyxml2::XMLElement& element) {
  for (auto* child = element.FirstChildElement(); child != nullptr;) {
    auto* next = child->NextSiblingElement();
    const std::string name = child->Name();
    if (name == "visual" || name == "collision" || name == "mimic") {
      element.DeleteChild(child);
    } else {
      strip(*child);
    }
    child = next;
  }
}

}  // namespace

int main(int count, char** arguments) {
  tinyxml2::XMLDocument document;
  if (count != 3 || document.LoadFile(arguments[1]) != tinyxml2::XML_SUCCESS ||
      document.RootElement() == nullptr) {
    std::cerr << "plain_urdf IN OUT: " << (count == 3 ? document.ErrorStr() : "two paths") << '\n';
    return 1;
  }
  strip(*document.RootElement());
  return document.SaveFile(arguments[2]) == tinyxml2::XML_SUCCESS ? 0 : 1;
}
