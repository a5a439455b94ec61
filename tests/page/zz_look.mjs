import {launch_browser, open_page, state_of, type_line} from './browser.mjs';
import {DriveServer} from './drive_server.mjs';
import path from 'node:path';
const browser = await launch_browser();
for (const spec of process.argv.slice(2)) {
  const [files, name, ...lines] = spec.split(';');
  const server = new DriveServer();
  try {
    const t0 = performance.now();
    await server.start(files.split(' ').map((f) => path.relative('/work/wt-d14', f)), ['--warnings', 'none']);
    console.log(name, 'ready', ((performance.now() - t0) / 1000).toFixed(1));
    const page = await open_page(browser, server.address);
    await page.waitForTimeout(2500);
    await page.screenshot({path: `/tmp/d14/shots/${name}_0.png`});
    for (const line of lines) { console.log('  ', line, '->', await type_line(page, line)); await page.waitForTimeout(1800); }
    await page.screenshot({path: `/tmp/d14/shots/${name}_1.png`});
    const s = await state_of(page);
    console.log('  mode', s.mode, s.control, 'fault', s.fault, 'page faults', JSON.stringify(page.faults));
    await page.close();
  } catch (e) { console.log(name, 'FAILED', e.message.slice(0, 600)); }
  console.log('  said:', server.said.split('\n').filter((l) => l && !l.includes('compiled') && !l.includes('generating')).slice(0, 6).join('\n        ').slice(0, 900));
  await server.close();
}
await browser.close();
