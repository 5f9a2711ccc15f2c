// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
// The scene on the screen. A frame is drawn when something changed, never else.

import {
  BoxGeometry,
  Color,
  DirectionalLight,
  Group,
  HemisphereLight,
  Mesh,
  MeshBasicMaterial,
  Raycaster,
  Scene,
  Sphere,
  Vector2,
  Vector3,
  WebGLRenderer,
} from 'three';

import { MARKS_LAYER } from './bodies.js';
import { Eye } from './eye.js';
import { rotate } from './pose.js';
import { isDark } from './theme.js';

// A white surface's shares of light, as in the pictures of `rigor render` (shading.cc).
const LAMP = 0.56 * Math.PI;
const SKY = 0.27 * Math.PI;
const EYE = 0.15 * Math.PI;
const FLOOR = new Color(0.45, 0.45, 0.45);

const FRAME_COLORS = [0xd92626, 0x1f9d3a, 0x3b6cf5];
const JOINT_COLOR = 0xf0b400;

export class Stage {
  frames = 0; // drawn since the page opened
  bodies = null;

  /** Throws where there is no WebGL. */
  constructor(host) {
    this.host = host;
    this.renderer = new WebGLRenderer({ antialias: true, powerPreference: 'low-power' });
    this.renderer.autoClear = false;
    this.element = this.renderer.domElement;
    host.prepend(this.element);
    this.scene = new Scene();
    this.eye = new Eye(this.element, () => this.draw());
    this.#light();
    this.pointed = new Group();
    this.rod = new BoxGeometry();
    this.scene.add(this.pointed);
    this.element.addEventListener('webglcontextrestored', () => this.draw());
    new ResizeObserver(() => this.resize()).observe(host);
    this.resize();
  }

  #light() {
    const lamp = new DirectionalLight(0xffffff, LAMP);
    lamp.position.set(0.36, 0.48, 0.8);
    const sky = new HemisphereLight(0xffffff, FLOOR, SKY);
    sky.position.set(0, 0, 1);
    this.glow = new DirectionalLight(0xffffff, EYE);
    for (const light of [lamp, sky, this.glow]) {
      light.layers.enable(MARKS_LAYER);
      this.scene.add(light);
    }
  }

  setBodies(bodies) {
    if (this.bodies) {
      this.scene.remove(this.bodies.group);
      this.bodies.dispose();
    }
    this.bodies = bodies;
    this.scene.add(bodies.group);
  }

  #whole() {
    return this.bodies.bounds((body) => body.layer !== 'ground');
  }

  /** The link, or all; from where one looks, or from a view's side. */
  frame(view = null, link = -1) {
    const box = this.bodies.bounds(
      (body) =>
        (body.layer === 'visual' || body.layer === 'collision') && (link < 0 || body.link === link),
    );
    this.eye.frame(box.isEmpty() ? this.#whole() : box, view);
    this.draw();
  }

  /** At nothing, or at [{from, along, color}]: rods in the scene. */
  point(rods) {
    this.pointed.clear();
    const thickness = 0.003 * this.#size();
    for (const { from, along, color } of rods) {
      const rod = new Mesh(this.rod, new MeshBasicMaterial({ color }));
      const length = along.length();
      rod.scale.set(thickness, thickness, length);
      rod.quaternion.setFromUnitVectors(new Vector3(0, 0, 1), along.clone().normalize());
      rod.position.copy(from).addScaledVector(along, 0.5);
      rod.layers.set(MARKS_LAYER);
      this.pointed.add(rod);
    }
    this.draw();
  }

  pointAtLink(pose) {
    const size = 0.14 * this.#size();
    const from = new Vector3(...pose.slice(0, 3));
    this.point(
      [
        [1, 0, 0],
        [0, 1, 0],
        [0, 0, 1],
      ].map((axis, k) => ({
        from,
        along: new Vector3(...rotate(pose.slice(3), axis)).multiplyScalar(size),
        color: FRAME_COLORS[k],
      })),
    );
  }

  /** `displacement`: of what the joint is fixed to. */
  pointAtJoint({ pose, axes }, displacement) {
    const size = 0.5 * this.#size();
    const at = new Vector3(...pose).applyMatrix4(displacement);
    this.point(
      axes
        .filter((axis) => axis.direction)
        .map(({ direction }) => {
          const along = new Vector3(...direction)
            .transformDirection(displacement)
            .multiplyScalar(size);
          return { from: at.clone().addScaledVector(along, -0.5), along, color: JOINT_COLOR };
        }),
    );
  }

  #size() {
    return this.#whole().getSize(new Vector3()).length() || 1;
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.host;
    if (width === 0 || height === 0) return;
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.renderer.setSize(width, height);
    this.eye.resize(width, height);
    this.render(); // at once: a canvas that changed its size is blank
  }

  draw() {
    this.waiting ??= requestAnimationFrame(() => this.render());
  }

  render() {
    if (this.waiting) cancelAnimationFrame(this.waiting);
    this.waiting = null;
    if (!this.bodies) return;
    const { camera } = this.eye;
    this.eye.fit(this.#whole().getBoundingSphere(new Sphere()));
    this.glow.position.copy(camera.position).sub(this.eye.controls.target);
    this.renderer.setClearColor(new Color(getComputedStyle(this.host).backgroundColor));
    this.bodies.dim(isDark());
    this.renderer.clear();
    camera.layers.set(0);
    this.renderer.render(this.scene, camera);
    this.renderer.clearDepth();
    camera.layers.set(MARKS_LAYER);
    this.renderer.render(this.scene, camera);
    this.frames += 1;
  }

  /** What is seen at a place of the window: a body, or null. Marks come first, as they are drawn. */
  bodyAt(clientX, clientY) {
    const { left, top, width, height } = this.element.getBoundingClientRect();
    const at = new Vector2((2 * (clientX - left)) / width - 1, 1 - (2 * (clientY - top)) / height);
    const ray = new Raycaster();
    ray.layers.enableAll();
    ray.setFromCamera(at, this.eye.camera);
    const seen = this.bodies.meshes.filter(
      ({ visible, userData }) => visible && userData.layer !== 'ground',
    );
    const bodies = ray.intersectObjects(seen, false).map(({ object }) => object.userData);
    const first = (...layers) => bodies.find(({ layer }) => layers.includes(layer));
    return (
      first('com', 'frames', 'axes', 'contacts') ??
      first('visual', 'collision') ??
      first('inertia') ??
      null
    );
  }
}
