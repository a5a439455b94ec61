// The past: what was recorded is shown again, while the robot goes on.
import {button, element, set_text} from '../element.js';

const kSpeeds = [0.1, 0.25, 0.5, 1, 2, 4];
const kBack = 10;     // s that `Replay` begins before now
const kPeriod = 33;   // ms between pictures
const kSeldom = 200;  // ms between pictures of the timeline itself, while time merely passes
const kStep = 0.1;    // s that an arrow key moves

/**
 * The timeline below the picture. In the past it asks `show(state)` for the picture of a moment,
 * and `show(null)` on the way back. A replay stays in the past, at its end too, until somebody
 * leaves it: handles that come back by themselves would be grabbed by accident.
 */
export class Timeline {
  #time = null;  // s; null: the picture shows the robot as it is
  #timer = 0;
  #painted = 0;  // ms
  #is_record = false;  // the server shows a record, over and over

  constructor(root, recorder, show) {
    Object.assign(this, {recorder, show});
    this.way = button('Replay', '',
      () => (this.is_past ? this.leave() : this.#go_back()), 'way');
    this.play_button = button('Pause', 'Play, or stay at this moment',
      () => this.#play(!this.#timer), 'play');
    this.slider = element('input', {type: 'range', step: kStep, min: 0, max: 0,
      'aria-label': 'moment shown', oninput: () => this.go_to(Number(this.slider.value))});
    this.speed = element('select', {'aria-label': 'speed of the replay'},
      ...kSpeeds.map((speed) => element('option', {value: speed}, `× ${speed}`)));
    this.speed.value = 1;
    this.label = element('span', {className: 'number moment'});
    root.append(this.way, this.play_button, this.speed, this.label, this.slider);
    this.#paint();
  }

  get is_past() {
    return this.#time !== null;
  }

  greet(hello) {
    this.#is_record = Boolean(hello.replay);
    this.leave();
  }

  /** Records a live state. Returns true where a motion has begun again. */
  take(state) {
    if (this.is_past && this.#is_record) return false;  // what is looked at stays
    const again = this.recorder.add(state);
    if (again) this.leave();
    if (performance.now() > this.#painted + kSeldom) this.#paint();
    return again;
  }

  /** Shows the moment `time`, s, and stays there. */
  go_to(time) {
    this.#play(false);
    this.#show(time);
  }

  leave() {
    this.#play(false);
    if (!this.is_past) return;
    this.#time = null;
    this.#paint();
    this.show(null);
  }

  #go_back() {
    this.#show(this.recorder.span[1] - kBack);
    this.#play(true);
  }

  #play(yes) {
    clearInterval(this.#timer);
    this.#timer = 0;
    if (yes && this.is_past) {
      if (this.#time >= this.recorder.span[1]) this.#show(this.recorder.span[0]);
      let last = performance.now();
      this.#timer = setInterval(() => {
        const now = performance.now();
        this.#show(this.#time + (now - last) / 1000 * Number(this.speed.value));
        last = now;
      }, kPeriod);
    }
    this.#paint();
  }

  #show(time) {
    if (this.recorder.states.length === 0) return;
    const [oldest, newest] = this.recorder.span;
    this.#time = Math.min(Math.max(time, oldest), newest);
    if (time >= newest && this.#timer) this.#play(false);
    this.#paint();
    this.show(this.recorder.at(this.#time));
  }

  #paint() {
    this.#painted = performance.now();
    const [oldest, newest] = this.recorder.span;
    const {slider} = this;
    slider.min = oldest;
    slider.max = newest;
    slider.value = this.#time ?? newest;
    const ago = (this.#time ?? newest) - newest;
    const text = this.is_past ? `${ago.toFixed(1).replace('-', '−')} s` : 'now';
    set_text(this.label, text);
    slider.setAttribute('aria-valuetext', this.is_past ? `${(-ago).toFixed(1)} s ago` : 'now');
    set_text(this.way, this.is_past ? 'Back to now' : 'Replay');
    this.way.title = this.is_past ? 'Show the robot as it is'
      : `Show the last ${kBack} s again; the robot goes on`;
    set_text(this.play_button, this.#timer ? 'Pause' : 'Play');
    this.play_button.disabled = this.speed.disabled = !this.is_past;
  }
}
