// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A browser, the page's templates, and pages filled by hand, for the tests of the page.
//
//   const page = await open(await armFile());
//   await page.evaluate(() => rigor.setJoint('arm::elbow', 0.4));

import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { after } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';

import { chromium } from 'playwright-core';

import { armPage } from './arm.mjs';
import { fillTemplate } from './format.mjs';

const here = dirname(fileURLToPath(import.meta.url));
const source = resolve(here, '../../lib/rigor/view/page');

const browserPath = process.env.RIGOR_CHROMIUM ?? '/usr/bin/chromium';
/** Why the tests are skipped, as an option of `test`; false when they run. */
export const skip = existsSync(browserPath) ? false : `no browser at ${browserPath}`;

const folder = mkdtempSync(join(tmpdir(), 'rigor-page-'));
const browsers = new Map();
const closing = [];

after(async () => {
  for (const close of closing.reverse()) await close();
  for (const browser of browsers.values()) await (await browser).close();
  rmSync(folder, { recursive: true, force: true });
});

/** `close` runs when the file's tests have ended. */
export function atEnd(close) {
  closing.push(close);
}

export function temporaryFile(name) {
  return join(folder, name);
}

let templates = null;

/** 'page.html' or 'page_live.html', built once for each file of tests. RIGOR_PAGE: a folder that holds them. */
export function template(name) {
  templates ??= process.env.RIGOR_PAGE ?? join(folder, 'templates');
  if (!existsSync(join(templates, name))) {
    execFileSync(process.execPath, [join(source, 'build.mjs'), templates], {
      stdio: ['ignore', 'ignore', 'inherit'],
    });
  }
  return readFileSync(join(templates, name), 'utf8');
}

let written = 0;

/** The address of a page with this model in it. */
export function fileOf({ data, bytes }) {
  const path = temporaryFile(`${++written}.html`);
  writeFileSync(path, fillTemplate(template('page.html'), data, bytes));
  return pathToFileURL(path).href;
}

export function armFile(options) {
  return fileOf(armPage(options));
}

const SOFTWARE = ['--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'];
const NO_WEBGL = ['--disable-gpu', '--disable-3d-apis'];

export function browserOf(webgl) {
  if (!browsers.has(webgl)) {
    browsers.set(
      webgl,
      chromium.launch({
        executablePath: browserPath,
        args: ['--no-sandbox', ...(webgl ? SOFTWARE : NO_WEBGL)],
      }),
    );
  }
  return browsers.get(webgl);
}

/**
 * A page that is ready. `page.requests`: the addresses it asked for; `page.errors`: what went wrong. `before` is
 * `[script, argument]`: what runs before the page's own scripts.
 */
export async function open(address, { webgl = true, before = null, ...context } = {}) {
  const made = await (
    await browserOf(webgl)
  ).newContext({ viewport: { width: 1280, height: 800 }, ...context });
  const page = await made.newPage();
  page.requests = [];
  page.errors = [];
  page.on('request', (request) => page.requests.push(request.url()));
  page.on('pageerror', (error) => page.errors.push(error.message));
  page.on('console', (message) => message.type() === 'error' && page.errors.push(message.text()));
  if (before) await page.addInitScript(...before);
  await page.goto(address);
  await page.evaluate(() => window.rigor.ready);
  return page;
}

/** A picture of the scene's middle, where no button is. */
export async function sceneShot(page) {
  await page.evaluate(
    () =>
      new Promise((done) => {
        rigor.render();
        requestAnimationFrame(() => requestAnimationFrame(done));
      }),
  );
  const { x, y, width, height } = await page.locator('#scene').boundingBox();
  return page.screenshot({
    clip: { x: x + 5, y: y + 100, width: width - 10, height: height - 150 },
  });
}

/** Where the window shows a point of the file's frame, by the pinhole formula; z is up. */
export async function onScreen(page, point, degrees = 32) {
  const [ex, ey, ez, tx, ty, tz] = await page.evaluate(() => rigor.camera);
  const { x, y, width, height } = await page.locator('#scene').boundingBox();
  const minus = (a, b) => a.map((v, i) => v - b[i]);
  const dot = (a, b) => a.reduce((sum, v, i) => sum + v * b[i], 0);
  const cross = ([a, b, c], [d, e, f]) => [b * f - c * e, c * d - a * f, a * e - b * d];
  const unit = (a) => a.map((v) => v / Math.hypot(...a));
  const ahead = unit(minus([tx, ty, tz], [ex, ey, ez]));
  const right = unit(cross(ahead, [0, 0, 1]));
  const ray = minus(point, [ex, ey, ez]);
  const scale = height / 2 / Math.tan((degrees * Math.PI) / 360) / dot(ray, ahead);
  return [
    x + width / 2 + scale * dot(ray, right),
    y + height / 2 - scale * dot(ray, cross(right, ahead)),
  ];
}
