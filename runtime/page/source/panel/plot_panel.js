// Plots of what was recorded: which quantities, which joints, how much time.
import {button, element, toggle} from '../element.js';
import {group_by_limb} from '../limbs.js';
import {kTitles} from '../quantities.js';
import {shown_as} from '../units.js';
import {css_color} from '../view/stage.js';
import {HistogramPlot, TimePlot} from './plots.js';

const kQuickest = 200;  // ms between pictures of the plots
const kShare = 0.1;     // of the time that plots take at most
const kSpans = [5, 10, 20, 60, 300, 600];  // s
const kManyJoints = 8;  // more than that, and the longest limb is shown at first
const kFirst = ['q', 'tau', 'miss', 'shown'];

const kHistograms = [
  {title: 'Period of the cycles, how many took how long',
    read: (all) => [all.period, all.period_from_us, all.width_us]},
  {title: 'Jitter: how late cycles began', read: (all) => [all.jitter, 0, all.width_us]}];

/** Columns that share a plot: those of one quantity and unit. */
function group_by_plot(columns) {
  const plots = new Map();
  for (const column of columns) {
    const [factor, unit] = shown_as(column.shown ?? column.unit, column.unit);
    const key = `${column.quantity} ${unit}`;
    if (!plots.has(key)) plots.set(key, {title: kTitles[column.quantity], unit, factor, columns: []});
    plots.get(key).columns.push(column);
  }
  return [...plots.values()];
}

export class PlotPanel {
  #paused_at = null;  // newest moment that is shown, s
  #past = null;       // the moment that the picture shows, s; null: now
  #due = 0;           // ms
  #plots = [];
  #span = 20;         // s
  #to_limits = false;
  #chosen = new Set(kFirst);
  #joints = new Set();

  /**
   * `recorder` has the states; `save_csv`, `save_png` save what is shown, `widen(yes)` gives the
   * panel more room, `pick(time)` shows the moment of a click.
   */
  constructor(root, recorder, {save_csv, save_png, widen, pick}) {
    Object.assign(this, {root, recorder, pick});
    this.holder = element('div', {className: 'plots'});
    this.quantities = element('div', {className: 'tools', role: 'group',
      'aria-label': 'quantities'});
    this.joint_list = element('div', {className: 'joint-choice'});
    this.joint_title = element('summary');
    const span = element('select', {'aria-label': 'seconds shown', onchange: () => {
      this.#span = Number(span.value);
      this.#due = 0;
    }}, ...kSpans.map((seconds) => element('option', {value: seconds},
      seconds < 60 ? `${seconds} s` : `${seconds / 60} min`)));
    span.value = this.#span;
    root.append(element('div', {className: 'tools'},
      toggle('Pause', 'Keep the plots as they are', false, (yes) => this.#pause(yes)), span,
      toggle('Limits', 'Let the axes reach to the limits, which are dotted', false, (yes) => {
        this.#to_limits = yes;
        this.#rebuild();
      }),
      this.#make_wide(widen),
      button('Save CSV', 'Save what has been received, at most ten minutes', save_csv),
      button('Save PNG', 'Save the plots as a picture', save_png)), this.quantities,
    element('details', {}, this.joint_title, this.joint_list), this.holder);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.#rebuild());
    new ResizeObserver(() => this.#resize()).observe(this.holder);
  }

  greet(hello) {
    this.hello = hello;
    this.limbs = group_by_limb(hello.tree, [...new Set(hello.coordinates.map((one) => one.joint))]);
    const all = this.limbs.flatMap((limb) => limb.joints);
    const longest = this.limbs.reduce((best, limb) =>
      (limb.joints.length > best.joints.length ? limb : best), {joints: []});
    this.#joints = new Set(all.length > kManyJoints ? longest.joints : all);
    this.#offer_joints();
  }

  /** `columns` of `list_columns`: what there is to see. */
  take(columns) {
    this.columns = columns.filter((column) => kTitles[column.quantity]);
    const there = new Set(this.columns.map((column) => column.quantity));
    this.quantities.replaceChildren(...Object.keys(kTitles).filter((name) => there.has(name))
      .map((name) => toggle(kTitles[name], `Show or hide: ${kTitles[name].toLowerCase()}`,
        this.#chosen.has(name), (yes) => {
          this.#chosen[yes ? 'add' : 'delete'](name);
          this.#rebuild();
        })));
    this.#rebuild();
  }

  update(state) {
    if (state.histogram) this.histogram = state.histogram;
    const now = performance.now();
    if (this.root.hidden || now < this.#due) return;
    this.#draw();
    const took = performance.now() - now;
    this.#due = now + Math.max(kQuickest, took / kShare);
  }

  /** Marks the moment that the picture shows; null: now. */
  show_past(time) {
    this.#past = time;
    this.#due = 0;
  }

  /** Units have changed. */
  repaint() {
    if (this.columns) this.#rebuild();
  }

  /** All plots below each other, as one canvas. */
  draw_all() {
    const figures = [...this.holder.children];
    const canvases = this.#plots.map((plot) => plot.canvas);
    const all = element('canvas', {width: Math.max(1, ...canvases.map((one) => one.width)),
      height: Math.max(1, canvases.reduce((sum, one) => sum + one.height + 72, 0))});
    const context = all.getContext('2d');
    context.fillStyle = css_color('--panel');
    context.fillRect(0, 0, all.width, all.height);
    context.fillStyle = css_color('--ink');
    let y = 0;
    canvases.forEach((one, i) => {
      context.font = '20px system-ui, sans-serif';
      context.fillText(figures[i].querySelector('figcaption').textContent, 12, y + 26);
      context.font = '14px system-ui, sans-serif';
      this.#write_legend(context, this.#plots[i], 12, y + 50);
      context.drawImage(one, 0, y + 60);
      y += one.height + 72;
    });
    return all;
  }

  #write_legend(context, {columns = [], plot}, left, y) {
    let x = left;
    columns.forEach(({name}, i) => {
      context.save();
      context.fillStyle = plot.series[i + 1].stroke();
      context.fillText(name, x, y);
      x += context.measureText(name).width + 14;
      context.restore();
    });
  }

  #make_wide(widen) {
    const wide = toggle('Wide', 'Give the panels half of the page', false, widen);
    wide.classList.add('widen');
    return wide;
  }

