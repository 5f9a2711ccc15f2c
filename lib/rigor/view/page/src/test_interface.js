// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
// What tests of the page use: window.rigor.

import { indexOfName } from './state.js';

export function offerToTests(app, ready) {
  const { state } = app;
  const joint = (name) => indexOfName(state.data.joints, name);
  window.rigor = {
    ready,
    get webgl() {
      return app.stage !== null;
    },
    get frames() {
      return app.stage?.frames ?? 0;
    },
    get camera() {
      return app.stage?.eye.place ?? null;
    },
    get layers() {
      return [...state.layers];
    },
    get selection() {
      return state.selection && { kind: state.selection.kind, name: state.selected().scoped };
    },
    get finding() {
      return state.finding;
    },
    /** Middles of what the chosen finding would move, in the file's frame. */
    get ghosts() {
      return app.bodies?.ghostMiddles() ?? [];
    },
    get copied() {
      return state.copied ?? '';
    },
    setJoint: (name, value, axis = 0) => state.setJoint(joint(name), axis, value),
    jointPosition: (name, axis = 0) => state.kinematics.position(joint(name), axis),
    linkPose: (name) => app.scenePose(indexOfName(state.data.links, name)),
    show: (layers) => state.setLayers(layers),
    select: (name) => state.select('link', indexOfName(state.data.links, name)),
    /** Draws now rather than with the screen. */
    render: () => app.stage?.render(),
  };
}
