// What the page has received, for plots and CSV.

const kLongest = 18000;  // samples: ten minutes at 30 a second

/** Distance of a point from its goal, m; NaN where it has none. */
export function tracking_error(point) {
  if (!point.goal) return NaN;
  return Math.hypot(...point.at.map((x, i) => x - point.goal[i]));
}

/** Keeps the last ten minutes of states. */
export class Recorder {
  states = [];

  /** Returns true where time has gone back: a motion began again, and what was before is gone. */
  add(state) {
    const again = state.time < this.states.at(-1)?.time;
    if (again) this.clear();
    this.states.push(state);
    if (this.states.length > kLongest) this.states.splice(0, kLongest / 10);
    return again;
  }

  clear() {
    this.states = [];
  }

  /** States of the last `seconds`. */
  recent(seconds) {
    const last = this.states.at(-1)?.time ?? 0;
    let first = this.states.length;
    while (first > 0 && this.states[first - 1].time >= last - seconds) --first;
    return this.states.slice(first);
  }
}

/** A field as CSV has it: quoted where it holds a separator. */
function field(value) {
  const text = value === undefined || value === null ? '' : String(value);
  return /[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

/** One row per state: time (s), mode, q, qd, tau, positions and errors of points, control time. */
export function write_csv(hello, states) {
  const points = hello.points.map((point) => point.name);
  const velocities = states[0]?.qd.length ?? 0;
  const numbered = (name, count) => Array.from({length: count}, (_, i) => `${name}${i}`);
  const head = ['time', 'mode', ...hello.coordinates.map((c) => c.name),
    ...numbered('qd', velocities), ...numbered('tau', states[0]?.tau.length ?? 0),
    ...points.flatMap((name) => ['x', 'y', 'z', 'error'].map((part) => `${name} ${part}`)),
    'control_us', 'control_max_us', 'period_us', 'period_max_us'];
  const rows = states.map((state) => [state.time, state.mode, ...state.q, ...state.qd, ...state.tau,
    ...state.points.flatMap((point) => [...point.at, tracking_error(point)]),
    state.control_us.mean, state.control_us.max, state.period_us.mean, state.period_us.max]);
  return [head, ...rows].map((row) => row.map(field).join(',')).join('\n') + '\n';
}
