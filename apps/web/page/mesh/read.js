// A mesh out of a file of the reader: by the ending of its name, with a sentence where it is none.
// SPDX-License-Identifier: Apache-2.0

import { MOST_BYTES, Refused, checkCount } from "./refused.js";
import { readObj } from "./obj.js";
import { readPly } from "./ply.js";
import { readStl } from "./stl.js";

const READERS = {
  obj: (name, bytes) => readObj(name, new TextDecoder().decode(bytes)),
  ply: readPly,
  stl: readStl,
};

function check(name, { positions, indices }) {
  const vertices = positions.length / 3;
  if (vertices === 0) throw new Refused(`${name} is no mesh: no vertex was found in it.`);
  if (indices.length === 0) throw new Refused(`${name} is no mesh: it has vertices, but no triangle joins them.`);
  checkCount(name, vertices);
  if (!positions.every(Number.isFinite)) {
    throw new Refused(`${name} is no mesh: a coordinate of a vertex is not a finite number.`);
  }
  if (!indices.every((index) => index < vertices)) {
    throw new Refused(`${name} is no mesh: a face names a vertex that it does not have.`);
  }
}

/**
 * {name, positions, indices} of a File.
 * @throws Refused, a sentence
 */
export async function readMesh(file) {
  const reader = READERS[file.name.split(".").at(-1).toLowerCase()];
  if (!reader) throw new Refused(`${file.name} is not read here: meshes are .obj, .stl or .ply, lattices .json.`);
  if (file.size > MOST_BYTES) {
    throw new Refused(`${file.name} is larger than ${MOST_BYTES >> 20} MB: load a coarser mesh.`);
  }
  const mesh = reader(file.name, await file.arrayBuffer());
  check(file.name, mesh);
  return { name: file.name, ...mesh };
}
