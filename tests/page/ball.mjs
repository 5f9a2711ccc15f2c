// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
// Meshes of many triangles: balls with a rough surface, which do not compress as a smooth one does.

/** {positions, triangles}: `rings` × `sides` × 2 triangles about. The same for the same seed. */
export function roughBall(rings, sides, seed) {
  let state = seed + 1;
  const random = () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
  const positions = [];
  const triangles = [];
  for (let i = 0; i <= rings; ++i) {
    for (let k = 0; k < sides; ++k) {
      const [tilt, turn] = [(Math.PI * i) / rings, (2 * Math.PI * k) / sides];
      const radius = 0.1 * (1 + 0.03 * random());
      positions.push([
        radius * Math.sin(tilt) * Math.cos(turn),
        radius * Math.sin(tilt) * Math.sin(turn),
        radius * Math.cos(tilt),
      ]);
      if (i === rings) continue;
      const [a, b] = [i * sides + k, i * sides + ((k + 1) % sides)];
      triangles.push([a, a + sides, b], [b, a + sides, b + sides]);
    }
  }
  return { positions, triangles };
}

/** Binary STL. */
export function stlOf({ positions, triangles }) {
  const file = Buffer.alloc(84 + 50 * triangles.length);
  file.writeUInt32LE(triangles.length, 80);
  triangles.forEach((triangle, i) =>
    triangle.forEach((vertex, corner) =>
      positions[vertex].forEach((v, k) =>
        file.writeFloatLE(v, 84 + 50 * i + 12 + 12 * corner + 4 * k),
      ),
    ),
  );
  return file;
}
