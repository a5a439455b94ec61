#include "mechanism/resolution.hpp"

#include <gtest/gtest.h>

#include "mechanism/build_mechanism.hpp"
#include "random_mechanism.hpp"
#include "with_noise.hpp"

// Which numbers count as equal. Would catch: structure that noise hides, a rotation that is no
// longer one after its entries are cleaned one by one, a number that changes by more than is
// reported, and frames placed where almost parallel axes intersect.

namespace treeline::tests {
namespace {

Digits50Matrix3 turn(int axis, const Digits50& angle) {
  Digits50Matrix3 cycle = Digits50Matrix3::Zero();
  cycle(0, 2) = cycle(1, 0) = cycle(2, 1) = 1;
  Digits50Matrix3 R = rotation_z(angle);
  for (int i = 0; i <= axis; ++i) R = (cycle * R * cycle.transpose()).eval();
  return R;
}

/// Deviation from an orthogonal matrix with determinant 1.
double defect(const Digits50Matrix3& R) {
  const Digits50Matrix3 off = R * R.transpose() - Digits50Matrix3::Identity();
  const Digits50 determinant = R.col(0).dot(R.col(1).cross(R.col(2)));
  return static_cast<double>(
      std::max(Digits50(off.cwiseAbs().maxCoeff()), Digits50(abs(determinant - 1))));
}

int count_zeros(const Digits50Matrix3& R) {
  return static_cast<int>((R.array() == Digits50(0)).count());
}

Resolution of_files() {
  return {Digits50(kResolution), Digits50(kResolution)};
}

/// Rotations with their number of zeros: one of the 24, one with a shared axis, one with a single
/// zero, and a general one.
std::vector<std::pair<Digits50Matrix3, int>> rotations_and_their_zeros(Rng& rng) {
  const auto quarter = [&] { return Digits50(rng.below(4)) * half_pi(); };
  const auto general = [&] { return Digits50(rng.uniform(0.2, 1.3)); };
  const Digits50Matrix3 quarters = turn(0, quarter()) * turn(1, quarter()) * turn(2, quarter());
  const int axis = rng.below(3);
  return {{quarters, 6},
          {quarters * turn(axis, general()), 4},
          {quarters * turn(axis, general()) * turn((axis + 1) % 3, general()), 1},
          {turn(0, general()) * turn(1, general()) * turn(2, general()), 0}};
}

TEST(Resolution, FindsTheStructureUnderNoiseAndLeavesARotation) {
  Rng rng(1);
  for (int round = 0; round < 50; ++round) {
    for (const auto& [R, zeros] : rotations_and_their_zeros(rng)) {
      for (const double noise : {0.0, 1e-60, 1e-45, 1e-38, 1e-30, 1e-27, 1e-20, 1e-17, 1e-16}) {
        SCOPED_TRACE(noise);
        Digits50Matrix3 noisy = R;
        for (int i = 0; i < 3; ++i) {
          noisy = (noisy * turn(i, Digits50(noise) * Digits50(rng.uniform(-1, 1)))).eval();
        }
        Change change;
        const Digits50Pose found = resolved({noisy, Digits50Vector3::Zero()}, of_files(), &change);
        EXPECT_EQ(count_zeros(found.R), zeros);
        EXPECT_LE(defect(found.R), 1e-39);
        EXPECT_LE((found.R - noisy).cwiseAbs().maxCoeff(), 4 * noise + 1e-48);
        EXPECT_LE((found.R - noisy).cwiseAbs().maxCoeff(), change.angle);
        const Digits50Pose again = resolved(found, of_files());
        EXPECT_EQ(again.R, found.R);
      }
    }
  }
}

// 1e-8 rad has a cosine of 1 in double, but it is an angle.
TEST(Resolution, LeavesWhatDoubleCanTell) {
  for (const double angle : {1e-3, 1e-8, 1e-12, 1e-15}) {
    const Digits50Pose pose{turn(0, angle), Digits50Vector3(0, 1, angle)};
    const Digits50Pose found = resolved(pose, of_files());
    EXPECT_EQ(found.R(2, 1), pose.R(2, 1)) << angle;
    EXPECT_EQ(found.R(1, 1), pose.R(1, 1)) << angle;
    EXPECT_EQ(found.p, pose.p) << angle;
  }
}

TEST(Resolution, OfAKeptFileIsResidueAlone) {
  const Digits50Pose pose{turn(0, Digits50("1e-25")), Digits50Vector3(0, 1, Digits50("1e-25"))};
  const Digits50Pose found = resolved(pose, Resolution{});
  EXPECT_EQ(found.R(2, 1), pose.R(2, 1));
  EXPECT_EQ(found.p, pose.p);
}

TEST(Resolution, OfInertiasIsRelativeToTheirMoments) {
  Inertia inertia;
  inertia.mass = 2;
  inertia.Sigma.diagonal() << Digits50("1e-10"), 1, 1;
  const auto with = [&](double h, double xy, double yz) {
    Inertia noisy = inertia;
    noisy.h(0) = h;
    noisy.Sigma(0, 1) = noisy.Sigma(1, 0) = xy;
    noisy.Sigma(1, 2) = noisy.Sigma(2, 1) = yz;
    return resolved(noisy, of_files());
  };
  EXPECT_EQ(with(1e-21, 1e-21, 1e-16).h(0), 0);
  EXPECT_EQ(with(1e-21, 1e-21, 1e-16).Sigma(1, 0), 0);
  EXPECT_EQ(with(1e-21, 1e-21, 1e-16).Sigma(2, 1), 0);
  EXPECT_NE(with(1e-20, 1e-20, 1e-15).h(0), 0);
  EXPECT_NE(with(1e-20, 1e-20, 1e-15).Sigma(0, 1), 0);
  EXPECT_NE(with(1e-20, 1e-20, 1e-15).Sigma(1, 2), 0);
  // A thin rod has this moment about itself, however small it is.
  EXPECT_EQ(with(0, 0, 0).Sigma(0, 0), Digits50("1e-10"));
}

/// Largest distance from its frame of what belongs to any link.
Digits50 size_of(const Mechanism& mechanism) {
  Digits50 most = 0;
  for (const MovingLink& link : mechanism.links) {
    most = std::max({most, link.radius, Digits50(link.placement.p.norm())});
  }
  for (const auto* points : {&mechanism.operational_points, &mechanism.external_forces}) {
    for (const MechanismPoint& point : *points) {
      most = std::max(most, Digits50(point.pose.p.norm()));
    }
  }
  return most;
}

void expect_sound_frames(const Mechanism& mechanism, const Digits50& size) {
  for (const MovingLink& link : mechanism.links) {
    EXPECT_LE(defect(link.placement.R), 1e-38) << link.name << "\n" << link.placement.R;
    EXPECT_LE(link.placement.p.norm(), 9 * size) << link.name;
    EXPECT_LE(link.inertia.h.norm(), 1e3) << link.name;
  }
}

// Four times the size of a link, once for the parent's frame and once for its own, plus the size
// itself.
TEST(Frames, StayNearTheirLinksWhateverTheNoise) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    RandomOptions options;
    options.joints = 7;
    options.aligned = seed % 2 == 0 ? 1 : 0.7;
    options.external_forces = 1;
    options.floating_base = seed % 3 == 0;
    const RandomMechanism made = random_mechanism(seed, options);
    for (const double noise : {1e-3, 1e-6, 1e-9, 1e-12, 1e-14, 1e-15, 1e-16, 1e-17, 1e-24, 1e-27,
                               1e-30, 1e-33, 1e-45, 1e-60}) {
      for (const double limit : {kResolution, 0.0}) {
        SCOPED_TRACE(testing::Message()
                     << "seed " << seed << ", noise " << noise << ", limit " << limit);
        RandomMechanism noisy = with_noise(made, noise, seed);
        noisy.scene.noise = limit;
        const Digits50 size = size_of(build_mechanism(noisy.robot, noisy.scene));
        expect_sound_frames(reduced_mechanism(noisy.robot, noisy.scene), size);
      }
    }
  }
}

