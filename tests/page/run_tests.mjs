// Runs one file of tests of the page: node run_tests.mjs FILE
// Exit status 77, with the reason on stdout, where the browser or the page is missing.
import {spawnSync} from 'node:child_process';
import fs from 'node:fs';

import {find_chromium} from './browser.mjs';
import {kPage, page_is_built} from './packages.mjs';

function reason_to_skip(file) {
  if (!page_is_built()) {
    return `there is no page in ${kPage}: node runtime/page/build.mjs ${kPage}`;
  }
  if (!/_math_test|complete_test|recorder_test|quantities_test/.test(file) && !find_chromium()) {
    return 'there is no Chromium: install the package chromium, or name it in TREELINE_CHROMIUM';
  }
  if (/drive_test|replay_test/.test(file) && !fs.existsSync(process.env.TREELINE_DRIVE ?? '')) {
    return 'TREELINE_DRIVE does not name the program treeline: build it first';
  }
  return '';
}

const file = process.argv[2] ?? '';
const reason = reason_to_skip(file);
if (reason) {
  console.log(`skipped: ${reason}`);
  process.exit(77);
}
const {status} = spawnSync(process.execPath, ['--test', '--test-reporter=spec', file],
  {stdio: 'inherit'});
process.exit(status ?? 1);
