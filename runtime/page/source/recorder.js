// What the page has received, for plots, the timeline and CSV.

const kLongest = 18000;  // samples: ten minutes at 30 a second

/** Keeps the last ten minutes of states, without their histograms. */
export class Recorder {
  states = [];

  /** Returns true where time has gone back: a motion began again, and what was before is gone. */
  add(state) {
    const again = state.time < this.states.at(-1)?.time;
    if (again) this.clear();
    this.states.push({...state, histogram: null, counts: null});
    if (this.states.length > kLongest) this.states.splice(0, kLongest / 10);
    return again;
  }

  clear() {
    this.states = [];
  }

  /** Times of the oldest and the newest state, s; both 0 where there is none. */
  get span() {
    return [this.states[0]?.time ?? 0, this.states.at(-1)?.time ?? 0];
  }

  /** The newest state that is no later than `time`, else the oldest. */
  at(time) {
    return this.states[Math.max(this.#count_until(time) - 1, 0)];
  }

  /** States of the last `seconds` until `time`. */
  recent(seconds, time = Infinity) {
    const end = this.#count_until(time);
    const last = this.states[end - 1]?.time ?? 0;
    return this.states.slice(this.#count_until(last - seconds - 1e-9), end);
  }

  /** How many states are no later than `time`. */
  #count_until(time) {
    let low = 0;
    let high = this.states.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.states[middle].time <= time) low = middle + 1;
      else high = middle;
    }
    return low;
  }
}

/** A field as CSV has it: quoted where it holds a separator; empty where there is no number. */
function field(value) {
  const text = value === undefined || value === null || Number.isNaN(value) ? '' : String(value);
  return /[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

/**
 * One row per state below a line of names with units: time, mode, control and `columns`, see
 * `list_columns`. `treeline draw --motion` and `treeline drive --replay` read it too.
 */
export function write_csv(columns, states) {
  const head = ['time [s]', 'mode', 'control', ...columns.map(({quantity, name, unit, title}) =>
    `${title ?? `${quantity}_${name}`} [${unit}]`)];
  const rows = states.map((state) => [state.time, state.mode, state.control,
    ...columns.map(({read}) => read(state))]);
  return [head, ...rows].map((row) => row.map(field).join(',')).join('\n') + '\n';
}
