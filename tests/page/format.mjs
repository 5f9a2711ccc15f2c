// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The page's two blocks, written down a second time: what rigor's C++ puts into the page, made by hand.

import { deflateSync } from 'node:zlib';

/** Gathers arrays of numbers into one block, each at a multiple of four. */
export class Bytes {
  #chunks = [];
  #size = 0;

  /** {at, bytes} of the array. */
  add(array) {
    const bytes = Buffer.from(array.buffer, array.byteOffset, array.byteLength);
    const range = { at: this.#size, bytes: bytes.length };
    const padding = (4 - (bytes.length % 4)) % 4;
    this.#chunks.push(bytes, Buffer.alloc(padding));
    this.#size += bytes.length + padding;
    return range;
  }

  base64() {
    return deflateSync(Buffer.concat(this.#chunks)).toString('base64');
  }
}

/** A mesh of the format: `positions` [[x, y, z]…], `triangles` [[a, b, c]…], and what else it has. */
export function packMesh(bytes, { positions, triangles, normals, uvs, colors, parts }) {
  const axis = (k) => positions.map((p) => p[k]);
  // Not Math.min(...), which a large mesh has too many arguments for.
  const least = (values) => values.reduce((a, b) => Math.min(a, b), Infinity);
  const most = (values) => values.reduce((a, b) => Math.max(a, b), -Infinity);
  const low = [0, 1, 2].map((k) => least(axis(k)));
  const step = [0, 1, 2].map((k) => (most(axis(k)) - low[k]) / 65535);
  const quantized = positions.flatMap((p) =>
    p.map((v, k) => (step[k] > 0 ? Math.round((v - low[k]) / step[k]) : 0)),
  );
  const Index = positions.length > 65535 ? Uint32Array : Uint16Array;
  return {
    vertices: positions.length,
    triangles: triangles.length,
    low,
    step,
    positions: bytes.add(Uint16Array.from(quantized)),
    normals: normals ? bytes.add(Int8Array.from(normals.flat(), (v) => Math.round(127 * v))) : null,
    uvs: uvs ? bytes.add(Float32Array.from(uvs.flat())) : null,
    colors: colors ? bytes.add(Uint8Array.from(colors.flat())) : null,
    indices: bytes.add(Index.from(triangles.flat())),
    parts: parts ?? [{ first: 0, count: triangles.length }],
  };
}

/** The page with a model in it. */
export function fillTemplate(template, data, base64) {
  const json = JSON.stringify(data).replaceAll('<', '\\u003c');
  return template.replace(
    '<!--DATA-->',
    () =>
      `<script id="data" type="application/json">${json}</script>\n<script id="bytes" type="text/plain">${base64}</script>`,
  );
}
