// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
// What is looked at: selection, layers, joint positions. Panels and scene listen; none knows another.

import { Kinematics } from './kinematics.js';

export const LAYERS = [
  { name: 'visual', label: 'Visual', key: 'v' },
  { name: 'collision', label: 'Collision', key: 'c' },
  { name: 'inertia', label: 'Inertia', key: 'i' },
  { name: 'com', label: 'CoM', what: 'Centre of mass', key: 'm' },
  { name: 'frames', label: 'Frames', key: 'x' },
  { name: 'axes', label: 'Axes', what: 'Joint axes', key: 'j' },
  { name: 'contacts', label: 'Contacts', key: 'k' },
  { name: 'ground', label: 'Ground', key: 'g' },
];

/** By the full name, else by the short one. */
export function indexOfName(entities, name) {
  const full = entities.findIndex((entity) => entity.scoped === name);
  return full >= 0 ? full : entities.findIndex((entity) => entity.name === name);
}

/** Where the data has what can be selected. */
export const LISTS = { link: 'links', joint: 'joints', model: 'models' };

/**
 * Events: `model` (another model took the place of the last), `selection`, `finding`, `layers`, `positions`,
 * `source` (show `event.detail`: {file, line, column, endLine, endColumn}).
 */
export class State extends EventTarget {
  data = null;
  kinematics = null;
  selection = null; // {kind: 'link'|'joint'|'model', index}
  finding = -1;
  layers = new Set(['visual', 'ground']);

  #tell(event, detail) {
    this.dispatchEvent(new CustomEvent(event, { detail }));
  }

  on(events, listener) {
    for (const event of events.split(' ')) {
      this.addEventListener(event, ({ detail }) => listener(detail));
    }
  }

  /** Selection and joint positions stay with those of the same names. */
  setModel(data) {
    const last = this.data && { data: this.data, values: this.kinematics.values };
    const selected = this.selected()?.scoped;
    const kind = this.selection?.kind;
    this.data = data;
    this.kinematics = new Kinematics(data);
    this.selection = null;
    this.finding = -1;
    last?.data.joints.forEach(({ scoped }, old) => {
      const now = data.joints.findIndex((joint) => joint.scoped === scoped);
      if (now >= 0) last.values[old].forEach((value, k) => this.kinematics.set(now, k, value));
    });
    if (kind) {
      const index = data[LISTS[kind]].findIndex((entity) => entity.scoped === selected);
      if (index >= 0) this.selection = { kind, index };
    }
    this.#tell('model');
  }

  /** The model, link or joint that is selected. */
  selected() {
    return this.selection && this.data[LISTS[this.selection.kind]][this.selection.index];
  }

  isSelected(kind, index) {
    return this.selection?.kind === kind && this.selection.index === index;
  }

  select(kind, index) {
    this.selection = index >= 0 ? { kind, index } : null;
    this.finding = -1;
    this.#tell('finding');
    this.#tell('selection');
  }

  clear() {
    this.select('link', -1);
  }

  selectFinding(index) {
    const finding = this.data.findings[index];
    if (!finding) return;
    this.selection = null;
    if (finding.joint >= 0) this.selection = { kind: 'joint', index: finding.joint };
    else if (finding.link >= 0) this.selection = { kind: 'link', index: finding.link };
    this.finding = index;
    this.#tell('selection');
    this.#tell('finding');
    this.showSource(finding);
  }

  showSource(place) {
    if (this.data.files[place.file] && place.line > 0) this.#tell('source', place);
  }

  setLayers(names) {
    this.layers = new Set(names.filter((name) => LAYERS.some((layer) => layer.name === name)));
    this.#tell('layers');
  }

  toggleLayer(name) {
    const shown = new Set(this.layers);
    if (!shown.delete(name)) shown.add(name);
    this.setLayers([...shown]);
  }

  setJoint(joint, axis, value) {
    this.kinematics.set(joint, axis, value);
    this.#tell('positions');
  }

  resetJoints() {
    this.kinematics.reset();
    this.#tell('positions');
  }
}
