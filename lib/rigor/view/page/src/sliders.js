// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
// A slider and a number for every axis of every joint. Those that follow another cannot be moved.

import { byId, el } from './dom.js';
import { numberText } from './pose.js';

/** An axis without limits can be moved half a turn, or a metre, to both sides. */
export function rangeOf({ slides, lower, upper }) {
  const free = slides ? 1 : Math.PI;
  const low = lower ?? Math.min(-free, (upper ?? 0) - free);
  const high = upper ?? Math.max(free, low + free);
  return low <= high ? [low, high] : [high, low];
}

export function showSliders(state) {
  const list = byId('sliders');
  let sliders = [];

  const update = () => {
    for (const { joint, axis, range, number } of sliders) {
      const q = state.kinematics.position(joint, axis);
      range.value = q;
      if (document.activeElement !== number) number.value = numberText(Number(q.toFixed(6)));
    }
  };

  const make = (joint, index, axis, k) => {
    const [low, high] = rangeOf(axis);
    const unit = axis.slides ? 'm' : 'rad';
    const name = joint.axes.length > 1 ? `${joint.name} (axis ${k + 1})` : joint.name;
    const leader = state.data.joints[axis.mimic?.joint];
    const set = ({ target }) => {
      const value = target.valueAsNumber;
      if (Number.isFinite(value)) state.setJoint(index, k, Math.max(low, Math.min(high, value)));
    };
    const common = {
      min: low,
      max: high,
      disabled: axis.mimic !== null,
      input: set,
      title: leader
        ? `follows ${leader.scoped}`
        : `${numberText(low)} to ${numberText(high)} ${unit}`,
    };
    const range = el('input', {
      ...common,
      type: 'range',
      step: 'any',
      'aria-label': `${joint.scoped}, ${unit}`,
    });
    const number = el('input', {
      ...common,
      type: 'number',
      step: (high - low) / 100 || 'any',
      'aria-label': `${joint.scoped}, ${unit}, as a number`,
      blur: update,
    });
    const label = el(
      'button',
      {
        type: 'button',
        class: 'joint-name',
        title: joint.scoped,
        click: () => state.select('joint', index),
      },
      name,
    );
    const note = el('span', { class: 'unit' }, leader ? 'follows' : unit);
    return { joint: index, axis: k, range, number, item: el('li', {}, label, number, note, range) };
  };

  const build = () => {
    sliders = state.data.joints.flatMap((joint, index) =>
      joint.axes.flatMap((axis, k) =>
        axis.direction && joint.type !== 'fixed' ? [make(joint, index, axis, k)] : [],
      ),
    );
    list.replaceChildren(...sliders.map(({ item }) => item));
    byId('joints-none').hidden = sliders.length > 0;
    byId('reset').disabled = sliders.length === 0;
    update();
  };

  byId('reset').addEventListener('click', () => state.resetJoints());
  state.on('model', build);
  state.on('positions', update);
  state.on('selection', () => {
    for (const { joint, item } of sliders)
      item.classList.toggle('selected', state.isSelected('joint', joint));
  });
}
