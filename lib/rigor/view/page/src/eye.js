// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
// From where the model is seen. z is up.

import { PerspectiveCamera, Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

/** Towards the eye, as the pictures of `rigor render` (camera.cc). */
const DIRECTIONS = {
  perspective: [1, 0.62, 0.52],
  front: [1, 0, 0],
  side: [0, 1, 0],
  top: [-1e-4, 0, 1], // so that x is upward
};

const DEGREES = 32; // narrow enough that a robot's near wheels do not look swollen
const FILLED = 0.9; // of half of the picture; the rest is margin

export class Eye {
  camera = new PerspectiveCamera(DEGREES, 1, 0.01, 100);

  constructor(element, onChange) {
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, element);
    this.controls.zoomToCursor = true;
    this.controls.addEventListener('change', onChange);
  }

  resize(width, height) {
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
  }

  /** All of the box, from where one looks now or from a view's side. */
  frame(box, view) {
    if (box.isEmpty()) box.set(new Vector3(-0.5, -0.5, -0.5), new Vector3(0.5, 0.5, 0.5));
    const centre = box.getCenter(new Vector3());
    const towards = view
      ? new Vector3(...DIRECTIONS[view]).normalize()
      : this.camera.position.clone().sub(this.controls.target).normalize();
    const upward = view === 'top' ? new Vector3(1, 0, 0) : this.camera.up;
    const right = new Vector3().crossVectors(upward, towards).normalize();
    const up = new Vector3().crossVectors(towards, right);
    const high = FILLED * Math.tan((DEGREES * Math.PI) / 360);
    const wide = high * this.camera.aspect;
    let distance = 0;
    for (let i = 0; i < 8; ++i) {
      const corner = new Vector3(
        i & 1 ? box.max.x : box.min.x,
        i & 2 ? box.max.y : box.min.y,
        i & 4 ? box.max.z : box.min.z,
      ).sub(centre);
      const nearer = corner.dot(towards);
      distance = Math.max(
        distance,
        nearer + Math.abs(corner.dot(up)) / high,
        nearer + Math.abs(corner.dot(right)) / wide,
      );
    }
    this.controls.target.copy(centre);
    this.camera.position.copy(centre).addScaledVector(towards, Math.max(distance, 1e-3));
    this.controls.update();
  }

  /** Depth is told apart best where it is not wasted on what is nearer or farther than the model. */
  fit(sphere) {
    const distance = this.camera.position.distanceTo(sphere.center);
    const radius = Math.max(sphere.radius, 1e-3);
    this.camera.near = Math.max(distance - 2 * radius, radius / 500, distance / 5000);
    this.camera.far = distance + 40 * radius;
    this.camera.updateProjectionMatrix();
  }

  /** Six numbers: where the eye is, and at what it looks. */
  get place() {
    return [...this.camera.position.toArray(), ...this.controls.target.toArray()];
  }
}
