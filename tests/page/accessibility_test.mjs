// Would catch: what axe finds: roles, names, contrasts and structure that assistive technology needs,
// in every tab, now and in the past, wide and narrow, light and dark.
import assert from 'node:assert/strict';
import {after, before, test} from 'node:test';

import {kSharp, launch_browser, open_page, type_line} from './browser.mjs';
import {MockServer} from './mock_server.mjs';
import {load_package} from './packages.mjs';

const kTabs = ['Joints', 'Points', 'Control', 'Plots', 'View'];
const kLooks = [{viewport: {width: 1366, height: 768}, colorScheme: 'light'},
  {viewport: {width: 420, height: 860}, colorScheme: 'dark'}];
const {source} = load_package('axe-core');

const server = new MockServer();
let browser;
before(async () => {
  await server.listen();
  browser = await launch_browser();
});
after(async () => {
  await browser.close();
  await server.close();
});

/** Faults that axe finds, each with the elements that have it. */
async function find_faults(page) {
  const {violations, passes} = await page.evaluate(() => window.axe.run());
  assert.ok(passes.length > 20, 'axe has looked');
  return violations.map(({id, nodes}) => [id, nodes.map(({html}) => html.slice(0, 120))]);
}

for (const look of kLooks) {
  test(`axe finds no fault: ${look.viewport.width} pixels, ${look.colorScheme}`, async () => {
    const page = await open_page(browser, server.address, {...kSharp, ...look});
    await page.evaluate(source);
    await type_line(page, 'start');
    for (const tab of kTabs) {
      await page.click(`#tab-${tab}`);
      assert.deepEqual(await find_faults(page), [], tab);
    }
    await page.click('button:text-is("Replay")');
    await page.click('#tab-Plots');
    await page.click('summary');
    assert.deepEqual(await find_faults(page), [], 'the past');
    await page.close();
  });
}
