// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
// Tree, selection, findings, source, links into the page, and the page without WebGL.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { armFile, open, sceneShot, skip } from './fixture.mjs';

const rows = (page) => page.locator('#tree li:visible .name').allTextContents();
const marked = (page) => page.locator('#source-text mark').textContent();

test('the tree is that of the joints, and the search narrows it', { skip }, async () => {
  const page = await open(armFile());
  assert.deepEqual(await rows(page), [
    'arm',
    'base',
    'shoulder',
    'upper',
    'elbow',
    'fore',
    'slider',
    'tip',
    'lift',
    'tray',
  ]);
  await page.locator('#search').fill('L');
  assert.deepEqual(await rows(page), ['shoulder', 'elbow', 'slider', 'lift']);
  await page.locator('#search').press('Enter');
  assert.deepEqual(await page.evaluate(() => rigor.selection), {
    kind: 'joint',
    name: 'arm::shoulder',
  });
  await page.locator('#search').fill('no such');
  assert.equal(await page.locator('#search-none').isVisible(), true);
});

test('a selected link can be copied as numbers', { skip }, async () => {
  const page = await open(armFile());
  const before = await sceneShot(page);
  await page.evaluate(() => rigor.setJoint('arm::shoulder', Math.PI / 2));
  await page.evaluate(() => rigor.setJoint('arm::elbow', -0.25));
  await page.locator('#tree button', { hasText: 'fore' }).click();
  assert.ok(!(await sceneShot(page)).equals(before));
  const copied = async (name, nth) => {
    await page.getByRole('button', { name }).nth(nth).click();
    return page.evaluate(() => rigor.copied);
  };
  const numbers = (text) =>
    text
      .match(/^<pose>(.*)<\/pose>$/)[1]
      .split(' ')
      .map(Number);
  const world = numbers(await copied('Copy <pose>', 0));
  [0, 1, 0, 0, 0, Math.PI / 2 - 0.25].forEach((v, i) =>
    assert.ok(Math.abs(world[i] - v) < 1e-8, String(world)),
  );
  const relative = numbers(await copied('Copy <pose>', 1));
  [1, 0, 0, 0, 0, -0.25].forEach((v, i) =>
    assert.ok(Math.abs(relative[i] - v) < 1e-8, String(relative)),
  );
  assert.equal(await copied('Copy <inertial>', 0), '<inertial><mass>1</mass></inertial>');
  assert.match(await page.locator('#toast').textContent(), /^Copied/);
});

test('a finding marks its link, its lines and its span', { skip }, async () => {
  const page = await open(armFile());
  assert.deepEqual(await page.locator('#findings summary').allTextContents(), [
    '1 error',
    '2 warnings',
    '1 note',
  ]);
  const before = await sceneShot(page);
  await page.locator('.finding', { hasText: 'mass-negative' }).click();
  assert.deepEqual(await page.evaluate(() => rigor.selection), {
    kind: 'link',
    name: 'arm::upper',
  });
  assert.equal(await marked(page), '-2');
  assert.ok(!(await sceneShot(page)).equals(before));
  await page.locator('.finding', { hasText: 'limit-wide' }).click();
  assert.deepEqual(await page.evaluate(() => rigor.selection), {
    kind: 'joint',
    name: 'arm::elbow',
  });
  assert.equal(await marked(page), '<link name="base"/>\n    <link name="upper">');
  await page.keyboard.press('Escape');
  assert.equal(await page.evaluate(() => rigor.finding), -1);
});

test('a finding shows where its part would be', { skip }, async () => {
  const ghosts = [
    { finding: 1, body: 0, pose: [0.25, 0, 0.5, 1, 0, 0, 0], scale: [1, 1, 1] },
    { finding: 2, body: 1, pose: [2, 0, 0, 1, 0, 0, 0], scale: [1, 1, 1] },
  ];
  const page = await open(armFile({ change: (data) => Object.assign(data, { ghosts }) }));
  const shown = () => page.evaluate(() => rigor.ghosts);
  await page.locator('.finding', { hasText: 'mass-negative' }).click();
  assert.deepEqual(await shown(), []);
  const before = await sceneShot(page);
  await page.locator('.finding', { hasText: 'limit-wide' }).click();
  assert.deepEqual(await shown(), [[0.25, 0, 0.5]]);
  assert.ok(!(await sceneShot(page)).equals(before));
  await page.keyboard.press('Escape');
  assert.deepEqual(await shown(), []);
});

test('columns of the source count code points', { skip }, async () => {
  const page = await open(
    armFile({
      change: ({ findings, files }) => {
        files[0].text = '<a>\r\n  <b name="🤖é">x</b>\r\n</a>';
        Object.assign(findings[0], { line: 2, column: 15, endLine: 2, endColumn: 16 });
        Object.assign(findings[1], { line: 3, column: 1, endLine: 3, endColumn: 1 });
        Object.assign(findings[2], { line: 99, column: 7, endLine: 99, endColumn: 9 });
      },
    }),
  );
  // 1 < 4 b, 3 spaces in all, name=" at 6, the robot at 12, é at 13, quote, >
  for (const [index, text] of [
    [0, '>'],
    [1, '</a>'],
  ]) {
    await page.locator('.finding').nth(index).click();
    assert.equal(await marked(page), text);
  }
  await page.locator('.finding').nth(2).click(); // past the end: shown, not broken
  assert.deepEqual(page.errors, []);
});

