/**
 * Makes a DOM element. `properties` are set as properties, those with a dash or named `role`,
 * `for` as attributes, those that begin with `on` as listeners. Children are elements or text.
 */
export function element(tag, properties = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (name.startsWith('on')) {
      made.addEventListener(name.slice(2), value);
    } else if (name.includes('-') || name === 'role' || name === 'for' || name === 'list') {
      made.setAttribute(name, value);
    } else {
      made[name] = value;
    }
  }
  made.append(...children);
  return made;
}

/** A button that can be reached by keyboard. `label` is what it says, `hint` what it does. */
export function button(label, hint, on_click, className = '') {
  return element('button', {type: 'button', title: hint, className, onclick: on_click}, label);
}

/** A button that stays pressed: `on_change(pressed)`. */
export function toggle(label, hint, pressed, on_change) {
  const made = button(label, hint, () => {
    const now = made.getAttribute('aria-pressed') !== 'true';
    made.setAttribute('aria-pressed', String(now));
    on_change(now);
  }, 'toggle');
  made.setAttribute('aria-pressed', String(pressed));
  return made;
}

/** Sets text only where it differs: screen readers and layout are left alone otherwise. */
export function set_text(target, text) {
  if (target.textContent !== text) target.textContent = text;
}
