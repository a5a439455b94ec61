// Single plots: numbers over time with their limits, and histograms of the loop's timing.
import uPlot from 'uplot';

import {element} from '../element.js';
import {css_color} from '../view/stage.js';

const kHeight = 132;   // pixels of a plot without its title and legend
const kColors = 8;     // --line-1 and so on; further lines are dashed
const kAxisWidth = 48;
const kMargin = 0.06;  // of the range, above and below the lines

/** Smallest range that is shown, by unit: less is noise. */
const kLeastRange = {rad: 0.01, deg: 0.5, '°': 0.5, m: 0.002, mm: 1, 'N m': 0.5, N: 0.5, µs: 10};

function axis(values) {
  return {stroke: css_color('--ink-soft'), grid: {stroke: css_color('--line'), width: 1},
    ticks: {show: false}, font: '11px system-ui', size: 30, ...values};
}

function line(label, i, more = {}) {
  return {label, stroke: css_color(`--line-${i % kColors + 1}`), width: 1.5, points: {show: false},
    dash: i < kColors ? undefined : [6, 3], ...more};
}

/** A number with as many digits as people read. */
export function write_number(value) {
  if (value === null || value === undefined || Number.isNaN(value)) return '–';
  if (Math.abs(value) < 5e-5) return '0';
  const digits = Math.max(0, Math.min(4, 3 - Math.ceil(Math.log10(Math.abs(value)) + 1e-9)));
  return value.toFixed(digits);
}

/** Range around the lines, and around their limits if `to_limits`. */
function range_of(low, high, unit, limits) {
  const [least, most] = [Math.min(low ?? 0, ...limits), Math.max(high ?? 0, ...limits)];
  const wanted = Math.max((most - least) * (1 + 2 * kMargin), kLeastRange[unit] ?? 0.01);
  const middle = (least + most) / 2;
  return [middle - wanted / 2, middle + wanted / 2];
}

/** A plot of uPlot in a figure. */
class Plot {
  resize(width) {
    this.plot.setSize({width, height: kHeight});
  }

  destroy() {
    this.plot.destroy();
  }

  get canvas() {
    return this.plot.ctx.canvas;
  }
}

/**
 * Lines over time: `columns` of one quantity, see `list_columns`, shown in `factor` times their
 * unit, which is then `unit`. `to_limits`: the limits are in sight. A click calls `pick(time)`.
 */
export class TimePlot extends Plot {
  #marker = null;

  constructor({title, unit, factor, columns, width, to_limits, pick}) {
    super();
    this.columns = columns;
    this.factor = factor;
    this.limits = columns.map((column) => column.limits.map((limit) => limit * factor));
    this.figure = element('figure', {}, element('figcaption', {}, `${title}, ${unit}`));
    const inside = to_limits ? this.limits.flat() : [];
    this.plot = new uPlot({
      width, height: kHeight,
      series: [{label: 'at', value: (_, time) =>  // none where fewer states are in sight than before
        (Number.isFinite(time) ? `${time.toFixed(2)} s` : '–')},
        ...columns.map(({name}, i) => line(name, i, {value: (_, value) => write_number(value)}))],
      axes: [axis({size: 24, values: (_, ticks) => ticks.map((tick) => `${tick} s`)}),
        axis({size: kAxisWidth, values: (_, ticks) =>
          ticks.map((tick) => String(Number(tick.toPrecision(6))))})],
      scales: {x: {time: false}, y: {range: (_, low, high) => range_of(low, high, unit, inside)}},
      legend: {live: true},
      cursor: {y: false, drag: {x: false, y: false}, points: {size: 6},
        sync: {key: 'treeline', scales: ['x', null]}},
      hooks: {draw: [() => this.#draw_limits(), () => this.#draw_marker()]},
    }, [[], ...columns.map(() => [])], this.figure);
    this.plot.over.addEventListener('click', () => {
      if (this.plot.cursor.idx !== null) pick(this.plot.data[0][this.plot.cursor.idx]);
    });
  }

  /** Shows `states`; `marked` is the moment that the picture shows, null for now. */
  show(times, states, [from, to], marked) {
    this.#marker = marked;
    const {plot, factor} = this;
    const data = [times, ...this.columns.map(({read}) => states.map((state) => {
      const value = read(state);
      return Number.isFinite(value) ? value * factor : null;
    }))];
    plot.batch(() => {
      plot.setData(data, true);
      plot.setScale('x', {min: from, max: to});
    });
    if (plot.cursor.left >= 0) return;
    const idx = marked === null ? times.length - 1 : times.findLastIndex((time) => time <= marked);
    plot.setLegend({idx: Math.max(idx, 0)}, false);
  }

  #stroke(color, dash, [x, y], [to_x, to_y]) {
    const {ctx} = this.plot;
    ctx.save();
    ctx.strokeStyle = color;
    ctx.lineWidth = devicePixelRatio;
    ctx.setLineDash(dash.map((length) => length * devicePixelRatio));
    ctx.beginPath();
    ctx.moveTo(x, y);
    ctx.lineTo(to_x, to_y);
    ctx.stroke();
    ctx.restore();
  }

  #draw_limits() {
    const {left, width} = this.plot.bbox;
    const {min, max} = this.plot.scales.y;
    this.limits.forEach((limits, i) => {
      for (const limit of limits.filter((one) => one >= min && one <= max)) {
        const y = this.plot.valToPos(limit, 'y', true);
        this.#stroke(css_color(`--line-${i % kColors + 1}`), [2, 4], [left, y], [left + width, y]);
      }
    });
  }

  #draw_marker() {
    if (this.#marker === null) return;
    const {top, height} = this.plot.bbox;
    const x = this.plot.valToPos(this.#marker, 'x', true);
    this.#stroke(css_color('--past'), [], [x, top], [x, top + height]);
  }
}

function short(count) {
  if (count === null || count < 1) return '';
  if (count >= 1e6) return `${count / 1e6}M`;
  return count >= 1e3 ? `${count / 1e3}k` : String(count);
}

/** Bins of `counts` that hold something, with a margin: [centres, counts]. */
export function bins(counts, first_us, width_us) {
  let begin = counts.findIndex((count) => count > 0);
  if (begin < 0) return [[first_us], [null]];
  let end = counts.length;
  while (counts[end - 1] === 0) --end;
  begin = Math.max(begin - 2, 0);
  end = Math.min(end + 2, counts.length);
  const indices = Array.from({length: end - begin}, (_, i) => begin + i);
  return [indices.map((i) => first_us + i * width_us), indices.map((i) => counts[i] || null)];
}

/** How many cycles took how long: `read(histogram)` gives [counts, first, width]. */
export class HistogramPlot extends Plot {
  constructor({title, read, width}) {
    super();
    this.read = read;
    this.figure = element('figure', {}, element('figcaption', {}, title));
    this.plot = new uPlot({
      width, height: kHeight, legend: {show: false}, cursor: {show: false},
      series: [{}, line('cycles', 0, {paths: uPlot.paths.bars({size: [1, 40], align: 1}),
        fill: `${css_color('--line-1')}66`})],
      axes: [axis({size: 24, values: (_, ticks) => ticks.map((tick) => `${tick} µs`)}),
        axis({size: kAxisWidth, grid: {show: false}, values: (_, ticks) => ticks.map(short)})],
      scales: {x: {time: false},
        y: {distr: 3, range: (_, low, high) => [0.8, Math.max(high ?? 1, 10) * 2]}},
    }, [[], []], this.figure);
  }

  show_histogram(histogram) {
    this.plot.setData(bins(...this.read(histogram)));
  }
}
