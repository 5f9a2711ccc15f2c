// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
// What C++ put into the page, or what the server sends: JSON, and the numbers of the meshes.

function fromBase64(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const characters = atob(text);
  const bytes = new Uint8Array(characters.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = characters.charCodeAt(i);
  return bytes;
}

async function inflate(text) {
  const packed = fromBase64(text.trim());
  if (packed.length === 0) return new ArrayBuffer(0);
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Response(stream).arrayBuffer();
}

async function read(data, bytes) {
  if (data.format !== 1) throw new Error(`this page reads format 1, not ${data.format}`);
  return { data, buffer: await inflate(bytes) };
}

export function readPage() {
  const text = (id) => document.getElementById(id).textContent;
  return read(JSON.parse(text('data')), text('bytes'));
}

/** Of what a server answers. */
export function readText(text) {
  const { data, bytes } = JSON.parse(text);
  return read(data, bytes);
}

export async function readServer() {
  return readText(await (await fetch('/data')).text());
}
