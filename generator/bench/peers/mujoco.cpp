// MuJoCo: inverse and forward dynamics, M and gravity, of its functions in C without contacts and
// constraints. Each call makes what that result needs, and nothing else.
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>

#include "bench/peers/make_peer.hpp"

namespace treeline::peer {
namespace {

constexpr int kBase = 6;

/// A model, and the places of our coordinates in its arrays. A floating base has its linear
/// velocity in the world's axes here, and in its own axes in our arguments.
struct Solver {
  std::unique_ptr<mjModel, decltype(&mj_deleteModel)> model;
  std::unique_ptr<mjData, decltype(&mj_deleteData)> data;
  bool floating;
  std::vector<int> q_place, v_place;  ///< of the joints behind the base
  std::vector<double> applied;

  Solver(mjModel* made, bool floats)
      : model(made, mj_deleteModel),
        data(mj_makeData(made), mj_deleteData),
        floating(floats),
        applied(static_cast<std::size_t>(made->nv)) {}

  [[nodiscard]] std::size_t base() const { return floating ? kBase : 0; }

  void load_position(const double* from) {
    mjData& d = *data;
    if (floating) {
      std::copy_n(from, 3, d.qpos);
      const double wxyz[] = {from[6], from[3], from[4], from[5]};
      std::copy_n(wxyz, 4, d.qpos + 3);
    }
    const double* const joints = from + (floating ? 7 : 0);
    for (std::size_t i = 0; i < q_place.size(); ++i) d.qpos[q_place[i]] = joints[i];
    mj_kinematics(model.get(), &d);
    mj_comPos(model.get(), &d);
  }

  /// Loads a vector of velocities, accelerations or forces; the base's linear part turns.
  void load(const double* from, double* to) const {
    if (floating) {
      mju_rotVecQuat(to, from, data->qpos + 3);
      std::copy_n(from + 3, 3, to + 3);
    }
    const double* const joints = from + base();
    for (std::size_t i = 0; i < v_place.size(); ++i) to[v_place[i]] = joints[i];
  }
  void store(const double* from, double* to) const {
    if (floating) {
      double inverse[4];
      mju_negQuat(inverse, data->qpos + 3);
      mju_rotVecQuat(to, from, inverse);
      std::copy_n(from + 3, 3, to + 3);
    }
    double* const joints = to + base();
    for (std::size_t i = 0; i < v_place.size(); ++i) joints[i] = from[v_place[i]];
  }

  void load_velocity(const double* from) {
    load(from, data->qvel);
    mj_comVel(model.get(), data.get());
  }

  /// w x v of the base, in its own axes: what its linear acceleration lacks of that in the world.
  void turning(const double* qd, double (&to)[3]) const { mju_cross(to, qd + 3, qd); }
};

void inverse_dynamics(void* self, const double* const* in, double* out) {
  auto& s = *static_cast<Solver*>(self);
  mjData& d = *s.data;
  s.load_position(in[0]);
  s.load_velocity(in[1]);
  s.load(in[2], d.qacc);
  if (s.floating) {
    double turned[3], w_x_v[3];
    s.turning(in[1], w_x_v);
    mju_rotVecQuat(turned, w_x_v, d.qpos + 3);
    mju_addTo3(d.qacc, turned);
  }
  mj_rne(s.model.get(), &d, 1, s.applied.data());
  s.store(s.applied.data(), out);
}

void forward_dynamics(void* self, const double* const* in, double* out) {
  auto& s = *static_cast<Solver*>(self);
  const mjModel* const m = s.model.get();
  mjData& d = *s.data;
  s.load_position(in[0]);
  mj_makeM(m, &d);
  mj_factorM(m, &d);
  s.load_velocity(in[1]);
  mj_rne(m, &d, 0, d.qfrc_bias);
  s.load(in[2], s.applied.data());
  for (std::size_t i = 0; i < s.applied.size(); ++i) s.applied[i] -= d.qfrc_bias[i];
  mj_solveM(m, &d, d.qacc, s.applied.data(), 1);
  s.store(d.qacc, out);
  if (s.floating) {
    double w_x_v[3];
    s.turning(in[1], w_x_v);
    mju_subFrom3(out, w_x_v);
  }
}

void mass_matrix(void* self, const double* const* in, double* /*out*/) {
  auto& s = *static_cast<Solver*>(self);
  s.load_position(in[0]);
  mj_makeM(s.model.get(), s.data.get());
}

/// M of its sparse form, T^T M T with the base's linear velocities turned.
void finish_mass_matrix(void* self, double* out) {
  const auto& s = *static_cast<const Solver*>(self);
  const auto n = static_cast<std::size_t>(s.model->nv);
  std::vector<double> full(n * n), half(n * n), column(n), stored(n);
  mj_fullM(s.model.get(), s.data.get(), full.data());
  for (std::size_t i = 0; i < n; ++i) s.store(&full[i * n], &half[i * n]);
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t i = 0; i < n; ++i) column[i] = half[i * n + k];
    s.store(column.data(), stored.data());
    for (std::size_t i = 0; i < n; ++i) out[i * n + k] = stored[i];
  }
}

