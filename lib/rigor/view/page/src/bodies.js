// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
// The model's bodies as three.js holds them: a group for every link, which its joints move, and in it
// what moves with it.

import { Box3, Group, Matrix4, Mesh, Quaternion, Vector3 } from 'three';

import { geometryOf } from './geometry.js';
import { Materials, texturesOf } from './materials.js';
import { IDENTITY, compose } from './pose.js';

/** Drawn over all else, since they lie inside of what they are marks of. */
const MARKS = new Set(['inertia', 'com', 'frames', 'axes', 'contacts']);
export const MARKS_LAYER = 1;

function matrixOf([x, y, z, w, i, j, k], scale = [1, 1, 1]) {
  return new Matrix4().compose(
    new Vector3(x, y, z),
    new Quaternion(i, j, k, w),
    new Vector3(...scale),
  );
}

export async function makeBodies({ data, buffer }) {
  const textures = await texturesOf(data.textures);
  return new Bodies(
    data,
    data.meshes.map((mesh) => geometryOf(mesh, buffer)),
    textures,
  );
}

export class Bodies {
  group = new Group();
  meshes = []; // one for each of data.bodies, which is its userData
  ghosts = new Group(); // where parts would be with the fix of a finding, joints at zero

  constructor(data, geometries, textures) {
    this.data = data;
    this.geometries = geometries;
    this.materials = new Materials(textures);
    this.still = new Group(); // what no link moves
    this.links = data.links.map(() => new Group());
    this.group.add(this.still, this.ghosts, ...this.links);
    for (const link of this.links) link.matrixAutoUpdate = false;
    data.bodies.forEach((body) => this.#add(body));
  }

  #add(body) {
    const mesh = new Mesh(this.geometries[body.mesh]);
    mesh.userData = body;
    mesh.matrixAutoUpdate = false;
    mesh.matrix.copy(matrixOf(body.pose, body.scale));
    if (MARKS.has(body.layer)) mesh.layers.set(MARKS_LAYER);
    if (body.layer === 'ground') mesh.renderOrder = -1;
    this.meshes.push(mesh);
    this.#paint(mesh, false);
    (this.links[body.link] ?? this.still).add(mesh);
  }

  #paint(mesh, highlighted) {
    const { surfaces, layer } = mesh.userData;
    const { colors } = mesh.geometry.userData;
    const made = surfaces.map((surface) => this.materials.of(surface, colors, layer, highlighted));
    mesh.material = made.length === 1 ? made[0] : made;
  }

  /** The ground is light; on a dark page less of it is seen. */
  dim(isDark) {
    for (const mesh of this.meshes.filter(({ userData }) => userData.layer === 'ground')) {
      mesh.userData.surfaces.forEach(({ color }, i) => {
        const material = Array.isArray(mesh.material) ? mesh.material[i] : mesh.material;
        material.opacity = color[3] * (isDark ? 0.3 : 1);
      });
    }
  }

  move(displacements) {
    this.links.forEach((link, i) => link.matrix.copy(matrixOf(displacements[i])));
    this.group.updateMatrixWorld(true);
  }

  show(layers) {
    for (const mesh of this.meshes) mesh.visible = layers.has(mesh.userData.layer);
  }

  /** `isChosen(body)` */
  highlight(isChosen) {
    for (const mesh of this.meshes) this.#paint(mesh, isChosen(mesh.userData));
  }

  /** Those of a finding, none for -1. They are no bodies: nobody picks them, and layers do not hide them. */
  haunt(finding) {
    this.ghosts.clear();
    for (const ghost of (this.data.ghosts ?? []).filter((each) => each.finding === finding)) {
      const mesh = new Mesh(this.geometries[this.data.bodies[ghost.body].mesh], this.materials.ghost);
      mesh.matrixAutoUpdate = false;
      mesh.matrix.copy(matrixOf(ghost.pose, ghost.scale));
      this.ghosts.add(mesh);
    }
    this.group.updateMatrixWorld(true);
  }

  ghostMiddles() {
    return this.ghosts.children.map((mesh) =>
      new Box3().setFromObject(mesh).getCenter(new Vector3()).toArray(),
    );
  }

  /** The pose of a link as it stands in the scene; null when the file does not tell. */
  linkPose(link) {
    const { pose } = this.data.links[link];
    if (!pose) return null;
    const at = new Vector3();
    const turn = new Quaternion();
    this.links[link].matrixWorld.decompose(at, turn, new Vector3());
    return compose([at.x, at.y, at.z, turn.w, turn.x, turn.y, turn.z], pose);
  }

  displacement(link) {
    return this.links[link]?.matrixWorld ?? matrixOf(IDENTITY);
  }

  /** Of what `counts(body)`, at the present positions. Endless planes are left out where there is more. */
  bounds(counts) {
    const meshes = this.meshes.filter(({ userData }) => counts(userData));
    const solid = meshes.filter((mesh) => this.data.meshes[mesh.userData.mesh].triangles > 2);
    const box = new Box3();
    for (const mesh of solid.length > 0 ? solid : meshes) {
      if (!mesh.geometry.boundingBox) mesh.geometry.computeBoundingBox();
      box.union(mesh.geometry.boundingBox.clone().applyMatrix4(mesh.matrixWorld));
    }
    return box.union(new Box3().setFromObject(this.ghosts));
  }

  dispose() {
    for (const geometry of this.geometries) geometry.dispose();
    this.materials.dispose();
  }
}
