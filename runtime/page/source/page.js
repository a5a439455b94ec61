// The page of `treeline drive`: connects the server's messages with the picture and the panels.
import {Connection, socket_address} from './connection.js';
import {button, element, set_text, toggle} from './element.js';
import {CommandLine} from './panel/command_line.js';
import {ControlPanel} from './panel/control_panel.js';
import {JointPanel} from './panel/joint_panel.js';
import {PlotPanel} from './panel/plot_panel.js';
import {PointPanel} from './panel/point_panel.js';
import {StatusBar} from './panel/status_bar.js';
import {make_tabs} from './panel/tabs.js';
import {Timeline} from './panel/timeline.js';
import {ViewPanel} from './panel/view_panel.js';
import {list_columns} from './quantities.js';
import {Recorder, write_csv} from './recorder.js';
import {save_as, save_text} from './save.js';
import {say} from './units.js';
import {RobotView} from './view/robot_view.js';

const find = (selector) => document.querySelector(selector);

const connection = new Connection(socket_address(location));
const recorder = new Recorder();
const command_line = new CommandLine(find('#command-line'), run);
const status = new StatusBar(find('#status'), find('#fault'), find('#offer'), run);
const view = new RobotView(find('#view canvas'), {send: send_drag, say,
  tell: (text) => set_text(find('#tip'), text), report: (text) => command_line.say(text, 'note')});

let hello = null;
let columns = null;  // of the recorder's states, once one is shown
let own_numbers = '';  // names that the robot's own controller shows
let refusal = '';  // what the server last said against a drag: said once

/** Sends a line, and shows it and the reply. */
async function run(line) {
  command_line.say(line, 'sent');
  const reply = await connection.send(line);
  command_line.say(reply.text, reply.ok ? 'good' : 'bad');
  offer_what_is_missing(reply);
  return reply;
}

/** A motion that is refused because the robot does not run leads to the button that is missing. */
function offer_what_is_missing({ok, text}) {
  const missing = ok ? null : text.match(/`(start|reset)` first/)?.[1];
  if (missing) status.offer(missing === 'start' ? 'Start' : 'Reset');
}

/** Sends a line of a drag. Only a refusal is shown, and only once. */
async function send_drag(line) {
  const reply = await connection.send(line);
  if (reply.ok || reply.text === refusal) return;
  offer_what_is_missing(reply);
  refusal = reply.text;
  command_line.say(`${line}: ${reply.text}`, 'bad');
}

function add_duration(root) {
  const input = element('input', {type: 'number', min: 0, max: 600, step: 0.1, value: '2',
    id: 'duration'});
  root.append(element('label', {className: 'duration'}, 'Time of a motion ', input, ' s'));
  return () => (input.valueAsNumber > 0 ? input.valueAsNumber : 0);
}

function file_name(ending) {
  return `${hello?.name ?? 'robot'}.${ending}`;
}

const save_picture = () => save_as(file_name('png'), view.write_png());
const duration = add_duration(find('#panels'));
const tabs = make_tabs(find('#panels'), ['Joints', 'Points', 'Control', 'Plots', 'View']);
const senders = {run, send: send_drag, duration};
const view_panel = new ViewPanel(tabs.View, view, save_picture);
const joint_panel = new JointPanel(tabs.Joints, senders, () => plot_panel.repaint());
const point_panel = new PointPanel(tabs.Points, senders);
const plot_panel = new PlotPanel(tabs.Plots, recorder, {
  save_csv: () => columns && save_text(file_name('csv'), 'text/csv',
    write_csv(columns, recorder.states)),
  save_png: () => save_as(file_name('plots.png'), plot_panel.draw_all().toDataURL('image/png')),
  widen: (yes) => find('main').classList.toggle('wide', yes),
  pick: (time) => timeline.go_to(time),
});
const timeline = new Timeline(find('#timeline'), recorder, show_moment);
const panels = [status, joint_panel, point_panel, new ControlPanel(tabs.Control, run), plot_panel,
  command_line];

const pull = toggle('Pull links',
  'Dragging a link pulls it with a spring, instead of turning the picture', false,
  (yes) => { view.gestures.pulls_links = yes; });
