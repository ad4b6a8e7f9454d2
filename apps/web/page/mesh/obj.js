// Wavefront OBJ: its lines `v x y z` and `f`, with polygons cut into fans; all else is skipped.
// SPDX-License-Identifier: Apache-2.0

import { Refused, checkCount } from "./refused.js";

function face(name, words, vertices) {
  return words.map((word) => {
    const given = parseInt(word, 10);
    const index = given < 0 ? vertices + given : given - 1;
    if (!(index >= 0 && index < vertices)) {
      throw new Refused(`${name} is no mesh: a face names vertex ${word}, which it does not have.`);
    }
    return index;
  });
}

/** {positions, indices} of the text of a file. */
export function readObj(name, text) {
  const positions = [];
  const indices = [];
  for (const line of text.split("\n")) {
    if (line.startsWith("v ") || line.startsWith("v\t")) {
      const words = line.trim().split(/\s+/);
      positions.push(Number(words[1]), Number(words[2]), Number(words[3]));
      checkCount(name, positions.length / 3);
    } else if (line.startsWith("f ") || line.startsWith("f\t")) {
      const corners = face(name, line.trim().split(/\s+/).slice(1), positions.length / 3);
      for (let k = 2; k < corners.length; ++k) indices.push(corners[0], corners[k - 1], corners[k]);
    }
  }
  return { positions: new Float32Array(positions), indices: new Uint32Array(indices) };
}
