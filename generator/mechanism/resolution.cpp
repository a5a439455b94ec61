#include "mechanism/resolution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "description/noise.hpp"
#include "mechanism/mechanism.hpp"

namespace treeline {
namespace {

const Digits50 kResidue("1e-40");
/// Rotations that are orthogonal within this limit are not orthogonalized again.
const Digits50 kOrthogonal("1e-40");

bool is_within(const Digits50& x, const Digits50& limit) {
  return x <= limit && -x <= limit;
}

/// An entry of a 3x3 matrix. The other entries are addressed in cyclic order, which keeps the signs
/// of determinants.
struct Entry {
  int i = 0, j = 0;
  [[nodiscard]] int row(int k) const { return (i + k) % 3; }
  [[nodiscard]] int column(int k) const { return (j + k) % 3; }
};

/// Whether the other two entries in this row, or in this column, are within `limit` of 0, so that
/// the entry is 1 or -1.
bool is_alone(const Digits50Matrix3& R, const Entry& at, const Digits50& limit) {
  return (is_within(R(at.i, at.column(1)), limit) && is_within(R(at.i, at.column(2)), limit)) ||
         (is_within(R(at.row(1), at.j), limit) && is_within(R(at.row(2), at.j), limit));
}

/// Whether there is nothing to do, a cheap test that holds for most rotations: no entry is within
/// `limit` of 0 but not zero, and in no row two entries are zero while the third is not +-1.
bool is_resolved(const Digits50Matrix3& R, const Digits50& limit) {
  for (int i = 0; i < 3; ++i) {
    int zeros = 0;
    for (int j = 0; j < 3; ++j) {
      const bool zero = R(i, j) == 0;
      if (!zero && is_within(R(i, j), limit)) return false;
      zeros += zero ? 1 : 0;
    }
    if (zeros == 2 && !is_within(Digits50(abs(R(i, 0) + R(i, 1) + R(i, 2)) - 1), Digits50(0))) {
      return false;
    }
  }
  return true;
}

/// Makes (c, s) a unit vector. If it is within `limit` of an axis, its components become 0 and +-1.
void make_unit(Digits50& c, Digits50& s, const Digits50& limit) {
  if (is_within(c, limit)) {
    c = 0;
    s = s < 0 ? -1 : 1;
  } else if (is_within(s, limit)) {
    s = 0;
    c = c < 0 ? -1 : 1;
  } else if (const Digits50 square = c * c + s * s; !is_within(square - 1, kOrthogonal)) {
    const Digits50 length = sqrt(square);
    c /= length;
    s /= length;
  }
}

/// Rotation nearest to R about an axis that both frames share. Row and column `at` contain +-1; the
/// remaining block is [c, s; -s, c] or [c, s; s, -c].
Digits50Matrix3 with_shared_axis(const Digits50Matrix3& R, const Entry& at, const Digits50& limit) {
  const Digits50 sign = R(at.i, at.j) < 0 ? -1 : 1;
  const int i1 = at.row(1), i2 = at.row(2), j1 = at.column(1), j2 = at.column(2);
  Digits50 c = (R(i1, j1) + sign * R(i2, j2)) / 2;
  Digits50 s = (R(i1, j2) - sign * R(i2, j1)) / 2;
  make_unit(c, s, limit);
  Digits50Matrix3 result = Digits50Matrix3::Zero();
  result(at.i, at.j) = sign;
  result(i1, j1) = c;
  result(i1, j2) = s;
  result(i2, j1) = -sign * s;
  result(i2, j2) = sign * c;
  return result;
}

/// Rotation nearest to R in which the entry `at` is 0.
Digits50Matrix3 with_zero(const Digits50Matrix3& R, const Entry& at) {
  Digits50Matrix3 result = R;
  result(at.i, at.j) = 0;
  if (is_within(R(at.i, at.j), kOrthogonal)) return result;
  const int i1 = at.row(1), i2 = at.row(2);
  Digits50Vector3 first = result.row(at.i).transpose();
  first /= Digits50(sqrt(first.dot(first)));
  Digits50Vector3 second = R.row(i1).transpose();
  second -= first.dot(second) * first;
  second /= Digits50(sqrt(second.dot(second)));
  result.row(at.i) = first.transpose();
  result.row(i1) = second.transpose();
  for (int k = 0; k < 3; ++k) {
    const int a = (k + 1) % 3, b = (k + 2) % 3;
    result(i2, k) = first(a) * second(b) - first(b) * second(a);
  }
  return result;
}

/// Finds the smallest entry that is within `limit` of 0. Nothing if an entry is zero already,
/// because it might not stay zero if another one vanishes.
std::optional<Entry> find_least(const Digits50Matrix3& R, const Digits50& limit) {
  std::optional<Entry> least;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (R(i, j) == 0) return std::nullopt;
      if (!is_within(R(i, j), limit)) continue;
      if (!least || abs(R(i, j)) < abs(R(least->i, least->j))) least = Entry{i, j};
    }
  }
  return least;
}

