// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// drive.mjs WORK COMMAND...: a person with the extension: opens a broken robot, reads a finding, applies its fix, renames a
// link in two files, completes, formats, looks at the view and at a mesh, expands a template, simulates, and validates the
// workspace. What the editor saved is read from the disk. RIGOR_IMAGES is the folder for pictures of that. With
// RIGOR_TERMINALS the editor has terminals, in which tasks run.

import assert from 'node:assert/strict';
import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

import { until, Workbench } from './workbench.mjs';

const [work, ...command] = process.argv.slice(2);
const folder = join(work, 'my_robot');
const read = (name) => readFileSync(join(folder, name), 'utf8');

rmSync(folder, { recursive: true, force: true });
mkdirSync(folder);
writeFileSync(
  join(folder, 'robot.urdf'),
  `<robot name="my_robot">
  <link name="base">
    <visual><geometry><box size="0.4 0.4 0.1"/></geometry></visual>
  </link>
  <link name="arm">
    <visual>
      <origin xyz="0.3 0 0.1"/>
      <geometry><box size="0.6 0.08 0.08"/></geometry>
    </visual>
    <inertial>
      <mass value="1.2"/>
      <inertia ixx="0.002" iyy="0.04" izz="0.04" ixy="0" ixz="0" iyz="0"/>
    </inertial>
  </link>
  <joint name="shoulder" type="revolute">
    <parent link="base"/>
    <child link="arm"/>
      <axis xyz="0 0 1"/>
    <limit lower="1" upper="-1" effort="5" velocity="1"/>
  </joint>
</robot>
`,
);
writeFileSync(
  join(folder, 'robot.srdf'),
  `<robot name="my_robot">
  <group name="all"><chain base_link="base" tip_link="arm"/></group>
</robot>
`,
);
writeFileSync(
  join(folder, 'legs.xacro'),
  `<robot name="legs" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="length" value="0.4"/>
  <xacro:macro name="leg" params="side">
    <link name="\${side}_leg">
      <visual><geometry><box size="0.05 0.05 \${length / 2}"/></geometry></visual>
    </link>
    <joint name="\${side}_hip" type="fixed">
      <parent link="body"/>
      <child link="\${side}_leg"/>
    </joint>
  </xacro:macro>
  <link name="body"/>
  <xacro:leg side="left"/>
  <xacro:leg side="right"/>
</robot>
`,
);

/** An STL of a box, in meters. */
function boxMesh(x, y, z) {
  const at = (i) => [i & 1 ? x : -x, i & 2 ? y : -y, i & 4 ? z : -z].map((c) => c / 2);
  const faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
  const triangles = faces.flatMap(([a, b, c, d]) => [[a, b, c], [a, c, d]]);
  const bytes = Buffer.alloc(84 + 50 * triangles.length);
  bytes.writeUInt32LE(triangles.length, 80);
  triangles.forEach((corners, i) => {
    const numbers = corners.flatMap(at);
    numbers.forEach((number, k) => bytes.writeFloatLE(number, 84 + 50 * i + 12 + 4 * k));
  });
  return bytes;
}
mkdirSync(join(folder, 'meshes'));
writeFileSync(join(folder, 'meshes', 'finger.stl'), boxMesh(0.02, 0.03, 0.1));
writeFileSync(
  join(folder, 'gripper.urdf'),
  `<robot name="gripper">
  <link name="palm"/>
  <link name="finger">
    <visual><geometry><mesh filename="meshes/finger.stl"/></geometry></visual>
  </link>
  <joint name="slide" type="prismatic">
    <parent link="palm"/>
    <child link="finger"/>
    <limit lower="0.04" upper="0" effort="5" velocity="1"/>
  </joint>
</robot>
`,
);
writeFileSync(
  join(folder, 'block.urdf'),
  `<robot name="block">
  <link name="body">
    <inertial>
      <mass value="12"/>
      <inertia ixx="0.1" iyy="0.1" izz="0.18" ixy="0" ixz="0" iyz="0"/>
    </inertial>
    <visual><geometry><box size="0.3 0.3 0.1"/></geometry></visual>
    <collision><geometry><box size="0.3 0.3 0.1"/></geometry></collision>
  </link>
</robot>
`,
);

