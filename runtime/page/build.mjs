// Writes the page of `treeline drive`: index.html, page.js and page.css.
//   node runtime/page/build.mjs OUTDIR
// Packages go to OUTDIR/packages, as package-lock.json names them (npm ci; nothing happens if they
// are there). Exit status 1: npm or the bundler fails; what it said goes to stderr.
import {spawnSync} from 'node:child_process';
import fs from 'node:fs';
import {createRequire} from 'node:module';
import path from 'node:path';
import {fileURLToPath} from 'node:url';

const kHere = path.dirname(fileURLToPath(import.meta.url));
const kManifests = ['package.json', 'package-lock.json', '.npmrc'];

/** True if `folder` holds the packages of this very lock file. */
function packages_are_current(folder) {
  const installed = path.join(folder, 'installed-lock.json');
  return fs.existsSync(installed) &&
    fs.readFileSync(installed).equals(fs.readFileSync(path.join(kHere, 'package-lock.json')));
}

function install_packages(folder) {
  if (packages_are_current(folder)) return;
  fs.mkdirSync(folder, {recursive: true});
  for (const name of kManifests) fs.copyFileSync(path.join(kHere, name), path.join(folder, name));
  const npm = spawnSync('npm', ['ci', '--ignore-scripts'], {cwd: folder, encoding: 'utf8'});
  if (npm.status !== 0) {
    throw new Error(`npm ci failed in ${folder}: ${npm.error?.message ?? npm.stderr}`);
  }
  fs.copyFileSync(path.join(kHere, 'package-lock.json'), path.join(folder, 'installed-lock.json'));
}

async function bundle(out, packages) {
  const esbuild = createRequire(path.join(packages, 'package.json'))('esbuild');
  await esbuild.build({
    entryPoints: [path.join(kHere, 'source/page.js'), path.join(kHere, 'source/page.css')],
    outdir: out,
    bundle: true,
    minify: true,
    format: 'esm',
    target: 'es2022',
    legalComments: 'inline',
    nodePaths: [path.join(packages, 'node_modules')],
    logLevel: 'warning',
  });
  fs.copyFileSync(path.join(kHere, 'source/index.html'), path.join(out, 'index.html'));
}

async function build_page(out) {
  const packages = path.join(out, 'packages');
  fs.mkdirSync(out, {recursive: true});
  install_packages(packages);
  await bundle(out, packages);
}

if (process.argv.length !== 3) {
  console.error('usage: node build.mjs OUTDIR');
  process.exit(2);
}
try {
  await build_page(path.resolve(process.argv[2]));
} catch (error) {
  console.error(`build.mjs: ${error.message}`);
  process.exit(1);
}
