// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
// The page of `rigor view`: puts its parts together.

import { makeBodies } from './bodies.js';
import { readPage } from './data.js';
import { linkDeeply } from './deep_links.js';
import { byId, counted, el } from './dom.js';
import { editorAround, followEditor } from './editor.js';
import { showPictures } from './fallback.js';
import { showFindings } from './findings_panel.js';
import { listenToKeys } from './keyboard.js';
import { reloadLive } from './live.js';
import { pickWithPointer } from './picking.js';
import { compose } from './pose.js';
import { showSelection } from './selection_panel.js';
import { showSliders } from './sliders.js';
import { showSource } from './source_panel.js';
import { Stage } from './stage.js';
import { State } from './state.js';
import { switchTabs } from './tabs.js';
import { offerToTests } from './test_interface.js';
import { switchTheme } from './theme.js';
import { showToolbar } from './toolbar.js';
import { showTree } from './tree.js';

class App {
  state = new State();
  stage = null;
  bodies = null;

  constructor() {
    try {
      this.stage = new Stage(byId('scene'));
    } catch {
      // No WebGL: pictures are shown in place of the scene.
    }
  }

  connect() {
    const { state, stage } = this;
    const scenePose = (link) => this.scenePose(link);
    state.on('positions', () => this.move());
    state.on('layers', () => this.show());
    state.on('selection', () => this.highlight());
    state.on('finding', () => this.haunt());
    state.on('model', () => this.sayTotals());
    showToolbar(state, stage);
    showTree(state);
    showSliders(state);
    showSelection(state, scenePose);
    showFindings(state);
    showSource(state);
    switchTabs(state);
    const toggleTheme = switchTheme(() => stage?.draw());
    listenToKeys(state, stage, toggleTheme);
    if (stage) pickWithPointer(stage, state, byId('hover'));
  }

  /** Shows another model; the first one is looked at as a whole. */
  async swap(page) {
    const { state, stage } = this;
    const isFirst = !state.data;
    if (stage) this.bodies = await makeBodies(page);
    stage?.setBodies(this.bodies);
    state.setModel(page.data);
    if (!stage) showPictures(page.data);
    this.move();
    this.show();
    this.highlight();
    if (isFirst) stage?.frame('perspective');
  }

  /** In the file's frame; read from the scene where there is one. */
  scenePose(link) {
    if (this.bodies) return this.bodies.linkPose(link);
    const { pose } = this.state.data.links[link];
    return pose && compose(this.state.kinematics.displacements()[link], pose);
  }

  move() {
    this.bodies?.move(this.state.kinematics.displacements());
    this.point();
    this.stage?.draw();
  }

  show() {
    this.bodies?.show(this.state.layers);
    this.stage?.draw();
  }

  highlight() {
    const { state, bodies } = this;
    if (!bodies) return;
    const { kind, index } = state.selection ?? {};
    const joint = kind === 'joint' ? index : -1;
    const link = kind === 'link' ? index : (state.data.joints[joint]?.child ?? -1);
    bodies.highlight((body) =>
      body.joint >= 0 ? body.joint === joint : body.link >= 0 && body.link === link,
    );
    this.point();
  }

  /** Shows where what the finding is about would be. */
  haunt() {
    this.bodies?.haunt(this.state.finding);
    this.stage?.draw();
  }

  /** At the frame of the selected link, or the axes of the selected joint. */
  point() {
    const { state, stage, bodies } = this;
    if (!stage) return;
    const chosen = state.selected();
    const { kind, index } = state.selection ?? {};
    if (kind === 'link' && chosen.pose) stage.pointAtLink(bodies.linkPose(index));
    else if (kind === 'joint' && chosen.pose && chosen.axes.some((axis) => axis.direction)) {
      stage.pointAtJoint(chosen, bodies.displacement(chosen.parent));
    } else stage.point([]);
  }

  sayTotals() {
    const { name, path, totals } = this.state.data;
    document.title = `${name} · rigor`;
    byId('model-name').replaceChildren(name);
    byId('model-path').replaceChildren(path);
    const facts = [counted(totals.links, 'link'), counted(totals.joints, 'joint')];
    if (totals.mass !== null) facts.push(`${Number(totals.mass.toPrecision(4))} kg`);
    if (totals.triangles.visual > 0) facts.push(counted(totals.triangles.visual, 'triangle'));
    byId('totals').replaceChildren(...facts.map((fact) => el('li', {}, fact)));
  }
}

async function start(app) {
  app.connect();
  const page = await readPage();
  await app.swap(page);
  const editor = editorAround();
  if (!editor) linkDeeply(app.state);
  app.stage?.render();
  performance.mark('rigor-ready');
  if (editor) followEditor(editor, app);
  else if (page.data.live) reloadLive((changed) => app.swap(changed));
}

const app = new App();
const ready = start(app);
offerToTests(app, ready);
ready.catch((error) => {
  const box = byId('fallback');
  box.hidden = false;
  box.replaceChildren(el('p', {}, `This page could not be shown: ${error.message}`));
});
