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

ExactMatrix3 turn(int axis, const Exact& angle) {
  ExactMatrix3 cycle = ExactMatrix3::Zero();
  cycle(0, 2) = cycle(1, 0) = cycle(2, 1) = 1;
  ExactMatrix3 R = rotation_z(angle);
  for (int i = 0; i <= axis; ++i) R = (cycle * R * cycle.transpose()).eval();
  return R;
}

/// Deviation from an orthogonal matrix with determinant 1.
double defect(const ExactMatrix3& R) {
  const ExactMatrix3 off = R * R.transpose() - ExactMatrix3::Identity();
  const Exact determinant = R.col(0).dot(R.col(1).cross(R.col(2)));
  return static_cast<double>(
      std::max(Exact(off.cwiseAbs().maxCoeff()), Exact(abs(determinant - 1))));
}

int count_zeros(const ExactMatrix3& R) {
  return static_cast<int>((R.array() == Exact(0)).count());
}

Resolution of_files() {
  return {Exact(kResolution), Exact(kResolution)};
}

/// Rotations with their number of zeros: one of the 24, one with a shared axis, one with a single
/// zero, and a general one.
std::vector<std::pair<ExactMatrix3, int>> rotations_and_their_zeros(Rng& rng) {
  const auto quarter = [&] { return Exact(rng.below(4)) * half_pi(); };
  const auto general = [&] { return Exact(rng.uniform(0.2, 1.3)); };
  const ExactMatrix3 quarters = turn(0, quarter()) * turn(1, quarter()) * turn(2, quarter());
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
        ExactMatrix3 noisy = R;
        for (int i = 0; i < 3; ++i) {
          noisy = (noisy * turn(i, Exact(noise) * Exact(rng.uniform(-1, 1)))).eval();
        }
        Change change;
        const ExactPose found = resolved({noisy, ExactVector3::Zero()}, of_files(), &change);
        EXPECT_EQ(count_zeros(found.R), zeros);
        EXPECT_LE(defect(found.R), 1e-39);
        EXPECT_LE((found.R - noisy).cwiseAbs().maxCoeff(), 4 * noise + 1e-48);
        EXPECT_LE((found.R - noisy).cwiseAbs().maxCoeff(), change.angle);
        const ExactPose again = resolved(found, of_files());
        EXPECT_EQ(again.R, found.R);
      }
    }
  }
}

// 1e-8 rad has a cosine of 1 in double, but it is an angle.
TEST(Resolution, LeavesWhatDoubleCanTell) {
  for (const double angle : {1e-3, 1e-8, 1e-12, 1e-15}) {
    const ExactPose pose{turn(0, angle), ExactVector3(0, 1, angle)};
    const ExactPose found = resolved(pose, of_files());
    EXPECT_EQ(found.R(2, 1), pose.R(2, 1)) << angle;
    EXPECT_EQ(found.R(1, 1), pose.R(1, 1)) << angle;
    EXPECT_EQ(found.p, pose.p) << angle;
  }
}

TEST(Resolution, OfAKeptFileIsResidueAlone) {
  const ExactPose pose{turn(0, Exact("1e-25")), ExactVector3(0, 1, Exact("1e-25"))};
  const ExactPose found = resolved(pose, Resolution{});
  EXPECT_EQ(found.R(2, 1), pose.R(2, 1));
  EXPECT_EQ(found.p, pose.p);
}

TEST(Resolution, OfInertiasIsRelativeToTheirMoments) {
  Inertia inertia;
  inertia.mass = 2;
  inertia.Sigma.diagonal() << Exact("1e-10"), 1, 1;
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
  EXPECT_EQ(with(0, 0, 0).Sigma(0, 0), Exact("1e-10"));
}

/// Largest distance from its frame of what belongs to any link.
Exact size_of(const Mechanism& mechanism) {
  Exact most = 0;
  for (const MovingLink& link : mechanism.links) {
    most = std::max({most, link.radius, Exact(link.placement.p.norm())});
  }
  for (const auto* points : {&mechanism.operational_points, &mechanism.external_forces}) {
    for (const MechanismPoint& point : *points) {
      most = std::max(most, Exact(point.pose.p.norm()));
    }
  }
  return most;
}

void expect_sound_frames(const Mechanism& mechanism, const Exact& size) {
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
        const Exact size = size_of(build_mechanism(noisy.robot, noisy.scene));
        expect_sound_frames(reduced_mechanism(noisy.robot, noisy.scene), size);
      }
    }
  }
}

/// Counts the constants that cost operations.
int count_numbers(const Mechanism& mechanism) {
  int count = 0;
  const auto add = [&](const Exact& x) { count += x == 0 || x == 1 || x == -1 ? 0 : 1; };
  for (const MovingLink& link : mechanism.links) {
    for (const Exact& x : link.placement.R.reshaped()) add(x);
    for (const Exact& x : link.placement.p) add(x);
    for (const Exact& x : link.inertia.h) add(x);
    for (const Exact& x : link.inertia.Sigma.reshaped()) add(x);
    add(link.offset);
  }
  for (const MechanismPoint& point : mechanism.operational_points) {
    for (const Exact& x : point.pose.R.reshaped()) add(x);
    for (const Exact& x : point.pose.p) add(x);
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
