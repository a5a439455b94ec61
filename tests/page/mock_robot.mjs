// A robot without dynamics for tests of the page: joints run after their goals, a point is led by
// damped least squares. Knows fixed bases with revolute, prismatic and fixed joints.

const kLag = 0.08;  // s in which a joint covers most of the way to its goal

function attribute(text, tag, name) {
  return text.match(new RegExp(`<${tag}[^>]*\\b${name}="([^"]*)"`))?.[1];
}

function triple(text) {
  return (text ?? '0 0 0').trim().split(/\s+/).map(Number);
}

function rotation([x, y, z], angle) {
  const length = Math.hypot(x, y, z) || 1;
  const s = Math.sin(angle / 2) / length;
  return [x * s, y * s, z * s, Math.cos(angle / 2)];
}

export function times([ax, ay, az, aw], [bx, by, bz, bw]) {
  return [aw * bx + ax * bw + ay * bz - az * by, aw * by - ax * bz + ay * bw + az * bx,
    aw * bz + ax * by - ay * bx + az * bw, aw * bw - ax * bx - ay * by - az * bz];
}

function rotated(q, v) {
  const [x, y, z] = times(times(q, [...v, 0]), [-q[0], -q[1], -q[2], q[3]]);
  return [x, y, z];
}

function from_rpy([r, p, y]) {
  return times(times(rotation([0, 0, 1], y), rotation([0, 1, 0], p)), rotation([1, 0, 0], r));
}

/** Joints of a URDF in the order of the file: parents have to stand before children. */
export function read_joints(urdf) {
  return [...urdf.matchAll(/<joint name="([^"]*)" type="([^"]*)">([\s\S]*?)<\/joint>/g)]
    .map(([, name, type, body]) => ({name, type, parent: attribute(body, 'parent', 'link'),
      child: attribute(body, 'child', 'link'), place: triple(attribute(body, 'origin', 'xyz')),
      turn: from_rpy(triple(attribute(body, 'origin', 'rpy'))),
      axis: triple(attribute(body, 'axis', 'xyz') ?? '1 0 0'),
      lower: Number(attribute(body, 'limit', 'lower')),
      upper: Number(attribute(body, 'limit', 'upper')),
      velocity: Number(attribute(body, 'limit', 'velocity')),
      effort: Number(attribute(body, 'limit', 'effort'))}));
}

export class MockRobot {
  mode = 'idle';
  control = 'joint';
  fault = '';
  time = 0;

  /** `tip` is the link of the one operational point. */
  constructor(urdf, tip) {
    this.joints = read_joints(urdf);
    this.moving = this.joints.filter((joint) => joint.type !== 'fixed');
    this.tip = tip;
    this.q = [0.3, -0.9, 0.6, 0.4, 0.7, 0.2].slice(0, this.moving.length);
    this.qd = this.q.map(() => 0);
    this.take_as_goal();
  }

  /** Goals become what is. */
  take_as_goal() {
    this.goal = [...this.q];
    const {at, turn} = this.tip_at(this.q);
    this.goal_at = at;
    this.goal_turn = turn;
    this.motions = new Map();
  }

  tip_at(q) {
    const poses = new Map();
    for (const joint of this.joints) {
      const parent = poses.get(joint.parent) ?? {at: [0, 0, 0], turn: [0, 0, 0, 1]};
      const index = this.moving.indexOf(joint);
      const offset = rotated(parent.turn, joint.place);
      const seat = times(parent.turn, joint.turn);
      const turn = index < 0 ? seat : times(seat, rotation(joint.axis, q[index]));
      poses.set(joint.child, {at: parent.at.map((x, i) => x + offset[i]), turn});
    }
    return poses.get(this.tip);
  }

  /**
   * Lets the goal of `what`, an index of `moving` or 'tip', run to its end in `seconds`:
   * `set(share)` with share from 0 to 1. The motions of others go on.
   */
  move(what, seconds, set) {
    this.motions.set(what, {begin: this.time, seconds, set});
  }

  step(dt) {
    this.time += dt;
    const before = [...this.q];
    if (this.mode === 'running') this.#follow(dt);
    this.qd = this.q.map((value, i) => (value - before[i]) / dt);
  }

  #follow(dt) {
    for (const [what, {begin, seconds, set}] of this.motions) {
      const share = Math.min((this.time - begin) / seconds, 1);
      set(share * share * (3 - 2 * share));
      if (share === 1) this.motions.delete(what);
    }
    if (this.control === 'task') this.#lead_tip();
    const part = 1 - Math.exp(-dt / kLag);
    this.q = this.q.map((value, i) => value + part * (this.goal[i] - value));
    if (this.control === 'joint') {
      const {at, turn} = this.tip_at(this.goal);
      this.goal_at = at;
      this.goal_turn = turn;
    }
  }

  /** One step of damped least squares by the transposed Jacobian, three times. */
  #lead_tip() {
    for (let repeat = 0; repeat < 3; ++repeat) {
      const error = this.#error(this.goal);
      const columns = this.goal.map((_, i) => {
        const moved = this.goal.map((value, k) => value + (k === i ? 1e-5 : 0));
        return this.#error(moved).map((value, k) => (error[k] - value) / 1e-5);
      });
      const step = solve_damped(columns, error, 1e-4);
      this.goal = this.goal.map((value, i) =>
        Math.min(Math.max(value + step[i], this.moving[i].lower), this.moving[i].upper));
    }
  }

  /** Way and rotation vector from the tip at `q` to its goal. */
  #error(q) {
    const {at, turn} = this.tip_at(q);
    const [x, y, z, w] = times(this.goal_turn, [-turn[0], -turn[1], -turn[2], turn[3]]);
    const sign = w < 0 ? -2 : 2;
    return [...this.goal_at.map((value, i) => value - at[i]), sign * x, sign * y, sign * z];
  }
}

/** x = Jt (J Jt + damping 1)^-1 error, with J given by its columns. */
function solve_damped(columns, error, damping) {
  const n = error.length;
  const rows = error.map((value, i) => [...error.map((_, k) =>
    columns.reduce((sum, column) => sum + column[i] * column[k], i === k ? damping : 0)), value]);
  for (let i = 0; i < n; ++i) {
    for (let k = i + 1; k < n; ++k) {
      const factor = rows[k][i] / rows[i][i];
      for (let j = i; j <= n; ++j) rows[k][j] -= factor * rows[i][j];
    }
  }
  const y = Array(n).fill(0);
  for (let i = n - 1; i >= 0; --i) {
    y[i] = (rows[i][n] - rows[i].slice(i + 1, n).reduce((sum, value, k) =>
      sum + value * y[i + 1 + k], 0)) / rows[i][i];
  }
  return columns.map((column) => column.reduce((sum, value, i) => sum + value * y[i], 0));
}
