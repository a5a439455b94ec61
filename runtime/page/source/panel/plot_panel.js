// Live plots: control time, histogram of period and jitter, tracking error.
import uPlot from 'uplot';

import {button, element, toggle} from '../element.js';
import {tracking_error} from '../recorder.js';
import {points_of, point_states_of} from '../view/robot_view.js';
import {css_color} from '../view/stage.js';

const kSpan = 20;      // s shown
const kPeriod = 200;   // ms between pictures of the plots
const kHeight = 112;   // pixels of a plot without its title
const kColors = ['--line-1', '--line-2', '--line-3', '--line-4'];

function axis(values) {
  return {stroke: css_color('--ink-soft'), grid: {stroke: css_color('--line'), width: 1},
    ticks: {show: false}, font: '11px system-ui', size: 30, ...values};
}

function series(label, i, more = {}) {
  return {label, stroke: css_color(kColors[i % kColors.length]), width: 1.5,
    points: {show: false}, ...more};
}

/** Options of a plot over time, in seconds, whose y axis reaches at least to `least`. */
function over_time(labels, least) {
  return {
    series: [{}, ...labels.map((label, i) => series(label, i))],
    axes: [axis({size: 24, values: (_, ticks) => ticks.map((tick) => `${tick} s`)}),
      axis({size: 44,
        values: (_, ticks) => ticks.map((tick) => String(Number(tick.toPrecision(4))))})],
    scales: {x: {time: false}, y: {range: (_, low, high) => [Math.min(low ?? 0, 0),
      Math.max(high ?? 1, least) * 1.1]}},
  };
}

function as_histogram(labels) {
  const bars = uPlot.paths.bars({size: [1, 40], align: 1});
  return {
    series: [{}, ...labels.map((label, i) => series(label, i,
      {paths: bars, fill: `${css_color(kColors[i])}66`}))],
    axes: [axis({size: 24, values: (_, ticks) => ticks.map((tick) => `${tick} µs`)}),
      axis({size: 44, grid: {show: false}, values: (_, ticks) => ticks.map(short)})],
    scales: {x: {time: false},
      y: {distr: 3, range: (_, low, high) => [0.8, Math.max(high ?? 1, 10) * 2]}},
  };
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

export class PlotPanel {
  #paused = false;
  #last = 0;
  #plots = [];

  /** `recorder` has the states; `save_csv`, `save_png` save what is shown. */
  constructor(root, recorder, {save_csv, save_png}) {
    this.root = root;
    this.recorder = recorder;
    this.holder = element('div', {className: 'plots'});
    root.append(element('div', {className: 'tools'},
      toggle('Pause', 'Keep the plots as they are', false, (yes) => { this.#paused = yes; }),
      button('Save CSV', 'Save what has been received, at most ten minutes', save_csv),
      button('Save PNG', 'Save the plots as a picture', save_png)), this.holder);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.#rebuild());
    new ResizeObserver(() => this.#resize()).observe(this.holder);
  }

  greet(hello) {
    this.hello = hello;
    this.#rebuild();
  }

  update(state) {
    const now = performance.now();
    if (this.#paused || this.root.hidden || now - this.#last < kPeriod) return;
    this.#last = now;
    const states = this.recorder.recent(kSpan);
    const times = states.map((one) => one.time);
    const points = points_of(this.hello).length;
    this.#plots[0]?.setData([times, states.map((one) => one.control_us.mean),
      states.map((one) => one.control_us.max)]);
    const histogram = state.histogram;
    this.#plots[1]?.setData(bins(histogram.period, histogram.period_from_us, histogram.width_us));
    this.#plots[2]?.setData(bins(histogram.jitter, 0, histogram.width_us));
    this.#plots[3]?.setData([times, ...Array.from({length: points}, (_, i) => states.map((one) =>
      1000 * tracking_error(point_states_of(this.hello, one)[i])))]);
  }

  /** All plots below each other, as one canvas. */
  draw_all() {
    const canvases = this.#plots.map((plot) => plot.ctx.canvas);
    const all = element('canvas', {width: Math.max(...canvases.map((one) => one.width)),
      height: canvases.reduce((sum, one) => sum + one.height + 40, 0)});
    const context = all.getContext('2d');
    context.fillStyle = css_color('--panel');
    context.fillRect(0, 0, all.width, all.height);
    context.fillStyle = css_color('--ink');
    context.font = '24px system-ui, sans-serif';
    let y = 0;
    canvases.forEach((one, i) => {
      context.fillText(this.titles[i], 12, y + 28);
      context.drawImage(one, 0, y + 40);
      y += one.height + 40;
    });
    return all;
  }

  #rebuild() {
    if (!this.hello) return;
    for (const plot of this.#plots) plot.destroy();
    const points = points_of(this.hello).map((point) => point.name);
    const wanted = [['Control time of a cycle, µs', over_time(['mean', 'largest'], 10)],
      ['Period of the cycles, how many took how long', as_histogram(['cycles'])],
      ['Jitter: how late cycles began', as_histogram(['cycles'])]];
    if (points.length > 0) {
      wanted.push(['Distance of points from their goals, mm', over_time(points, 1)]);
    }
    this.titles = wanted.map(([title]) => title);
    this.holder.replaceChildren();
    this.#plots = wanted.map(([title, options]) => this.#add(title, options));
  }

  #add(title, options) {
    const place = element('figure', {}, element('figcaption', {}, title));
    this.holder.append(place);
    const several = options.series.length > 2;
    return new uPlot({...options, width: this.#width(), height: kHeight,
      legend: {show: several, live: false}, cursor: {show: false}},
    options.series.map(() => []), place);
  }

  #width() {
    return Math.max(this.holder.clientWidth, 200);
  }

  #resize() {
    for (const plot of this.#plots) plot.setSize({width: this.#width(), height: kHeight});
  }
}
