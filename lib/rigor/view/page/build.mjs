// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// node build.mjs FOLDER: writes page.html and page_live.html, into which `rigor view` puts a model.

import { createHash } from 'node:crypto';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';

import { build } from 'esbuild';

const here = dirname(fileURLToPath(import.meta.url));
const read = (...path) => readFileSync(join(here, ...path), 'utf8');

// three's own notice names its licence; the licence wants its text to go along.
const notice = `/*! three.js\n${read('node_modules', 'three', 'LICENSE').trim()}\n*/`;

async function bundle(entry, options) {
  const result = await build({
    entryPoints: [join(here, entry)],
    bundle: true,
    minify: true,
    write: false,
    charset: 'utf8',
    legalComments: 'inline',
    logLevel: 'warning',
    ...options,
  });
  return result.outputFiles[0].text.trim();
}

function hash(text) {
  return `'sha256-${createHash('sha256').update(text, 'utf8').digest('base64')}'`;
}

function policy(script, style, isLive) {
  return [
    "default-src 'none'",
    `script-src ${hash(script)}`,
    `style-src ${hash(style)}`,
    'img-src data: blob:',
    ...(isLive ? ["connect-src 'self'"] : []),
    "base-uri 'none'",
    "form-action 'none'",
  ].join('; ');
}

const folder = process.argv[2];
if (!folder) {
  console.error('usage: node build.mjs FOLDER');
  process.exit(2);
}
const script = await bundle('src/main.js', {
  format: 'iife',
  target: 'es2022',
  banner: { js: notice },
});
const style = await bundle('page.css', {});
const template = read('page.html');

mkdirSync(folder, { recursive: true });
for (const [name, isLive] of [
  ['page.html', false],
  ['page_live.html', true],
]) {
  // Replacements are functions, since `$&` in a bundle would mean something in a text.
  const page = template
    .replace('@POLICY@', () => policy(script, style, isLive))
    .replace('@STYLE@', () => style)
    .replace('@SCRIPT@', () => script);
  const ends = (tag) => page.split(`</${tag}>`).length - 1;
  if (page.split('<!--DATA-->').length !== 2 || ends('script') !== 1 || ends('style') !== 1) {
    throw new Error('the bundle holds text that would end its own block');
  }
  writeFileSync(join(folder, name), page);
}
const kilobytes = (bytes) => `${(bytes / 1000).toFixed(1)} kB`;
console.log(
  `script ${kilobytes(script.length)}, style ${kilobytes(style.length)}, both ${kilobytes(
    gzipSync(script + style, { level: 9 }).length,
  )} with gzip`,
);