/// Counts the constants that cost operations.
int count_numbers(const Mechanism& mechanism) {
  int count = 0;
  const auto add = [&](const Digits50& x) { count += x == 0 || x == 1 || x == -1 ? 0 : 1; };
  for (const MovingLink& link : mechanism.links) {
    for (const Digits50& x : link.placement.R.reshaped()) add(x);
    for (const Digits50& x : link.placement.p) add(x);
    for (const Digits50& x : link.inertia.h) add(x);
    for (const Digits50& x : link.inertia.Sigma.reshaped()) add(x);
    add(link.offset);
  }
  for (const MechanismPoint& point : mechanism.operational_points) {
    for (const Digits50& x : point.pose.R.reshaped()) add(x);
    for (const Digits50& x : point.pose.p) add(x);
  }
  return count;
}

TEST(Frames, AreAsSparseAsWithoutNoiseThatDoubleCannotResolve) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    RandomOptions options;
    options.joints = 8;
    options.aligned = 0.9;
    options.mix.fixed = 2;
    options.operational_points = 2;
    RandomMechanism made = random_mechanism(seed, options);
    made.scene.noise = kResolution;
    const int count = count_numbers(reduced_mechanism(made.robot, made.scene));
    for (const double noise : {1e-16, 1e-17, 1e-20, 1e-27, 1e-30, 1e-36, 1e-45, 1e-60}) {
      const RandomMechanism noisy = with_noise(made, noise, seed);
      EXPECT_EQ(count_numbers(reduced_mechanism(noisy.robot, noisy.scene)), count)
          << "seed " << seed << ", noise " << noise;
    }
  }
}

}  // namespace
}  // namespace treeline::tests