void gravity(void* self, const double* const* in, double* out) {
  auto& s = *static_cast<Solver*>(self);
  s.load_position(in[0]);
  std::fill_n(s.data->qvel, s.model->nv, 0.0);
  mj_comVel(s.model.get(), s.data.get());
  mj_rne(s.model.get(), s.data.get(), 0, s.applied.data());
  s.store(s.applied.data(), out);
}

void nonlinear_effects(void* self, const double* const* in, double* out) {
  auto& s = *static_cast<Solver*>(self);
  s.load_position(in[0]);
  s.load_velocity(in[1]);
  if (s.floating) {
    std::fill_n(s.data->qacc, s.model->nv, 0.0);
    double w_x_v[3];
    s.turning(in[1], w_x_v);
    mju_rotVecQuat(s.data->qacc, w_x_v, s.data->qpos + 3);
  }
  mj_rne(s.model.get(), s.data.get(), s.floating ? 1 : 0, s.applied.data());
  s.store(s.applied.data(), out);
}

/// R diag(moments) R^T, row-major.
void turn_moments(const double* moments, const double* quaternion, double* to) {
  double R[9], scaled[9];
  mju_quat2Mat(R, quaternion);
  for (int i = 0; i < 9; ++i) scaled[i] = R[i] * moments[i % 3];
  mju_mulMatMatT(to, scaled, R, 3, 3, 3);
}

/// The inertia that the file states for a body, about its centre, along the body's axes.
void stated_inertia(const mjsBody& body, double* to) {
  const double* const I = body.fullinertia;
  if (!std::isnan(I[0])) {
    const double full[] = {I[0], I[3], I[4], I[3], I[1], I[5], I[4], I[5], I[2]};
    std::copy_n(full, 9, to);
  } else {
    turn_moments(body.inertia, body.iquat, to);
  }
}

/// MuJoCo makes balls of inertias that no body has. Gives those back that the file states, since
/// its algorithms take any.
void restore_inertias(mjSpec* spec, mjModel& model) {
  for (int i = 1; i < model.nbody; ++i) {
    const mjsBody* const body = mjs_findBody(spec, mj_id2name(&model, mjOBJ_BODY, i));
    if (body == nullptr) continue;
    double stated[9], moments[3], axes[9];
    stated_inertia(*body, stated);
    mju_eig3(moments, axes, &model.body_iquat[4 * i], stated);
    const double largest = *std::max_element(moments, moments + 3);
    if (2 * largest <= moments[0] + moments[1] + moments[2]) continue;
    std::copy_n(moments, 3, &model.body_inertia[3 * i]);
  }
}

/// Reads and compiles the file. Massless bodies get what cannot be seen in any result.
mjModel* read_model(const Robot& robot, const Tell& tell) {
  char fault[1000] = "";
  const std::unique_ptr<mjSpec, decltype(&mj_deleteSpec)> spec(
      mj_parseXML(robot.urdf, nullptr, fault, sizeof fault), mj_deleteSpec);
  if (!spec) {
    tell(fault);
    return nullptr;
  }
  spec->compiler.fusestatic = 1;
  spec->compiler.balanceinertia = 1;
  spec->compiler.boundmass = 1e-12;
  spec->compiler.boundinertia = 1e-12;
  std::copy_n(robot.gravity, 3, spec->option.gravity);
  if (robot.floating) mjs_addFreeJoint(mjs_findBody(spec.get(), robot.links[0]));
  mjModel* const model = mj_compile(spec.get(), nullptr);
  if (model == nullptr) {
    tell(mjs_getError(spec.get()));
  } else {
    restore_inertias(spec.get(), *model);
  }
  return model;
}

Opened open(const Robot& robot, const Tell& tell) {
  Opened opened;
  mjModel* const model = read_model(robot, tell);
  if (model == nullptr) return opened;
  auto& s = opened.keep<Solver>(model, robot.floating);
  if (model->nv != robot.velocities) {
    tell("counts other degrees of freedom than the scene");
    return opened;
  }
  for (int i = robot.floating ? kBase : 0; i < robot.velocities; ++i) {
    const int body = mj_name2id(model, mjOBJ_BODY, robot.links[i]);
    if (body < 0 || model->body_jntnum[body] != 1) {
      tell("has no joint of its own for link " + std::string(robot.links[i]));
      return opened;
    }
    s.q_place.push_back(model->jnt_qposadr[model->body_jntadr[body]]);
    s.v_place.push_back(model->body_dofadr[body]);
  }
  opened.routines = {{"inverse_dynamics", "", &s, inverse_dynamics, nullptr},
                     {"forward_dynamics", "", &s, forward_dynamics, nullptr},
                     {"mass_matrix", "", &s, mass_matrix, finish_mass_matrix},
                     {"gravity", "", &s, gravity, nullptr},
                     {"nonlinear_effects", "", &s, nonlinear_effects, nullptr}};
  return opened;
}

const Peer kPeer = make_peer<open>("MuJoCo", mj_versionString());

}  // namespace
}  // namespace treeline::peer

const treeline::peer::Peer* treeline_peer() {
  return &treeline::peer::kPeer;
}
