// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
// Meshes for the graphics card.

import { BufferAttribute, BufferGeometry } from 'three';

import { creasedCorners } from './creases.js';

const view = (Type, buffer, range) =>
  new Type(buffer, range.at, range.bytes / Type.BYTES_PER_ELEMENT);

const srgbToLinear = Float32Array.from({ length: 256 }, (_, i) => {
  const v = i / 255;
  return v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4;
});

/** Light adds up in linear numbers; opacity is one already. */
function linearColors(bytes) {
  return Float32Array.from(bytes, (v, i) => (i % 4 === 3 ? v / 255 : srgbToLinear[v]));
}

function unpackedPositions(packed, { low, step }) {
  return Float32Array.from(packed, (v, i) => low[i % 3] + step[i % 3] * v);
}

/** What `take` names of every corner, one after the other. */
function gather(values, size, take) {
  const gathered = new values.constructor(take.length * size);
  take.forEach((vertex, corner) => {
    for (let k = 0; k < size; ++k) gathered[corner * size + k] = values[vertex * size + k];
  });
  return gathered;
}

/** Groups are the mesh's parts. A mesh without normals is smooth but for its creases. */
export function geometryOf(mesh, buffer) {
  const geometry = new BufferGeometry();
  const packed = view(Uint16Array, buffer, mesh.positions);
  const indices = view(mesh.vertices > 65535 ? Uint32Array : Uint16Array, buffer, mesh.indices);
  let positions = unpackedPositions(packed, mesh);
  let uvs = mesh.uvs && view(Float32Array, buffer, mesh.uvs);
  let colors = mesh.colors && linearColors(view(Uint8Array, buffer, mesh.colors));
  let normals = mesh.normals && view(Int8Array, buffer, mesh.normals);
  if (normals) {
    geometry.setIndex(new BufferAttribute(indices, 1));
  } else {
    normals = creasedCorners(positions, packed, indices);
    positions = gather(positions, 3, indices);
    uvs = uvs && gather(uvs, 2, indices);
    colors = colors && gather(colors, 4, indices);
  }
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  geometry.setAttribute('normal', new BufferAttribute(normals, 3, normals instanceof Int8Array));
  if (uvs) geometry.setAttribute('uv', new BufferAttribute(uvs, 2));
  if (colors) geometry.setAttribute('color', new BufferAttribute(colors, 4));
  geometry.userData.colors =
    colors && (colors.some((v, i) => i % 4 === 3 && v < 1) ? 'glass' : 'solid');
  mesh.parts.forEach(({ first, count }, i) => geometry.addGroup(3 * first, 3 * count, i));
  return geometry;
}
