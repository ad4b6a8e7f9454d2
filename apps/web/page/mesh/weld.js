// Joins corners of triangles that lie in the same place, bit for bit, to one vertex.
// SPDX-License-Identifier: Apache-2.0

import { checkCount } from "./refused.js";

function hash(bits, at, size) {
  let value = Math.imul(bits[at], 0x9e3779b1) ^ Math.imul(bits[at + 1], 0x85ebca6b) ^
    Math.imul(bits[at + 2], 0xc2b2ae35);
  value ^= value >>> 15;
  return (value >>> 0) & (size - 1);
}

/** {positions, indices} of corners, three coordinates each, three corners a triangle. */
export function welded(name, corners) {
  const count = corners.length / 3;
  const size = 2 ** Math.ceil(Math.log2(2 * count + 2));
  const slots = new Int32Array(size).fill(-1);  // the vertex in each place of the table
  const positions = new Float32Array(corners.length);
  const indices = new Uint32Array(count);
  const [from, to] = [corners, positions].map((one) => new Int32Array(one.buffer));
  let vertices = 0;
  for (let c = 0; c < count; ++c) {
    let slot = hash(from, 3 * c, size);
    while (slots[slot] >= 0 && [0, 1, 2].some((axis) => to[3 * slots[slot] + axis] !== from[3 * c + axis])) {
      slot = (slot + 1) & (size - 1);
    }
    if (slots[slot] < 0) {
      slots[slot] = vertices;
      for (let axis = 0; axis < 3; ++axis) to[3 * vertices + axis] = from[3 * c + axis];
      checkCount(name, ++vertices);
    }
    indices[c] = slots[slot];
  }
  return { positions: positions.slice(0, 3 * vertices), indices };
}
