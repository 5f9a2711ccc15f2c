// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
// The page as a panel of an editor, which is played here.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { armFile, open, skip } from './fixture.mjs';
import { armPage } from './arm.mjs';

const PATH = 'arm/model.sdf';

/** Lines of their own, as in a file; the source text has eight. */
const spread = (data) => {
  data.links.forEach((link, i) => Object.assign(link, { line: 4 + i }));
  data.joints.forEach((joint) => Object.assign(joint, { line: 2 }));
};

/** A page that finds itself in an editor. `told` are the messages that it sent. */
async function openInEditor(file, { theme = 'vscode-dark', ...options } = {}) {
  const editor = (name) => {
    window.told = [];
    window.acquireVsCodeApi = () => ({ postMessage: (message) => window.told.push(message) });
    addEventListener('DOMContentLoaded', () => document.body.classList.add(name));
  };
  const page = await open(file, { before: [editor, theme], ...options });
  page.say = (message) => page.evaluate((each) => window.postMessage(each, '*'), message);
  page.told = () => page.evaluate(() => window.told.splice(0));
  page.selects = (name) =>
    page.waitForFunction((wanted) => window.rigor.selection?.name === wanted, name);
  return page;
}

test('the page in an editor follows the cursor and tells nothing of that', { skip }, async () => {
  const page = await openInEditor(armFile({ change: spread }));
  assert.deepEqual(await page.told(), [{ type: 'ready' }]);
  await page.say({ type: 'reveal', kind: 'link', name: 'upper', path: PATH, line: 5 });
  await page.selects('arm::upper');
  // Its text is newer than the model: the name is known.
  await page.say({ type: 'reveal', kind: 'link', name: 'fore', path: PATH, line: 40 });
  await page.selects('arm::fore');
  // A template composes names: the line is known.
  await page.say({ type: 'reveal', kind: 'link', name: '${prefix}tip', path: PATH, line: 4 });
  await page.selects('arm::base');
  // Of four joints in a line.
  await page.say({ type: 'reveal', kind: 'joint', name: 'elbow', path: PATH, line: 2 });
  await page.selects('arm::elbow');
  await page.say({ type: 'reveal', kind: 'link', name: 'no', path: PATH, line: 40 });
  await page.say({ type: 'reveal', kind: 'link', name: 'base', path: 'other.sdf', line: 4 });
  await page.say({ type: 'reveal', kind: 'robot', name: 'arm', path: PATH, line: 3 });
  await page.selects('arm');
  assert.deepEqual(await page.told(), []);
});

test('what is selected in the page is told with its place', { skip }, async () => {
  const page = await openInEditor(armFile({ change: spread }));
  await page.told();
  await page.locator('#tree button', { hasText: 'fore' }).click();
  const [told, ...more] = await page.told();
  assert.deepEqual([told.type, told.path, told.line], ['selected', PATH, 6]);
  assert.deepEqual(more, []);
  // A finding is told alone, not with the link that it is about.
  await page.locator('#findings button').first().click();
  const findings = await page.told();
  assert.deepEqual(
    findings.map(({ line, column }) => [line, column]),
    [[6, 23]],
  );
});

test('the page in an editor takes a changed model and keeps the selection', { skip }, async () => {
  const page = await openInEditor(armFile({ change: spread, live: true }));
  await page.say({ type: 'reveal', kind: 'link', name: 'fore', path: PATH, line: 6 });
  await page.selects('arm::fore');
  const changed = armPage({
    live: true,
    change: (data) => {
      spread(data);
      data.name = 'longer arm';
    },
  });
  await page.say({
    type: 'changed',
    page: JSON.stringify(changed),
    changes: JSON.stringify({ changes: ['the arm is longer'], nothing: false }),
  });
  await page.waitForFunction(() => document.title.startsWith('longer arm'));
  assert.equal(await page.evaluate(() => rigor.selection.name), 'arm::fore');
  assert.match(await page.locator('#toast').textContent(), /the arm is longer/);
  await page.say({ type: 'changed', page: '{', changes: '{}' });
  await page.waitForFunction(() =>
    document.getElementById('toast').textContent.includes('could not be shown'),
  );
  // No server was asked, and the address was left alone.
  assert.deepEqual(page.requests.filter((url) => /events|\/data$/.test(url)), []);
  assert.equal(new URL(page.url()).hash, '');
  assert.deepEqual(page.errors, []);
});

test('the page has the theme of its editor', { skip }, async () => {
  const theme = (page) => page.evaluate(() => document.documentElement.dataset.theme);
  assert.equal(await theme(await openInEditor(armFile(), { webgl: false })), 'dark');
  const page = await openInEditor(armFile(), { webgl: false, theme: 'vscode-light' });
  assert.equal(await theme(page), 'light');
  await page.evaluate(() => document.body.classList.replace('vscode-light', 'vscode-high-contrast'));
  await page.waitForFunction(() => document.documentElement.dataset.theme === 'dark');
});
