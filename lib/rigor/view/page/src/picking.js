// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
// The pointer in the scene: names under it, and what a click selects.

/** px. A hand that moves farther between press and release is turning the model. */
const STILL = 5;

export function pickWithPointer(stage, state, label) {
  const canvas = stage.element;
  let pressed = null;
  let timer = null;
  let rest = 0; // ms: as long as the last look took thrice, so that large meshes do not make the pointer stick

  const hideLabel = () => {
    clearTimeout(timer);
    timer = null;
    label.hidden = true;
  };

  const hover = (x, y) => {
    timer = null;
    const began = performance.now();
    const body = stage.bodyAt(x, y);
    rest = 3 * (performance.now() - began);
    label.hidden = !body;
    canvas.classList.toggle('over-body', Boolean(body));
    if (!body) return;
    const carrier = state.data.joints[body.joint] ?? state.data.links[body.link];
    // "arm::hand/link palm/visual shell"
    label.replaceChildren(
      carrier ? `${carrier.scoped} · ${body.name.split('/').at(-1)}` : body.name,
    );
    const { left, top, width } = canvas.getBoundingClientRect();
    const flipped = x - left > width / 2;
    label.style.left = flipped ? 'auto' : `${x - left + 14}px`;
    label.style.right = flipped ? `${width - (x - left) + 14}px` : 'auto';
    label.style.top = `${y - top + 14}px`;
  };

  canvas.addEventListener('pointerdown', (event) => {
    pressed = [event.clientX, event.clientY];
    hideLabel();
  });
  canvas.addEventListener('pointermove', (event) => {
    if (event.buttons !== 0 || event.pointerType === 'touch') return;
    clearTimeout(timer);
    timer = setTimeout(() => hover(event.clientX, event.clientY), rest);
  });
  canvas.addEventListener('pointerleave', hideLabel);
  canvas.addEventListener('pointerup', (event) => {
    const from = pressed;
    pressed = null;
    if (!from || event.button !== 0) return;
    if (Math.hypot(event.clientX - from[0], event.clientY - from[1]) > STILL) return;
    const body = stage.bodyAt(event.clientX, event.clientY);
    if (!body) state.clear();
    else if (body.joint >= 0) state.select('joint', body.joint);
    else state.select('link', body.link);
  });
}
