// The top of the page: who, how it goes, and the buttons that start and stop.
import {button, element, set_text} from '../element.js';

const kModes = {idle: 'Idle', running: 'Running', stopping: 'Stopping', faulted: 'Fault',
  replay: 'Replay'};

function chip(label) {
  return element('span', {className: `chip ${label}`, role: 'status', 'aria-label': label});
}

function show(target, text, tone) {
  set_text(target, text);
  target.dataset.tone = tone;
}

/** True where a blank is a letter and not the emergency stop. */
function takes_blanks(target) {
  return target instanceof HTMLInputElement && target.type === 'text' && target.value.trim() !== '';
}

/** What is wrong, and what to do; empty if nothing is. `offered`: a motion was tried before. */
function words_of(state, offered) {
  if (offered && state.mode === 'idle') return 'The robot is idle: press Start, then try again';
  if (state.mode === 'faulted') return `${state.fault || 'stopped'}: press Reset, then Start`;
  return state.fault || (state.saturated ? 'a torque is at its limit' : '');
}

export class StatusBar {
  #may_command = true;
  #commanding = false;
  #open = false;
  #replays = false;
  #offered = null;
  #offered_in = '';  // the mode

  /**
   * `fault` is where faults are said, `offer` where a button that is missing is offered;
   * `run(line)` sends a line and shows the reply.
   */
  constructor(root, fault, offer, run) {
    Object.assign(this, {run, fault});
    this.shortcut = button('', 'What has to be pressed first', () => this.#offered?.click());
    this.shortcut.hidden = true;
    offer.append(this.shortcut);
    this.name = element('h1', {}, 'treeline drive');
    this.link = chip('connection');
    this.mode = chip('mode');
    this.role = chip('command');
    this.hand_over = button('Take command', 'Ask for the command over the robot, or give it up',
      () => run(this.#commanding ? 'give' : 'take'), 'hand-over');
    const control = (word, hint) => button(word[0].toUpperCase() + word.slice(1), hint,
      () => run(word));
    this.controls = [control('start', 'Control the robot from where it is'),
      control('hold', 'Stop all motions and hold'),
      control('brake', 'Brake to rest, then idle'),
      control('reset', 'Leave the fault or the emergency stop')];
    this.stop = button('STOP', 'Emergency stop, for everybody who watches too. The space bar does ' +
      'the same, except in a command that has been begun.', () => run('stop'), 'stop');
    this.stop.setAttribute('aria-keyshortcuts', 'Space');
    this.stop.append(element('small', {}, 'space'));
    root.append(this.name, element('div', {className: 'chips'}, this.link, this.mode, this.role),
      element('div', {className: 'controls'}, this.hand_over, ...this.controls),
      this.stop);
    addEventListener('keydown', (event) => this.#stop_on_space(event), {capture: true});
    this.#paint_role();
    show(this.mode, '–', 'quiet');
  }

  greet(hello) {
    set_text(this.name, hello.name);
    this.name.title = `${hello.name}, ${hello.base} base, ${hello.rate} Hz`;
    document.title = `${hello.name} – treeline drive`;
    this.#may_command = hello.may_command;
    this.#replays = Boolean(hello.replay);
    this.#enable_buttons();
    this.#paint_role();
  }

  show_link({open, silent}) {
    if (!open) show(this.link, 'Connection lost', 'bad');
    else if (silent) show(this.link, 'Servo silent', 'bad');
    else show(this.link, 'Connected', 'good');
    this.#open = open;
    this.#enable_buttons();
    if (!open) show(this.mode, 'Unknown', 'quiet');
  }

  update(state) {
    const tone = {running: 'good', faulted: 'bad', stopping: 'warn'}[state.mode] ?? 'quiet';
    const control = state.mode === 'running' && state.control ? ` (${state.control})` : '';
    show(this.mode, (kModes[state.mode] ?? state.mode) + control, tone);
    if (state.mode !== this.#offered_in) this.#withdraw();
    set_text(this.fault, words_of(state, this.#offered !== null));
    this.fault.dataset.tone = state.fault ? 'bad' : 'warn';
    this.state = state;
    this.#commanding = state.commanding;
    this.#paint_role();
  }

  /** Shows which button has to be pressed before what was tried: `Start` or `Reset`. */
  offer(label) {
    this.#withdraw();
    this.#offered = this.controls.find((one) => one.textContent === label) ?? null;
    this.#offered_in = this.state?.mode;
    this.#offered?.classList.add('offered');
    this.shortcut.hidden = !this.#offered;
    set_text(this.shortcut, label);
    if (this.state) this.update(this.state);
  }

  #withdraw() {
    this.#offered?.classList.remove('offered');
    this.#offered = null;
    this.shortcut.hidden = true;
  }

  #enable_buttons() {
    for (const one of [this.hand_over, ...this.controls]) {
      one.disabled = !this.#open || !this.#may_command;
    }
    this.stop.disabled = this.#replays;
  }

  #paint_role() {
    const count = (this.state?.watchers ?? 1) - 1;  // without this page
    const others = count > 0 ? `, ${count} watching` : '';
    if (this.#replays) show(this.role, 'Watching only', 'quiet');
    else if (!this.#may_command) show(this.role, 'Watching, may stop', 'quiet');
    else if (this.#commanding) show(this.role, `In command${others}`, 'good');
    else if (this.state?.commander) show(this.role, 'Another commands', 'warn');
    else show(this.role, 'Nobody commands', 'quiet');
    set_text(this.hand_over, this.#commanding ? 'Give command' : 'Take command');
  }

  #stop_on_space(event) {
    if (event.key !== ' ' || event.repeat || takes_blanks(event.target)) return;
    event.preventDefault();
    if (this.#replays) return;
    this.run('stop');
    this.stop.classList.add('pressed');
    setTimeout(() => this.stop.classList.remove('pressed'), 300);
  }
}
