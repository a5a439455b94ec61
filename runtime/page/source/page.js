// The page of `treeline drive`: connects the server's messages with the picture and the panels.
import {Connection, socket_address} from './connection.js';
import {element, set_text, toggle} from './element.js';
import {CommandLine} from './panel/command_line.js';
import {ControlPanel} from './panel/control_panel.js';
import {JointPanel} from './panel/joint_panel.js';
import {PlotPanel} from './panel/plot_panel.js';
import {PointPanel} from './panel/point_panel.js';
import {StatusBar} from './panel/status_bar.js';
import {make_tabs} from './panel/tabs.js';
import {ViewPanel} from './panel/view_panel.js';
import {Recorder, write_csv} from './recorder.js';
import {save_as, save_text} from './save.js';
import {say} from './units.js';
import {RobotView} from './view/robot_view.js';

const find = (selector) => document.querySelector(selector);

const connection = new Connection(socket_address(location));
const recorder = new Recorder();
const command_line = new CommandLine(find('#command-line'), run);
const status = new StatusBar(find('#status'), find('#fault'), run);
const view = new RobotView(find('#view canvas'), {send: send_drag, say,
  tell: (text) => set_text(find('#tip'), text), report: (text) => command_line.say(text, 'note')});

let hello = null;
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
const joint_panel = new JointPanel(tabs.Joints, senders);
const point_panel = new PointPanel(tabs.Points, senders);
const plot_panel = new PlotPanel(tabs.Plots, recorder, {
  save_csv: () => hello && save_text(file_name('csv'), 'text/csv',
    write_csv(hello, recorder.states)),
  save_png: () => save_as(file_name('plots.png'), plot_panel.draw_all().toDataURL('image/png')),
});
const panels = [status, joint_panel, point_panel, new ControlPanel(tabs.Control, run), plot_panel,
  command_line];

const pull = toggle('Pull links',
  'Dragging a link pulls it with a spring, instead of turning the picture', false,
  (yes) => { view.gestures.pulls_links = yes; });
find('#view-tools').append(pull);

/** Whoever only watches sees that nothing but the stop is for him. */
function enable_commands(may_command) {
  for (const part of [tabs.Joints, tabs.Points, tabs.Control]) {
    for (const control of part.querySelectorAll('button, input, select')) {
      control.disabled = !may_command && control !== joint_panel.units;
    }
  }
  find('#duration').disabled = !may_command;
}

async function greet(message) {
  const same = hello !== null && hello.robot === message.robot;
  hello = message;
  view.may_drag = message.may_command;
  pull.disabled = !message.may_command || message.links.length === 0;
  if (same) {
    status.greet(message);
    command_line.greet(message);
    enable_commands(message.may_command);
    return;
  }
  recorder.clear();
  const answer = await fetch('/robot.urdf');
  if (!answer.ok) {
    command_line.say(`the robot's URDF cannot be had: ${answer.status}`, 'bad');
    return;
  }
  view.load(await answer.text(), message);
  view_panel.apply(view);
  for (const panel of panels) panel.greet?.(message);
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
  const again = recorder.add(state);
  if (!view.model) return;
  if (again) view.clear_traces();
  view.show(state);
  for (const panel of panels) panel.update?.(state);
  window.treeline.state = state;
}

// For tests and for people at the console: the newest state, the picture as a PNG, and where
// handles are on the screen.
window.treeline = {state: null, where: (name) => view.where(name), picture: () => view.write_png(),
  handles: () => view.handles?.list.map((handle) => handle.name) ?? []};

connection.addEventListener('hello', ({detail}) => greet(detail));
connection.addEventListener('link', ({detail}) => show_link(detail));
connection.addEventListener('state', ({detail}) => show_state(detail));
connection.addEventListener('note', ({detail}) => command_line.say(detail.text, 'note'));
addEventListener('pointerdown', () => { refusal = ''; }, {capture: true});
connection.open();
