// STL, text and binary. Its triangles have corners of their own, which are joined where they lie in one place.
// SPDX-License-Identifier: Apache-2.0

import { Refused } from "./refused.js";
import { welded } from "./weld.js";

const HEADER = 84;
const TRIANGLE = 50;

function isBinary(bytes) {
  if (bytes.byteLength < HEADER) return false;
  const triangles = new DataView(bytes).getUint32(80, true);
  return HEADER + TRIANGLE * triangles === bytes.byteLength;
}

function binaryCorners(bytes) {
  const view = new DataView(bytes);
  const triangles = view.getUint32(80, true);
  const corners = new Float32Array(9 * triangles);
  for (let t = 0; t < triangles; ++t) {
    for (let k = 0; k < 9; ++k) corners[9 * t + k] = view.getFloat32(HEADER + TRIANGLE * t + 12 + 4 * k, true);
  }
  return corners;
}

function textCorners(name, text) {
  const corners = [];
  for (const line of text.split("\n")) {
    const words = line.trim().split(/\s+/);
    if (words[0] === "vertex") corners.push(Number(words[1]), Number(words[2]), Number(words[3]));
  }
  if (corners.length === 0 || corners.length % 9 !== 0) {
    throw new Refused(`${name} is no STL file: it is neither the text of triangles nor as long as its count says.`);
  }
  return new Float32Array(corners);
}

/** {positions, indices} of the bytes of a file. */
export function readStl(name, bytes) {
  const corners = isBinary(bytes) ? binaryCorners(bytes) : textCorners(name, new TextDecoder().decode(bytes));
  return welded(name, corners);
}
