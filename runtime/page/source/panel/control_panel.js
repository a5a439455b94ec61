// Choice of the control, and its gains.
import {button, element} from '../element.js';
import {number} from '../lines.js';

const kStiffness = 225;  // 1/s², with which the server begins
const kDamping = 30;     // 1/s

const kControls = {
  joint: 'Each joint follows its own goal.',
  task: 'The operational points follow theirs; the posture has what freedom is left.',
  gravity: 'The robot carries its weight and gives way: lead it by hand.',
};

const kRehearsal = [
  ['rehearse', 'Rehearse', 'From now on motions are for a twin, which is shown as a ghost'],
  ['go', 'Go', 'The robot does what its twin has done'],
  ['discard', 'Discard', 'Forget the rehearsal'],
];

function make_gain(label, value, hint) {
  return element('input', {type: 'number', min: 0, step: 'any', value: String(value),
    'aria-label': label, title: hint});
}

export class ControlPanel {
  constructor(root, run) {
    this.run = run;
    this.buttons = element('div', {className: 'choices'});
    this.counts = element('dl', {className: 'counts'});
    this.rehearsal = kRehearsal.map(([line, label, hint]) => button(label, hint, () => run(line)));
    this.of_drive = [element('h2', {}, 'Rehearse, then go'),
      element('div', {className: 'row', role: 'group', ariaLabel: 'rehearsal'}, ...this.rehearsal),
      element('h2', {}, 'Gains, 1/s² and 1/s'), this.#make_gains('joint'),
      this.#make_gains('task')];
    root.append(element('h2', {}, 'Control'), this.buttons, ...this.of_drive,
      element('h2', {}, 'The loop'), this.counts);
  }

  greet(hello) {
    this.choices = hello.controls.map((name) => {
      const choice = button('', kControls[name] ?? '', () => this.run(`mode ${name}`), 'choice');
      choice.append(element('strong', {}, name), element('span', {}, kControls[name] ?? ''));
      choice.dataset.control = name;
      return choice;
    });
    this.buttons.replaceChildren(...this.choices);
    // A controller of the robot's own has its gains, and no twin.
    for (const part of this.of_drive) part.hidden = hello.controller === 'own';
    this.rate = hello.rate;
    this.may_command = hello.may_command;
  }

  update(state) {
    for (const choice of this.choices) {
      choice.setAttribute('aria-pressed', String(choice.dataset.control === state.control));
    }
    const [, go, discard] = this.rehearsal;
    go.disabled = discard.disabled = !state.twin || !this.may_command;
    const rows = {'Rate': `${this.rate} Hz`, 'Time': `${state.time.toFixed(1)} s`,
      'Cycles': state.cycles ?? '–', 'Overruns': state.overruns ?? '–',
      ...Object.fromEntries(Object.entries(state.counts ?? {}).map(([name, count]) =>
        [`Messages ${name}`, count]))};
    this.#show_counts(rows);
  }

  #show_counts(rows) {
    const names = Object.keys(rows);
    if (this.counts.childElementCount !== names.length) {
      this.counts.replaceChildren(...names.map((name) => element('div', {},
        element('dt', {}, name), element('dd', {className: 'number'}))));
    }
    names.forEach((name, i) => {
      const value = this.counts.children[i].lastChild;
      if (value.textContent !== String(rows[name])) value.textContent = rows[name];
    });
  }

  #make_gains(control) {
    const stiffness = make_gain(`${control} stiffness`, kStiffness, '1/s²');
    const damping = make_gain(`${control} damping`, kDamping, '1/s');
    return element('form', {className: 'numbers', 'aria-label': `gains of the ${control} control`,
      onsubmit: (event) => {
        event.preventDefault();
        if (!(stiffness.valueAsNumber >= 0) || !(damping.valueAsNumber >= 0)) return;
        this.run(`gains ${control} stiffness ${number(stiffness.valueAsNumber)} ` +
          `damping ${number(damping.valueAsNumber)}`);
      }}, element('span', {}, control), element('label', {}, 'stiffness ', stiffness),
    element('label', {}, 'damping ', damping), element('button', {type: 'submit'}, 'Set'));
  }
}
