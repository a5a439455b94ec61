#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "description/urdf_parts.hpp"

namespace treeline {
namespace {

void read_moments(const UrdfElement& inertia, Inertial& inertial) {
  inertia.holds_only_attributes({"ixx", "ixy", "ixz", "iyy", "iyz", "izz", "iyx", "izx", "izy"});
  for (const char* name : {"ixx", "ixy", "ixz", "iyy", "iyz", "izz"}) {
    if (inertia.has(name)) continue;
    inertia.error(fmt::format("the attribute \"{}\" is missing", name),
                  "give all six moments ixx ixy ixz iyy iyz izz in kg m^2");
  }
  inertial.ixx = inertia.number("ixx").value_or(0);
  inertial.iyy = inertia.number("iyy").value_or(0);
  inertial.izz = inertia.number("izz").value_or(0);
  struct Product {
    const char* name;
    const char* mirrored;
    double& value;
  };
  for (const Product& product : {Product{"ixy", "iyx", inertial.ixy},
                                 {"ixz", "izx", inertial.ixz},
                                 {"iyz", "izy", inertial.iyz}}) {
    const auto upper = inertia.number(product.name);
    const auto lower = inertia.number(product.mirrored);
    if (upper && lower && *upper != *lower) {
      // URDF has the six moments above the diagonal; other readers do not look at the rest.
      inertia.warn(fmt::format("{}={} and {}={} differ, though an inertia is symmetric: {} is used",
                               product.name, *upper, product.mirrored, *lower, product.name),
                   fmt::format("check the sign; keep {} alone", product.name));
    }
    product.value = upper.value_or(0);
  }
}

void warn_of_smallest_moments(const UrdfElement& element, Inertial& inertial) {
  const double largest = drop_smallest_moments(inertial);
  if (largest == 0) return;
  element.warn(
      fmt::format("the moments of inertia, at most {} kg m^2, are too small to compute with and "
                  "count as 0",
                  largest),
      fmt::format("give at least {} kg m^2, or 0", kSmallestMoment));
}

Inertial read_inertial(const UrdfElement& element) {
  element.only_attributes({});
  element.only_children({"origin", "mass", "inertia"});
  Inertial inertial;
  inertial.origin = element.origin();
  if (const auto mass = element.child("mass")) {
    mass->holds_only_attributes({"value"});
    if (!mass->has("value")) (void)mass->required_text("value", "give the mass in kg");
    inertial.mass = mass->number("value").value_or(0);
    if (inertial.mass > 0 && counted_mass(inertial.mass) == 0) {
      mass->warn(
          fmt::format("the mass {} kg is too small to compute with and counts as 0", inertial.mass),
          fmt::format("give at least {} kg, or 0", kSmallestMass));
      inertial.mass = 0;
    }
    if (inertial.mass < 0) {
      mass->error(fmt::format("the mass {} kg is negative", inertial.mass),
                  "give the link's mass, or remove <inertial> if the link has none");
    }
  } else {
    element.error("<inertial> has no <mass>",
                  "add <mass value=\"...\"/> in kg, or remove <inertial> if the link has no mass");
  }
  const auto inertia = element.child("inertia");
  if (inertia) {
    read_moments(*inertia, inertial);
    warn_of_smallest_moments(*inertia, inertial);
  }
  if (!inertia && inertial.mass > 0) {
    element.warn(fmt::format("the link has a mass of {} kg and no <inertia>; the mass counts as a "
                             "point at the centre of mass",
                             inertial.mass),
                 "add <inertia ixx=... ixy=... ixz=... iyy=... iyz=... izz=.../> in kg m^2");
  }
  return inertial;
}

void warn_of_stray_inertia(const UrdfElement& element) {
  for (const char* name : {"mass", "inertia"}) {
    const auto* stray = element.xml().FirstChildElement(name);
    if (stray == nullptr) continue;
    element.reading().pass_over(Severity::warning, std::string("link/") + name, stray->GetLineNum(),
                                element.path(),
                                fmt::format("<{}> stands outside <inertial> and is ignored", name),
                                "move <mass>, <inertia> and <origin> into an element <inertial>");
  }
}

}  // namespace

double drop_smallest_moments(Inertial& inertial) {
  const std::array<double*, 6> moments = {&inertial.ixx, &inertial.ixy, &inertial.ixz,
                                          &inertial.iyy, &inertial.iyz, &inertial.izz};
  double largest = 0;
  for (const double* const moment : moments) largest = std::max(largest, std::abs(*moment));
  if (largest >= kSmallestMoment) return 0;
  for (double* const moment : moments) *moment = 0;
  return largest;
}

double counted_mass(double mass) {
  return mass > 0 && mass < kSmallestMass ? 0 : mass;
}

Link read_link(const UrdfElement& element) {
  Link link;
  link.line = element.line();
  link.name = element.required_name("give the link a name");
  element.only_attributes({"name"});
  warn_of_stray_inertia(element);
  element.only_children({"inertial", "visual", "collision", "mass", "inertia", "contact",
                         "self_collision_checking", "collision_checking", "sensor"});
  if (const auto inertial = element.child("inertial")) link.inertial = read_inertial(*inertial);
  return link;
}

}  // namespace treeline
