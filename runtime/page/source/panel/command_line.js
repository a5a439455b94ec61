// The command line: history, completion, and what the server answers.
import {element} from '../element.js';
import {is_movable} from '../view/handles.js';
import {accept, complete, shared_beginning} from './complete.js';

const kLongestLog = 200;
const kHistoryKey = 'treeline-history';
const kLongestHistory = 100;

function read_history() {
  try {
    return JSON.parse(sessionStorage.getItem(kHistoryKey)) ?? [];
  } catch {
    return [];
  }
}

export class CommandLine {
  #history = read_history();
  #place = this.#history.length;
  #offers = [];
  #chosen = -1;
  #left = false;  // Escape was pressed: Tab goes on to the next control

  /** `run(line)` sends a line and shows the reply. */
  constructor(root, run) {
    this.run = run;
    this.log = element('div', {className: 'log', role: 'log', 'aria-live': 'polite',
      'aria-label': 'commands and replies', tabIndex: 0});
    this.list = element('ul', {id: 'offers', className: 'offers', role: 'listbox',
      'aria-label': 'words that may follow', hidden: true});
    this.input = element('input', {type: 'text', id: 'command', autocomplete: 'off',
      spellcheck: false, placeholder: 'move tool by 0 0 -0.1 in 2 s', role: 'combobox',
      'aria-label': 'command', 'aria-controls': 'offers', 'aria-expanded': 'false',
      'aria-autocomplete': 'list'});
    root.append(this.log, element('div', {className: 'prompt'},
      element('span', {'aria-hidden': 'true'}, '>'), this.input, this.list));
    this.input.addEventListener('keydown', (event) => this.#press(event));
    this.input.addEventListener('input', () => {
      this.#left = false;
      this.#offer();
    });
    this.input.addEventListener('blur', () => this.#close());
    addEventListener('keydown', (event) => this.#focus_on_slash(event));
  }

  greet(hello) {
    this.hello = hello;
    const point = hello.points[0]?.name;
    const joint = hello.coordinates.find(is_movable);
    if (point) this.input.placeholder = `move ${point} by 0 0 -0.1 in 2 s`;
    else if (joint?.unit === 'm') this.input.placeholder = `joint ${joint.name} by 0.01 in 2 s`;
    else if (joint) this.input.placeholder = `joint ${joint.name} to 20 deg in 2 s`;
    else if (hello.base === 'floating') this.input.placeholder = 'move base by 0 0 0.1 in 2 s';
    this.input.disabled = !hello.may_command;
    if (hello.replay) this.input.placeholder = 'a recorded motion: nothing can be commanded';
    else if (!hello.may_command) this.input.placeholder = 'without the token: watch, and STOP';
  }

  /** Shows a line of text; `kind` is `sent`, `good`, `bad` or `note`. */
  say(text, kind) {
    const at_end = this.log.scrollTop + this.log.clientHeight >= this.log.scrollHeight - 8;
    this.log.append(element('p', {className: kind}, text));
    while (this.log.childElementCount > kLongestLog) this.log.firstChild.remove();
    if (at_end) this.log.scrollTop = this.log.scrollHeight;
  }

  #focus_on_slash(event) {
    if (event.key !== '/' || event.target instanceof HTMLInputElement) return;
    event.preventDefault();
    this.input.focus();
  }

  #press(event) {
    if (event.key === 'Enter') this.#submit();
    else if (event.key === 'Tab' && !event.shiftKey && this.#is_begun()) this.#complete();
    else if (event.key === 'Escape') this.#leave();
    else if (event.key === 'ArrowUp') this.#step(-1);
    else if (event.key === 'ArrowDown') this.#step(1);
    else return;
    event.preventDefault();
  }

  /** Up and down choose among offers once one is chosen, and otherwise walk the history. */
  #step(by) {
    if (this.#chosen >= 0 || (by > 0 && this.#offers.length > 0)) {
      this.#choose(this.#chosen + by);
      return;
    }
    this.#place = Math.min(Math.max(this.#place + by, 0), this.#history.length);
    this.input.value = this.#history[this.#place] ?? '';
    this.#close();
  }

  #submit() {
    if (this.#chosen >= 0) {
      this.#take(this.#offers[this.#chosen]);
      return;
    }
    const line = this.input.value.trim();
    if (line === '') return;
    if (this.#history.at(-1) !== line) this.#history.push(line);
    this.#history = this.#history.slice(-kLongestHistory);
    this.#place = this.#history.length;
    sessionStorage.setItem(kHistoryKey, JSON.stringify(this.#history));
    this.input.value = '';
    this.#close();
    this.run(line);
  }

  /** A line that is begun keeps the focus: outside of it the next blank would stop the robot. */
  #is_begun() {
    return this.input.value.trim() !== '' && !this.#left;
  }

  #leave() {
    this.#left = true;
    this.#close();
  }

  #complete() {
    if (this.#offers.length === 0) {
      if (!this.input.value.endsWith(' ')) this.input.value += ' ';
      this.#offer();
      return;
    }
    if (this.#chosen >= 0 || this.#offers.length === 1) {
      this.#take(this.#offers[Math.max(this.#chosen, 0)]);
      return;
    }
    const begun = this.input.value.match(/\S*$/)[0];
    const shared = shared_beginning(this.#offers);
    if (shared.length > begun.length) {
      this.input.value += shared.slice(begun.length);
      this.#offer();
    } else {
      this.#choose(0);
    }
  }

  #take(word) {
    this.input.value = accept(this.input.value, word);
    this.#offer();
  }

  #offer() {
    this.#offers = this.hello && this.input.value.trim() !== ''
      ? complete(this.input.value, this.hello).slice(0, 12) : [];
    this.#chosen = -1;
    this.list.replaceChildren(...this.#offers.map((word, i) => element('li',
      {role: 'option', id: `offer-${i}`, 'aria-selected': 'false',
        onpointerdown: (event) => { event.preventDefault(); this.#take(word); }}, word)));
    this.#paint();
  }

  #choose(index) {
    this.#chosen = index < 0 ? -1 : index % this.#offers.length;
    this.#paint();
  }

  #close() {
    this.#offers = [];
    this.#chosen = -1;
    this.#paint();
  }

  #paint() {
    const open = this.#offers.length > 0;
    this.list.hidden = !open;
    this.input.setAttribute('aria-expanded', String(open));
    [...this.list.children].forEach((item, i) =>
      item.setAttribute('aria-selected', String(i === this.#chosen)));
    this.input.setAttribute('aria-activedescendant',
      this.#chosen >= 0 ? `offer-${this.#chosen}` : '');
  }
}
