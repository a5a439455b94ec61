// Numbers for operational points: the twins of planes, belts and pulls.
import {button, element, set_text} from '../element.js';
import {move_line, pull_line, turn_line} from '../lines.js';
import {distance_from_goal, point_states_of, points_of} from '../points.js';
import {Lease} from '../view/lease.js';

/** Three numbers with one label. `values()` is null while one is missing. */
function make_triple(label, names, initial = 0) {
  const inputs = names.map((name) => element('input',
    {type: 'number', step: 'any', value: String(initial), 'aria-label': `${label} ${name}`}));
  return {inputs, values: () => {
    const read = inputs.map((input) => input.valueAsNumber);
    return read.every(Number.isFinite) ? read : null;
  }};
}

/** A form of one line: pressing Enter in a number or the button submits it. */
function make_form(label, parts, on_submit) {
  return element('form', {className: 'numbers', 'aria-label': label, onsubmit: (event) => {
    event.preventDefault();
    on_submit();
  }}, ...parts);
}

function submit(label, hint) {
  return element('button', {type: 'submit', title: hint}, label);
}

function write_place(values) {
  return values.map((x) => x.toFixed(3)).join('  ');
}

class PointCard {
  constructor(point, {run, duration}) {
    this.place = element('span', {className: 'number'});
    this.error = element('span', {className: 'number'});
    const move = make_triple(`move ${point.name}`, ['x', 'y', 'z']);
    const turn = make_triple(`turn ${point.name}`, ['x', 'y', 'z']);
    const send_move = (how) => {
      if (move.values()) run(move_line(point.name, how, move.values(), duration()));
    };
    const send_turn = () => {
      if (turn.values()) run(turn_line(point.name, turn.values(), duration()));
    };
    const holds = point.is_base ? [] : [
      button('Hold', `Hold ${point.name} where its goal is`, () => run(`hold ${point.name}`)),
      button('Release', `Let ${point.name} go; it is only damped`,
        () => run(`release ${point.name}`))];
    this.card = element('section', {className: 'card', 'aria-label': point.name},
      element('header', {}, element('h2', {}, point.name), ...holds),
      element('p', {className: 'readout'}, 'at ', this.place, ' m, from its goal ', this.error,
        ' mm'),
      make_form(`move ${point.name}`, [element('span', {}, 'Move m'), ...move.inputs,
        submit('by', 'Move by this much, in the axes of the world'),
        button('to', 'Move to this place in the world', () => send_move('to'))],
      () => send_move('by')),
      make_form(`turn ${point.name}`, [element('span', {}, 'Turn °'), ...turn.inputs,
        submit('by', 'Turn by this rotation vector, in the axes of the world')], send_turn));
  }

  show(state) {
    set_text(this.place, write_place(state.at));
    const error = 1000 * distance_from_goal(state);
    set_text(this.error, Number.isFinite(error) ? error.toFixed(1) : '–');
  }
}

export class PointPanel {
  /** `run(line)` sends and shows the reply, `send(line)` sends a line of a pull. */
  constructor(root, {run, send, duration}) {
    Object.assign(this, {run, duration});
    this.lease = new Lease(send);
    this.list = element('div');
    this.link = element('select', {'aria-label': 'link to pull'});
    this.pull = this.#make_pull();
    root.append(this.list, this.pull);
  }

  greet(hello) {
    this.hello = hello;
    const points = points_of(hello);
    this.cards = points.map((point) => new PointCard(point, this));
    this.list.replaceChildren(...this.cards.map((card) => card.card));
    if (points.length === 0) {
      this.list.append(element('p', {className: 'hint'},
        'The scene has no operational points: only joints can be commanded.'));
    }
    this.link.replaceChildren(...hello.links.map((name) => element('option', {}, name)));
    this.link.selectedIndex = hello.links.length - 1;
    this.pull.hidden = hello.links.length === 0;
  }

  update(state) {
    point_states_of(this.hello, state).forEach((point, i) => this.cards[i].show(point));
  }

  release() {
    this.lease.end();
  }

  #make_pull() {
    const at = make_triple('pull at', ['x', 'y', 'z']);
    const to = make_triple('pull to', ['x', 'y', 'z']);
    const seconds = element('input', {type: 'number', min: 0.1, max: 10, step: 0.1, value: '1',
      'aria-label': 'pull for seconds'});
    const pull = () => {
      if (!at.values() || !to.values()) return;
      this.lease.begin();
      this.lease.update(pull_line(this.link.value, at.values(), to.values()));
      setTimeout(() => this.lease.end(), 1000 * Math.min(seconds.valueAsNumber || 0, 10));
    };
    return element('section', {className: 'card', 'aria-label': 'pull a link'},
      element('header', {}, element('h2', {}, 'Pull a link')),
      element('p', {className: 'readout'},
        'A spring from a place on the link to one in the world.'),
      make_form('pull a link', [element('span', {}, 'Link'), this.link,
        element('span', {}, 'for s'), seconds, submit('pull', 'Pull for this long')], pull),
      element('div', {className: 'numbers'}, element('span', {}, 'at'), ...at.inputs),
      element('div', {className: 'numbers'}, element('span', {}, 'to'), ...to.inputs));
  }
}
