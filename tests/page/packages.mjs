// Where the page and its packages are: the folder that `build.mjs` wrote.
import fs from 'node:fs';
import {createRequire} from 'node:module';
import os from 'node:os';
import path from 'node:path';
import {pathToFileURL} from 'node:url';

/** The root of the source tree. */
export const kSource = path.resolve(import.meta.dirname, '../..');

/** Folder with index.html, page.js and page.css. */
export const kPage = path.resolve(process.env.TREELINE_PAGE ?? path.join(kSource, 'build/page'));

/** True if the page and its packages are there. */
export function page_is_built() {
  return fs.existsSync(path.join(kPage, 'page.js')) &&
    fs.existsSync(path.join(kPage, 'packages/node_modules/playwright-core'));
}

/** One of the page's packages. */
export function load_package(name) {
  return createRequire(path.join(kPage, 'packages/package.json'))(name);
}

/** One of the page's own modules, with the packages that it imports. */
export async function load_source(file) {
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'treeline-page-'));
  const out = path.join(folder, 'module.mjs');
  await load_package('esbuild').build({
    stdin: {resolveDir: path.join(kSource, 'runtime/page/source'),
      contents: `export * from './${file}'; export * as three from 'three';`},
    outfile: out, bundle: true, format: 'esm', platform: 'node',
    nodePaths: [path.join(kPage, 'packages/node_modules')],
  });
  const loaded = await import(pathToFileURL(out).href);
  fs.rmSync(folder, {recursive: true});
  return loaded;
}
