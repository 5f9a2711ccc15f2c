// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
// Nothing leaves the page, and nothing that a model's file says is run.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { gzipSync } from 'node:zlib';

import { armFile, onScreen, open, skip, template } from './fixture.mjs';

/** Touches all of the page that shows something of the model. */
async function useAll(page) {
  const click = async (selector) => {
    for (const button of await page.locator(selector).all()) {
      if ((await button.isVisible()) && (await button.isEnabled())) await button.click();
    }
  };
  await click('#tree button');
  await click('.joint-name');
  await click('.finding');
  await click('#not-drawn summary');
  await click('#layers button');
  await page.evaluate(() =>
    rigor.show(['visual', 'collision', 'inertia', 'com', 'frames', 'axes', 'contacts', 'ground']),
  );
  await page.locator('#tree button').nth(3).click();
  await click('#selection button');
  await page.mouse.move(...(await onScreen(page, [0.5, 0, 0])));
  await page.locator('#hover').waitFor({ state: 'visible' });
  await page.keyboard.press('l');
}

test('hostile names are text', { skip }, async () => {
  const others = [
    `"><svg onload=window.hit=1>`,
    "'-window.hit++-'",
    '<!--<script>window.hit=1</script>',
    '${window.hit=1}',
    '\u2028\u0000&lt;img src=x onerror=window.hit=1&gt;',
  ];
  for (const attack of [
    '</script><img src=x onerror=window.hit=1>',
    others.join(' '),
    'javascript:window.hit=1',
  ]) {
    const page = await open(armFile({ rename: (text) => `${attack}${text}` }));
    await useAll(page);
    assert.equal(await page.evaluate(() => window.hit), undefined, attack);
    assert.equal(await page.locator('img, svg, #scene script, main script').count(), 0, attack);
    assert.equal(await page.locator('#model-name').textContent(), `${attack}arm`);
    assert.deepEqual(page.errors, [], attack);
    await page.close();
  }
});

test('names of objects in JavaScript are names like others', { skip }, async () => {
  const page = await open(
    armFile({ rename: (text) => (text.includes('arm::') ? `${text}::__proto__` : 'constructor') }),
  );
  await useAll(page);
  assert.deepEqual(page.errors, []);
});

test('no request leaves, also without a network', { skip }, async () => {
  const page = await open(armFile(), { offline: true });
  await useAll(page);
  const elsewhere = page.requests.filter((url) => !/^(file|data|blob):/.test(url));
  assert.deepEqual(elsewhere, []);
  assert.deepEqual(page.errors, []);
});

test('the policy stops what would be a request or a script', { skip }, async () => {
  const page = await open(armFile());
  const refused = await page.evaluate(async () => {
    const violations = [];
    document.addEventListener('securitypolicyviolation', ({ effectiveDirective }) =>
      violations.push(effectiveDirective),
    );
    const settled = [
      fetch('http://127.0.0.1:9/').catch(() => {}),
      new Promise((done) => {
        const image = new Image();
        image.onerror = done;
        image.src = 'http://127.0.0.1:9/a.png';
      }),
    ];
    const script = document.createElement('script');
    script.textContent = 'window.hit = 1';
    document.body.append(script);
    document.body.setAttribute('style', 'color: red');
    await Promise.all(settled);
    await new Promise(requestAnimationFrame);
    return violations;
  });
  assert.deepEqual(refused.toSorted(), [
    'connect-src',
    'img-src',
    'script-src-elem',
    'style-src-attr',
  ]);
  assert.equal(await page.evaluate(() => window.hit), undefined);
});

test('the template holds what its users rely on', { skip }, () => {
  for (const [name, connects] of [
    ['page.html', false],
    ['page_live.html', true],
  ]) {
    const text = template(name);
    assert.equal(text.split('<!--DATA-->').length, 2);
    assert.equal(text.includes("connect-src 'self'"), connects);
    assert.ok(!text.includes('unsafe-'));
    assert.ok(text.includes('three.js authors'), 'the notice of three');
    assert.ok(text.includes('Permission is hereby granted'), 'its licence');
    const size = gzipSync(text, { level: 9 }).length;
    assert.ok(size < 250_000, `${name} has ${size} bytes with gzip`);
  }
});