test('a link leads to what it names', { skip }, async () => {
  const base = armFile();
  const joint = await open(`${base}#joint=elbow&q.elbow=0.4&q.arm::slider=9&show=visual,com`);
  assert.deepEqual(await joint.evaluate(() => rigor.selection), {
    kind: 'joint',
    name: 'arm::elbow',
  });
  assert.equal(await joint.evaluate(() => rigor.jointPosition('arm::elbow')), 0.4);
  assert.equal(await joint.evaluate(() => rigor.jointPosition('arm::slider')), 0.5);
  assert.deepEqual(await joint.evaluate(() => rigor.layers), ['visual', 'com']);
  const finding = await open(`${base}#finding=1`);
  assert.equal(await finding.evaluate(() => rigor.finding), 1);
  await open(`${base}#link=${encodeURIComponent('no such')}&finding=x&q.=1&show=,,nothing`);

  const page = await open(base);
  await page.evaluate(() => rigor.setJoint('arm::elbow', 0.25));
  await page.locator('#tree button', { hasText: 'fore' }).click();
  await page.waitForFunction(() => location.hash.includes('link'));
  const address = await page.evaluate(() => location.href);
  assert.equal(address.split('#')[1], 'link=arm::fore&q.arm::elbow=0.25');
  const again = await open(address);
  assert.deepEqual(await again.evaluate(() => rigor.selection), {
    kind: 'link',
    name: 'arm::fore',
  });
  assert.equal(await again.evaluate(() => rigor.jointPosition('arm::elbow')), 0.25);
});

test('without WebGL there are pictures, and the rest works', { skip }, async () => {
  const page = await open(armFile(), { webgl: false });
  assert.equal(await page.evaluate(() => rigor.webgl), false);
  assert.match(await page.locator('#fallback').textContent(), /no WebGL/);
  assert.ok(
    await page
      .locator('#fallback img')
      .evaluate((image) => image.decode().then(() => image.naturalWidth > 0)),
  );
  await page.locator('.finding', { hasText: 'mass-negative' }).click();
  assert.equal(await marked(page), '-2');
  await page.keyboard.press('f');
  await page.keyboard.press('1');
  await page.keyboard.press('c');
  assert.equal((await rows(page)).length, 10);
  assert.match(await page.locator('#selection').textContent(), /Pose in the world/);
});

test('on a phone every panel is reached by its tab', { skip }, async () => {
  const page = await open(armFile(), {
    viewport: { width: 390, height: 780 },
    hasTouch: true,
    isMobile: true,
  });
  for (const [tab, panel] of [
    ['Joints', '#sliders'],
    ['Selection', '#selection'],
    ['Findings', '#findings'],
    ['Source', '#source-text'],
    ['Model', '#tree'],
  ]) {
    await page.locator('#tabs button', { hasText: tab }).tap();
    assert.equal(await page.locator(panel).isVisible(), true, tab);
    assert.equal(await page.locator('#scene canvas').isVisible(), true, tab);
  }
  assert.ok(
    await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth),
    'nothing is wider than the window',
  );
});

test('buttons and fields have names, and texts have contrast', { skip }, async () => {
  for (const colorScheme of ['light', 'dark']) {
    const page = await open(armFile(), { colorScheme });
    await page.locator('.finding').first().click();
    const faults = await page.evaluate(() => {
      const brush = document.createElement('canvas').getContext('2d');
      const rgb = (color) => {
        brush.clearRect(0, 0, 1, 1);
        brush.fillStyle = color;
        brush.fillRect(0, 0, 1, 1);
        return [...brush.getImageData(0, 0, 1, 1).data];
      };
      const light = ([r, g, b]) =>
        [r, g, b]
          .map((v) => (v / 255 <= 0.04045 ? v / 255 / 12.92 : ((v / 255 + 0.055) / 1.055) ** 2.4))
          .reduce((sum, v, i) => sum + v * [0.2126, 0.7152, 0.0722][i], 0);
      const found = [];
      for (const element of document.querySelectorAll('body *')) {
        if (
          element.matches('script, option') ||
          !element.checkVisibility({ opacityProperty: true, visibilityProperty: true })
        )
          continue;
        if (element.matches('button, input, select') && !element.matches(':disabled')) {
          const name = element.textContent || element.ariaLabel || element.labels?.[0]?.textContent;
          if (!name) found.push(`no name: ${element.outerHTML.slice(0, 80)}`);
        }
        const said = [...element.childNodes].some(
          (node) => node.nodeType === 3 && node.data.trim(),
        );
        if (!said || element.closest('.sr, :disabled')) continue;
        let behind = element;
        while (rgb(getComputedStyle(behind).backgroundColor)[3] < 255 && behind.parentElement)
          behind = behind.parentElement;
        const [a, b] = [
          getComputedStyle(element).color,
          getComputedStyle(behind).backgroundColor,
        ].map((c) => light(rgb(c)));
        const contrast = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
        if (contrast < 4.5)
          found.push(
            `${contrast.toFixed(2)}: ${element.className} ${element.textContent.slice(0, 40)}`,
          );
      }
      return found;
    });
    assert.deepEqual(faults, [], colorScheme);
  }
});