const began = Date.now();
const did = (what) => console.log(`${((Date.now() - began) / 1000).toFixed(1)} s  ${what}`);
const picture = async (name) => {
  const folderOfImages = process.env.RIGOR_IMAGES ?? work;
  await workbench.page.screenshot({ path: join(folderOfImages, `${name}.png`) });
};
const goTo = (name, mark, moved) => workbench.goTo(read(name), mark, moved);
/** It saves by itself. */
const saves = (name, text) =>
  until(`${JSON.stringify(text)} in ${name}`, () => read(name).includes(text));

let workbench;
try {
  workbench = await Workbench.open(command, {
    user: join(work, 'user'),
    folder,
    browser: process.env.RIGOR_CHROMIUM,
  });
  did('the workbench is open');
  const { page } = workbench;

  await workbench.openFile('robot.urdf');
  await page.locator('.squiggly-error').first().waitFor();
  await workbench.run('View: Focus Problems');
  const listed = async (rule) => (await workbench.problems()).some((line) => line.includes(rule));
  await until('the finding in the list', () => listed('joint-limit-inverted'));
  await workbench.showTab('robot.urdf');
  await goTo('robot.urdf', 'lower="1"', 7);
  await picture('vscode_findings');
  did('a finding is shown');

  await page.locator('.markers-panel a', { hasText: 'joint-limit-inverted' }).first().click();
  await workbench.isEditing('joint-limit-inverted');
  await page.locator('.view-line', { hasText: 'a lower joint limit is above' }).first().waitFor();
  await workbench.run('View: Close Editor');
  did('the page of its rule is shown');

  await workbench.openFile('robot.urdf');
  await goTo('robot.urdf', 'lower="1"', 7);
  await workbench.key('Control+.');
  await page.locator('.action-widget .monaco-list-row.focused', { hasText: 'swap' }).waitFor();
  await workbench.key('Enter');
  await saves('robot.urdf', 'lower="-1" upper="1"');
  await until('the finding to go', async () => !(await listed('joint-limit-inverted')));
  await workbench.key('Control+J'); // the list
  did('the fix is applied');

  await goTo('robot.urdf', 'name="arm"', 7);
  await workbench.key('F2');
  await page.locator('.monaco-editor.rename-box input').fill('forearm');
  await workbench.key('Enter');
  await page.locator('.monaco-editor.rename-box').waitFor({ state: 'hidden' });
  await saves('robot.urdf', '<child link="forearm"/>');
  await saves('robot.srdf', 'tip_link="forearm"');
  assert.match(read('robot.urdf'), /<link name="forearm">/);
  did('a link is renamed in both files');

  await workbench.openFile('robot.urdf');
  await goTo('robot.urdf', 'parent link="base"', 13);
  await workbench.key('Control+Shift+ArrowRight');
  await workbench.type('fo');
  const offered = page.locator('.suggest-widget .monaco-list-row', { hasText: 'forearm' }).first();
  await offered.waitFor();
  await workbench.key('Tab');
  await saves('robot.urdf', '<parent link="forearm"/>');
  await goTo('robot.urdf', 'parent link="forearm"', 13);
  await workbench.key('Control+Shift+ArrowRight');
  await workbench.type('base');
  await workbench.key('Escape');
  await saves('robot.urdf', '<parent link="base"/>');
  did('a name is completed');

  await workbench.run('Format Document');
  await saves('robot.urdf', '\n    <axis xyz="0 0 1"/>');
  did('the file is formatted');

  await workbench.run('rigor: Convert Model');
  await workbench.acceptPath('Convert to SDF');
  await until('the converted model', () => existsSync(join(folder, 'robot.sdf')));
  await workbench.isEditing('robot.sdf');
  assert.match(read('robot.sdf'), /<link name="forearm">/);
  await workbench.run('View: Close All Editors');
  did('the model is converted');

  await workbench.openFile('robot.urdf');
  await workbench.run('rigor: View Model');
  const frame = await workbench.viewFrame();
  await frame.evaluate(() => window.rigor.ready);
  const selects = (name) =>
    until(`${name} to be selected`, () =>
      frame.evaluate((wanted) => window.rigor.selection?.name.endsWith(wanted) ?? false, name),
    );
  await workbench.showTab('robot.urdf');
  await goTo('robot.urdf', '0.3 0 0.1');
  await selects('forearm');
  await workbench.key('Control+B'); // the explorer, for the picture
  await page.mouse.move(5, 500);
  await page.waitForTimeout(500); // and for that alone: it is drawn with the screen
  await picture('vscode_view');
  await workbench.key('Control+B');
  await frame.locator('#tree button', { hasText: 'shoulder' }).click();
  const line = read('robot.urdf').split('\n').findIndex((text) => text.includes('<joint')) + 1;
  await page.locator('.active-line-number', { hasText: String(line) }).waitFor();
  await selects('shoulder');
  did('the view follows the cursor, and the cursor the view');

  await workbench.showTab('robot.urdf');
  await goTo('robot.urdf', 'value="1.2"', 9);
  await workbench.key('Delete');
  await workbench.type('7');
  await frame.locator('#totals', { hasText: '1.7 kg' }).waitFor();
  did('the view takes what is saved');

  await workbench.run('View: Close All Editors');
  await workbench.openFile('legs.xacro');
  await workbench.run('rigor: Show Expanded Template');
  await page.locator('.view-line', { hasText: 'right_hip' }).first().waitFor();
  await goTo('legs.xacro', '0.4', 3);
  await workbench.key('Backspace');
  await workbench.type('8');
  await page.locator('.view-line', { hasText: '0.05 0.05 0.4' }).first().waitFor();
  await workbench.key('Home');
  await workbench.key('Control+B');
  await page.waitForTimeout(500);
  await picture('vscode_expanded');
  did('the expanded template follows what is typed');

  await workbench.key('Control+B');
  await workbench.run('View: Close All Editors');
  await workbench.openFile('gripper.urdf');
  await goTo('gripper.urdf', 'finger.stl', 3);
  await workbench.key('Control+K');
  await workbench.key('Control+I');
  const image = page.locator('.monaco-hover img');
  await image.first().waitFor();
  await until('the picture of the mesh', () => image.first().evaluate((one) => one.naturalWidth > 100));
  await page.locator('.monaco-hover', { hasText: '12 triangles, closed' }).first().waitFor();
  await picture('vscode_mesh');
  await workbench.key('Escape');
  did('a mesh is shown where it is named');

  await workbench.openFile('robot.urdf');
  await goTo('robot.urdf', '<robot');
  const lens = (text) => page.locator('.codelens-decoration a', { hasText: text }).first();
  await page.locator('.codelens-decoration', { hasText: '2 links, 1 joint, 1.7 kg' }).waitFor();
  await lens('view').click();
  await page.locator('.tab', { hasText: 'View of robot.urdf' }).waitFor();
  await workbench.viewFrame();
  did('a lens opens the view');

  if (process.env.RIGOR_TERMINALS) {
    await workbench.run('View: Close All Editors');
    await workbench.run('rigor: Validate Workspace');
    await until('a finding of a file that is not open', async () =>
      (await workbench.problems()).some((line) => line.includes('joint-limit-inverted')),
    );
    did('the workspace is validated');

    const terminal = page.locator('.terminal-wrapper.active .xterm-rows');
    await workbench.openFile('block.urdf');
    await lens('simulate').click();
    await page.locator('.quick-input-title', { hasText: 'Tests to simulate' }).waitFor();
    await workbench.key('Enter');
    await until('the verdict', async () => /1 model: 1 pass/.test(await terminal.innerText()));
    await picture('vscode_simulate');
    did('a lens simulates');
  } else {
    did('no tasks are run: the editor has no terminals');
  }
} catch (error) {
  await workbench?.page?.screenshot({ path: join(work, 'failed.png') }).catch(() => undefined);
  console.error(`${error.stack}\nwhat was on the screen: ${join(work, 'failed.png')}`);
  process.exitCode = 1;
} finally {
  await workbench?.close();
}
