// Where the page and its packages are: the folder that `build.mjs` wrote.
import fs from 'node:fs';
import {createRequire} from 'node:module';
import path from 'node:path';

/** Folder with index.html, page.js and page.css. */
export const kPage = process.env.TREELINE_PAGE ?? '';

/** The root of the source tree. */
export const kSource = path.resolve(import.meta.dirname, '../..');

/** True if the page and its packages are there. */
export function page_is_built() {
  return kPage !== '' && fs.existsSync(path.join(kPage, 'page.js')) &&
    fs.existsSync(path.join(kPage, 'packages/node_modules/playwright-core'));
}

/** One of the page's packages. */
export function load_package(name) {
  return createRequire(path.join(kPage, 'packages/package.json'))(name);
}
