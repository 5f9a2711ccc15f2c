// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
// A page that is served takes the changed model and keeps what one looks at.

import assert from 'node:assert/strict';
import { createServer } from 'node:http';
import { test } from 'node:test';

import { armPage } from './arm.mjs';
import { atEnd, open, skip, template } from './fixture.mjs';
import { fillTemplate } from './format.mjs';

/** Serves `served.page`; `served.say(event)` tells all pages. */
async function serve(served) {
  const listeners = new Set();
  const server = createServer((request, response) => {
    if (request.url === '/events') {
      response.writeHead(200, { 'content-type': 'text/event-stream' });
      response.write(': here\n\n');
      listeners.add(response);
      request.on('close', () => listeners.delete(response));
      served.onListener?.();
    } else if (request.url === '/data') {
      response.writeHead(200, { 'content-type': 'application/json' });
      response.end(JSON.stringify(served.page));
    } else {
      response.writeHead(200, { 'content-type': 'text/html; charset=utf-8' });
      response.end(fillTemplate(template('page_live.html'), served.page.data, served.page.bytes));
    }
  });
  await new Promise((done) => server.listen(0, '127.0.0.1', done));
  atEnd(() => {
    server.closeAllConnections();
    server.close();
  });
  served.say = (event) => {
    for (const listener of listeners)
      listener.write(`event: changed\ndata: ${JSON.stringify(event)}\n\n`);
  };
  /** As a server that ends: whoever listens is told so by the end of the answer. */
  served.hangUp = () => {
    for (const listener of listeners) listener.end();
  };
  return `http://127.0.0.1:${server.address().port}/`;
}

const toastSays = (page, text) =>
  page.waitForFunction((said) => document.getElementById('toast').textContent.includes(said), text);

test('a changed model is swapped in place', { skip }, async () => {
  const served = { page: armPage({ live: true }) };
  const listening = new Promise((done) => {
    served.onListener = done;
  });
  const page = await open(await serve(served));
  await listening;
  await page.evaluate(() => {
    rigor.setJoint('arm::elbow', 0.4);
    rigor.show(['visual', 'com']);
    rigor.select('arm::fore');
  });
  await page.locator('#views button', { hasText: 'Side' }).click();
  const camera = await page.evaluate(() => rigor.camera);

  // A link and a joint more, before the others: all indices are others now.
  served.page = armPage({
    live: true,
    change: (data) => {
      data.links.unshift({ ...data.links[0], name: 'mast', scoped: 'arm::mast', movedBy: -1 });
      for (const link of data.links.slice(1)) link.movedBy += link.movedBy >= 0 ? 1 : 0;
      data.joints.unshift({
        ...data.joints[0],
        name: 'pan',
        scoped: 'arm::pan',
        parent: -1,
        child: -1,
        axes: [],
      });
      for (const joint of data.joints.slice(1)) {
        joint.parent += 1;
        joint.child += 1;
        for (const axis of joint.axes) if (axis.mimic) axis.mimic.joint += 1;
      }
      for (const body of data.bodies) body.link += body.link >= 0 ? 1 : 0;
      data.joints[2].pose[0] = 1.5; // the elbow is farther out
      data.links[3].pose[0] = 1.5;
      data.findings = [];
    },
  });
  served.say({ changes: ['link mast is new', 'joint elbow moved by 0.5 m'], nothing: false });
  await toastSays(page, 'link mast is new; joint elbow moved by 0.5 m');
  assert.deepEqual(await page.evaluate(() => rigor.camera), camera);
  assert.deepEqual(await page.evaluate(() => rigor.layers), ['visual', 'com']);
  assert.deepEqual(await page.evaluate(() => rigor.selection), { kind: 'link', name: 'arm::fore' });
  assert.equal(await page.evaluate(() => rigor.jointPosition('arm::elbow')), 0.4);
  const fore = await page.evaluate(() => rigor.linkPose('arm::fore'));
  [1.5, 0, 0, Math.cos(0.2), 0, 0, Math.sin(0.2)].forEach((v, i) =>
    assert.ok(Math.abs(fore[i] - v) < 1e-9, String(fore)),
  );
  assert.match(await page.locator('#findings').textContent(), /Nothing was found/);

  served.say({ changes: [], nothing: true });
  await toastSays(page, 'nothing about the model changed');
  assert.deepEqual(page.errors, []);
  assert.ok(
    page.requests.every((url) => url.startsWith('http://127.0.0.1:') || /^(data|blob):/.test(url)),
  );
});

test(
  'a server that goes away is spoken of, and its return brings the model',
  { skip },
  async () => {
    const served = { page: armPage({ live: true }) };
    const listening = new Promise((done) => {
      served.onListener = done;
    });
    const page = await open(await serve(served));
    await listening;
    served.page = armPage({
      live: true,
      change: (data) => {
        data.name = 'arm 2';
      },
    });
    served.hangUp();
    await page.waitForFunction(
      () => document.getElementById('model-name').textContent === 'arm 2',
    );
  },
);