  #pause(yes) {
    this.#paused_at = yes ? this.recorder.span[1] : null;
    this.#due = 0;
  }

  #offer_joints() {
    const choose = (names, yes) => {
      for (const name of names) this.#joints[yes ? 'add' : 'delete'](name);
      this.#offer_joints();
      this.#rebuild();
    };
    const one = (name) => toggle(name, `Show or hide ${name}`, this.#joints.has(name),
      (yes) => {
        this.#joints[yes ? 'add' : 'delete'](name);
        this.#count_joints();
        this.#rebuild();
      });
    this.joint_list.replaceChildren(...this.limbs.map(({title, joints}) => element('div',
      {className: 'tools', role: 'group', 'aria-label': `joints of ${title}`},
      element('span', {className: 'limb'}, title),
      button('All', `Show all joints of ${title}`, () => choose(joints, true)),
      button('None', `Hide all joints of ${title}`, () => choose(joints, false)),
      ...joints.map(one))));
    this.#count_joints();
  }

  #count_joints() {
    const count = this.limbs.reduce((sum, limb) => sum + limb.joints.length, 0);
    this.joint_title.textContent = `Joints: ${this.#joints.size} of ${count}`;
  }

  #draw() {
    const marked = this.#past;
    const newest = this.#paused_at ?? this.recorder.span[1];
    // A moment of the past is in sight, in the middle if it is long ago.
    const end = marked !== null && marked < newest - this.#span ? marked + this.#span / 2 : newest;
    const states = this.recorder.recent(this.#span, end);
    const times = states.map((state) => state.time);
    const range = [Math.max(end - this.#span, this.recorder.span[0]), end];
    for (const plot of this.#plots) {
      if (plot instanceof TimePlot) plot.show(times, states, range, marked);
      else if (this.histogram) plot.show_histogram(this.histogram);
    }
  }

  #rebuild() {
    if (!this.columns) return;
    for (const plot of this.#plots) plot.destroy();
    const width = this.#width();
    const shown = this.columns.filter(({quantity, joint}) => this.#chosen.has(quantity) &&
      (joint === undefined || this.#joints.has(joint)));
    this.#plots = group_by_plot(shown).map((wanted) =>
      new TimePlot({...wanted, width, to_limits: this.#to_limits, pick: this.pick}));
    if (this.#chosen.has('control')) {
      this.#plots.push(...kHistograms.map((wanted) => new HistogramPlot({...wanted, width})));
    }
    this.holder.replaceChildren(...this.#plots.map((plot) => plot.figure));
    this.#due = 0;
  }

  #width() {
    return Math.max(this.holder.clientWidth, 200);
  }

  #resize() {
    for (const plot of this.#plots) plot.resize(this.#width());
  }
}
