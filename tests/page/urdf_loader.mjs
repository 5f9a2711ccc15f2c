// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
// Where npm's urdf-loader puts the links of a URDF. It needs a browser, and runs in one; its files come
// from node_modules by interception, not from a network.

import { existsSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const modules = join(dirname(fileURLToPath(import.meta.url)), 'node_modules');
const origin = 'http://urdf.invalid/';

const html = `<script type="importmap">{"imports": {
  "three": "/three/build/three.module.js", "three/examples/": "/three/examples/"}}</script>
<script type="module">
  import URDFLoader from '/urdf-loader/src/URDFLoader.js';
  window.poses = (text, positions) => {
    const loader = new URDFLoader();
    loader.parseVisual = false;
    loader.parseCollision = false;
    const robot = loader.parse(text);
    for (const [joint, q] of Object.entries(positions)) robot.setJointValue(joint, q);
    robot.updateMatrixWorld(true);
    const links = Object.entries(robot.links);
    return {
      root: links.find(([, link]) => link === robot)[0],
      links: Object.fromEntries(links.map(([name, { matrixWorld }]) => [name, matrixWorld.elements.slice(12, 15)])),
    };
  };
  window.loaded = true;
</script>`;

/** A function (text of a URDF, {joint: position}) → {root, links: {name: [x, y, z] in the root's frame}}. */
export async function urdfLoader(browser) {
  const page = await browser.newPage();
  await page.route('**/*', (route) => {
    const { pathname } = new URL(route.request().url());
    if (pathname === '/') return route.fulfill({ contentType: 'text/html', body: html });
    const path = join(modules, decodeURIComponent(pathname));
    if (!existsSync(path)) return route.fulfill({ status: 404 });
    return route.fulfill({ contentType: 'text/javascript', body: readFileSync(path) });
  });
  await page.goto(origin);
  await page.waitForFunction(() => window.loaded);
  return (text, positions) =>
    page.evaluate(([urdf, q]) => window.poses(urdf, q), [text, positions]);
}