const cameras = [['Fit', 'Place the camera so that the whole robot is seen'],
  ['Iso', 'See the whole robot from the front, the right and above'],
  ['Front', 'See it from the front: against x'], ['Side', 'See it from its right: along y'],
  ['Top', 'See it from above: against z, with x to the right']].map(([label, hint]) =>
  button(label, hint, () => view.model && view.look_at_all(label.toLowerCase())));
find('#view-tools').append(pull, element('div', {className: 'cameras', role: 'group',
  'aria-label': 'camera'}, ...cameras));

/** Whoever only watches sees that nothing but the stop is for him. */
function enable_commands(may_command) {
  for (const part of [tabs.Joints, tabs.Points, tabs.Control]) {
    for (const control of part.querySelectorAll('button, input, select')) {
      control.disabled = !may_command && control !== joint_panel.units;
    }
  }
  find('#duration').disabled = !may_command;
  allow_drags();
}

/** In the past nothing can be grabbed: the robot is elsewhere. */
function allow_drags() {
  view.may_drag = hello.may_command && !timeline.is_past;
  pull.disabled = !view.may_drag || hello.links.length === 0;
}

/** Shows a state of the past, or, if `state` is null, the robot as it is again. */
function show_moment(state) {
  const is_past = state !== null;
  if (!view.model) return;
  view.gestures.end();
  allow_drags();
  document.body.classList.toggle('past', is_past);
  set_text(find('#past'),
    is_past ? 'This is the past. Buttons act on the robot as it is now.' : '');
  plot_panel.show_past(state?.time ?? null);
  const shown = state ?? window.treeline.state;
  window.treeline.shown = shown;
  view.show(shown);
}

async function greet(message) {
  const same = hello !== null && hello.robot === message.robot;
  hello = message;
  if (same) {
    status.greet(message);
    command_line.greet(message);
    enable_commands(message.may_command);
    return;
  }
  recorder.clear();
  timeline.greet(message);
  const answer = await fetch('/robot.urdf');
  if (!answer.ok) {
    command_line.say(`the robot's URDF cannot be had: ${answer.status}`, 'bad');
    return;
  }
  view.load(await answer.text(), message);
  view_panel.apply(view);
  const with_tree = {...message, tree: view.tree};
  for (const panel of panels) panel.greet?.(with_tree);
  columns = null;  // states that came while the URDF did were for the panels of before
  enable_commands(message.may_command);
}

function show_link(link) {
  status.show_link(link);
  const lost = find('#lost');
  lost.hidden = link.open && !link.silent;
  if (!link.open) {
    view.gestures.end();
    joint_panel.release();
    point_panel.release();
    set_text(lost, 'The connection is lost. The robot holds. Trying again.');
  } else if (link.silent) {
    set_text(lost, 'The servo loop says nothing. What is shown is old.');
  }
}

function show_state(state) {
  const again = timeline.take(state);
  if (!view.model) return;
  const names = Object.keys(state.shown ?? {}).join();
  if (!columns || names !== own_numbers) {
    own_numbers = names;
    columns = list_columns(hello, state);
    plot_panel.take(columns);
  }
  window.treeline.state = state;
  if (again) view.clear_traces();
  view.trace(state);
  if (!timeline.is_past) {
    view.show(state);
    window.treeline.shown = state;
  }
  for (const panel of panels) panel.update?.(state);
  view_panel.update(state, view.stage);
}

// For tests and for people at the console: the newest state, the one that the picture shows, the
// picture as a PNG, and where handles are on the screen.
window.treeline = {state: null, shown: null, where: (name) => view.where(name), picture: () => view.write_png(),
  handles: () => view.handles?.list.map((handle) => handle.name) ?? []};

connection.addEventListener('hello', ({detail}) => greet(detail));
connection.addEventListener('link', ({detail}) => show_link(detail));
connection.addEventListener('state', ({detail}) => show_state(detail));
connection.addEventListener('note', ({detail}) => command_line.say(detail.text, 'note'));
addEventListener('pointerdown', () => { refusal = ''; }, {capture: true});
connection.open();
