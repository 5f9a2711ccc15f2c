// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
// How surfaces look. Bodies of the same look share a material, since each costs the card a switch.

import {
  Color,
  DoubleSide,
  MeshPhongMaterial,
  RepeatWrapping,
  SRGBColorSpace,
  Texture,
} from 'three';

const HIGHLIGHT = 0x1d6fd6;
const GHOST = 0x1f9d3a;
/** Steps of depth: a collision often lies exactly on its visual, and a model's floor on the ground. */
const LIFTED = { collision: -1, ground: 1 };

async function textureOf(source) {
  const image = new Image();
  image.src = source;
  await image.decode();
  const texture = new Texture(image);
  texture.colorSpace = SRGBColorSpace;
  texture.wrapS = RepeatWrapping;
  texture.wrapT = RepeatWrapping;
  texture.needsUpdate = true;
  return texture;
}

/** Null for a picture that cannot be read: the surface is then drawn without. */
export function texturesOf(sources) {
  return Promise.all(sources.map((source) => textureOf(source).catch(() => null)));
}

export class Materials {
  #made = new Map();
  /** Of what is not there, and would be. */
  ghost = new MeshPhongMaterial({
    color: GHOST,
    opacity: 0.4,
    transparent: true,
    depthWrite: false,
    side: DoubleSide,
  });

  constructor(textures) {
    this.textures = textures;
  }

  /** `colors`: whether the mesh's vertices have some, which multiply the surface's: null, "solid", "glass". */
  of({ color, texture }, colors, layer, highlighted) {
    const [r, g, b, a] = color;
    const key = `${color} ${texture} ${colors} ${LIFTED[layer]} ${highlighted}`;
    let material = this.#made.get(key);
    if (!material) {
      material = new MeshPhongMaterial({
        color: new Color().setRGB(r, g, b, SRGBColorSpace),
        opacity: a,
        transparent: a < 1 || colors === 'glass',
        depthWrite: a >= 1,
        map: this.textures[texture] ?? null,
        vertexColors: colors !== null,
        // Meshes of models are often open or inside out; what is looked at is shown.
        side: DoubleSide,
        specular: 0x1a1a1a,
        shininess: 32,
        polygonOffset: layer in LIFTED,
        polygonOffsetFactor: LIFTED[layer] ?? 0,
        polygonOffsetUnits: LIFTED[layer] ?? 0,
      });
      if (material.map) Object.assign(material, { alphaTest: 0.02, transparent: true });
      if (highlighted) {
        // Not added as light: a red part would be pink, and a white one as before.
        material.color.lerp(new Color(HIGHLIGHT), 0.75);
        material.emissive = new Color(HIGHLIGHT);
        material.emissiveIntensity = 0.25;
        material.opacity = Math.max(a, 0.6);
      }
      this.#made.set(key, material);
    }
    return material;
  }

  dispose() {
    this.ghost.dispose();
    for (const material of this.#made.values()) material.dispose();
    for (const texture of this.textures) texture?.dispose();
  }
}
