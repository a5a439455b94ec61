// Panels behind tabs, as the ARIA practices have them: arrow keys choose, Tab enters the panel.
import {element} from '../element.js';

/** Fills `root` with a tab for each of `names`. Returns the panels' elements by name. */
export function make_tabs(root, names) {
  const tabs = names.map((name) => element('button', {type: 'button', role: 'tab',
    id: `tab-${name}`, 'aria-controls': `panel-${name}`}, name));
  const panels = names.map((name) => element('div', {role: 'tabpanel', id: `panel-${name}`,
    className: 'panel', tabIndex: -1, 'aria-labelledby': `tab-${name}`}));
  const choose = (index) => {
    tabs.forEach((tab, i) => {
      tab.setAttribute('aria-selected', String(i === index));
      tab.tabIndex = i === index ? 0 : -1;
      panels[i].hidden = i !== index;
    });
  };
  tabs.forEach((tab, i) => {
    tab.addEventListener('click', () => choose(i));
    tab.addEventListener('keydown', (event) => {
      const by = {ArrowRight: 1, ArrowLeft: -1}[event.key];
      if (!by) return;
      event.preventDefault();
      const next = (i + by + tabs.length) % tabs.length;
      choose(next);
      tabs[next].focus();
    });
  });
  root.append(element('div', {role: 'tablist', className: 'tabs', 'aria-label': 'panels'}, ...tabs),
    ...panels);
  choose(0);
  return Object.fromEntries(names.map((name, i) => [name, panels[i]]));
}
