// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
// Normals of meshes that come without: faces that meet at less than a crease's angle share
// theirs, as of the side of a cylinder; others, as of a box, have an edge.

const COS_CREASE = Math.cos(Math.PI / 6); // the sides of a cylinder of 16 meet at 22.5°
/** The tip of a fan has no smooth normal, and comparing all its faces would take long. */
const MOST_FACES_OF_A_POINT = 64;

/** The normal of every face, three numbers each, as long as twice its area. */
function faceNormals(positions, indices) {
  const normals = new Float32Array(indices.length);
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = [3 * indices[i], 3 * indices[i + 1], 3 * indices[i + 2]];
    const ux = positions[b] - positions[a];
    const uy = positions[b + 1] - positions[a + 1];
    const uz = positions[b + 2] - positions[a + 2];
    const vx = positions[c] - positions[a];
    const vy = positions[c + 1] - positions[a + 1];
    const vz = positions[c + 2] - positions[a + 2];
    normals[i] = uy * vz - uz * vy;
    normals[i + 1] = uz * vx - ux * vz;
    normals[i + 2] = ux * vy - uy * vx;
  }
  return normals;
}

/** The corners at each place: vertices of one place are often written once for every face. */
function cornersByPlace(packed, indices) {
  const places = new Map();
  indices.forEach((vertex, corner) => {
    const place =
      packed[3 * vertex] + 65536 * packed[3 * vertex + 1] + 65536 ** 2 * packed[3 * vertex + 2];
    const corners = places.get(place);
    if (corners) corners.push(corner);
    else places.set(place, [corner]);
  });
  return places;
}

/** A unit normal for every corner of every face. `packed`: the positions as whole numbers. */
export function creasedCorners(positions, packed, indices) {
  const faces = faceNormals(positions, indices);
  const lengths = new Float32Array(indices.length / 3);
  for (let f = 0; f < lengths.length; ++f) {
    lengths[f] = Math.hypot(faces[3 * f], faces[3 * f + 1], faces[3 * f + 2]);
  }
  const normals = new Float32Array(3 * indices.length);
  for (const corners of cornersByPlace(packed, indices).values()) {
    const others = corners.length > MOST_FACES_OF_A_POINT ? [] : corners;
    for (const corner of corners) {
      const f = Math.floor(corner / 3);
      let [x, y, z] = [faces[3 * f], faces[3 * f + 1], faces[3 * f + 2]];
      const own = [x, y, z];
      for (const other of others) {
        const g = Math.floor(other / 3);
        if (g === f) continue;
        const [gx, gy, gz] = [faces[3 * g], faces[3 * g + 1], faces[3 * g + 2]];
        const cosine = own[0] * gx + own[1] * gy + own[2] * gz;
        if (cosine < COS_CREASE * lengths[f] * lengths[g]) continue;
        x += gx;
        y += gy;
        z += gz;
      }
      const length = Math.hypot(x, y, z) || 1;
      normals[3 * corner] = x / length;
      normals[3 * corner + 1] = y / length;
      normals[3 * corner + 2] = z / length;
    }
  }
  return normals;
}