Digits50Matrix3 resolved_rotation(const Digits50Matrix3& R, const Digits50& limit) {
  if (is_resolved(R, limit)) return R;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (is_alone(R, {i, j}, limit)) return with_shared_axis(R, {i, j}, limit);
    }
  }
  const std::optional<Entry> least = find_least(R, limit);
  return least ? with_zero(R, *least) : R;
}

}  // namespace

Digits50Pose resolved(const Digits50Pose& pose, const Resolution& resolution, Change* change) {
  Digits50Pose result{resolved_rotation(pose.R, resolution.angle), pose.p};
  const Digits50 largest =
      std::max({Digits50(abs(pose.p(0))), Digits50(abs(pose.p(1))), Digits50(abs(pose.p(2)))});
  const Digits50 limit = std::max(resolution.length, Digits50(kResidue * largest));
  for (int i = 0; i < 3; ++i) {
    if (is_within(pose.p(i), limit)) result.p(i) = 0;
  }
  if (change) {
    change->angle = std::max(change->angle, Digits50((result.R - pose.R).cwiseAbs().maxCoeff()));
    change->length = std::max(change->length, Digits50((result.p - pose.p).cwiseAbs().maxCoeff()));
  }
  return result;
}

Digits50 resolved(const Digits50& angle, const Resolution& resolution) {
  return is_within(angle, resolution.angle) ? Digits50(0) : angle;
}

namespace {

/// Whether x^2 <= share^2 y, where y need not be positive.
bool is_small(const Digits50& x, const Digits50& share, const Digits50& y) {
  return y > 0 && x * x <= share * share * y;
}

void drop(Digits50& x, const Digits50& size, Change* change) {
  if (change) change->share = std::max(change->share, Digits50(abs(x) / sqrt(size)));
  x = 0;
}

}  // namespace

Inertia resolved(const Inertia& inertia, const Resolution& resolution, Change* change) {
  Inertia result = inertia;
  const Digits50& share = resolution.angle;
  const Digits50Matrix3& Sigma = inertia.Sigma;
  const Digits50 most = Sigma.cwiseAbs().maxCoeff();
  const Digits50 residue = kResidue * most;
  // All three components of a balanced body's h may be residue. They have cancelled from mass times
  // the radius of gyration.
  const Digits50 balanced = abs(inertia.mass) * most;
  const Digits50 largest = inertia.h.cwiseAbs().maxCoeff();
  const Digits50 least = kResidue * largest;
  // What is small beside the radius of gyration alone is not noise: the torque of gravity has no
  // other terms. Nor is what is large beside the other components: see `kOfDistance`.
  const Digits50 of_robot = abs(inertia.mass) * resolution.length;
  const Digits50 of_centre = std::max(share, Digits50(kOfDistance * kResolution)) * largest;
  const Digits50 noise = largest <= of_robot ? of_robot : std::min(of_robot, of_centre);
  for (int i = 0; i < 3; ++i) {
    Digits50& h = result.h(i);
    const Digits50 bound = inertia.mass * Sigma(i, i);
    if (h != 0 && is_within(h, noise) && is_small(h, share, bound)) {
      drop(h, bound, change);
    } else if (is_within(h, least) || is_small(h, kResidue, balanced)) {
      h = 0;
    }
    if (is_within(Sigma(i, i), residue)) result.Sigma(i, i) = 0;
    const int j = (i + 1) % 3;
    Digits50& product = result.Sigma(i, j);
    const Digits50 size = Sigma(i, i) * Sigma(j, j);
    if (product != 0 && Sigma(i, i) > 0 && is_small(product, share, size)) {
      drop(product, size, change);
    } else if (is_within(product, residue)) {
      product = 0;
    }
    result.Sigma(j, i) = product;
  }
  return result;
}

void add_decisions(const Change& change, const std::string& element, const std::string& file,
                   NoiseDecisions& decisions) {
  const auto add = [&](const Digits50& by, const char* text) {
    if (by > kOrthogonal) {
      decisions.push_back({file, 0, element, text, static_cast<double>(by)});
    }
  };
  add(change.angle,
      "axes of frames that nearly agree, or are nearly at right angles, are so (rad)");
  add(change.length, "an offset between frames that nearly vanishes is 0 (m)");
  add(change.share, "a first moment or product of inertia that nearly vanishes is 0 (of its most)");
}

}  // namespace treeline
