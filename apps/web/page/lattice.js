// Lattice files of docs/lattice.md, section 3, and whether a lattice folds.
// SPDX-License-Identifier: Apache-2.0

import { Refused } from "./mesh/refused.js";

const ORDER = "point (i, j, k) is number (i*n_t + j)*n_u + k";
const ENTRIES = ["hwffd_lattice", "order", "dims", "points"];
const [FEWEST, MOST] = [4, 16];

/** The text of a lattice file. */
export function writeLattice({ dims, points }) {
  const triples = [];
  for (let p = 0; p < points.length; p += 3) triples.push(`[${[...points.subarray(p, p + 3)].join(", ")}]`);
  return `{\n"hwffd_lattice": 1,\n"order": "${ORDER}",\n"dims": [${[...dims].join(", ")}],\n` +
    `"points": [\n${triples.join(",\n")}\n]\n}\n`;
}

function parsed(name, text) {
  try {
    return JSON.parse(text);
  } catch {
    throw new Refused(`${name} is no lattice file: it is not JSON.`);
  }
}

/**
 * {dims, points} of the text of a lattice file.
 * @throws Refused, a sentence
 */
export function readLattice(name, text) {
  const file = parsed(name, text);
  const refuse = (why) => { throw new Refused(`${name} is no lattice file that this page takes: ${why}.`); };
  if (file === null || typeof file !== "object" || file.hwffd_lattice !== 1) refuse("it lacks \"hwffd_lattice\": 1");
  if ("shape" in file) refuse("it has a shape; let `hwffd lattice` write one with points");
  const unknown = Object.keys(file).find((entry) => !ENTRIES.includes(entry));
  if (unknown !== undefined) refuse(`its entry "${unknown}" is not known`);
  if (file.order !== undefined && file.order !== ORDER) refuse("its points are in another order");
  const { dims, points } = file;
  const fits = (n) => Number.isInteger(n) && n >= FEWEST && n <= MOST;
  if (!Array.isArray(dims) || dims.length !== 3 || !dims.every(fits)) {
    refuse(`its dims are not three numbers from ${FEWEST} to ${MOST}`);
  }
  const wanted = dims[0] * dims[1] * dims[2];
  if (!Array.isArray(points) || points.length !== wanted) refuse(`it does not have the ${wanted} points of its dims`);
  const isPoint = (one) => Array.isArray(one) && one.length === 3 && one.every(Number.isFinite);
  if (!points.every(isPoint)) refuse("a point is not three numbers");
  const places = new Float32Array(points.flat());
  if (!places.every(Number.isFinite)) refuse("a point is beyond what binary32 holds");
  return { dims, points: places };
}

const PLACES = [0, 0.25, 0.5, 0.75, 1];
const VALUES = PLACES.map((s) => [(1 - s) ** 3 / 6, (3 * s ** 3 - 6 * s ** 2 + 4) / 6,
  (-3 * s ** 3 + 3 * s ** 2 + 3 * s + 1) / 6, s ** 3 / 6]);
const SLOPES = PLACES.map((s) => [-((1 - s) ** 2) / 2, (3 * s ** 2 - 4 * s) / 2,
  (-3 * s ** 2 + 2 * s + 1) / 2, s ** 2 / 2]);

/** det J of the cell at three of the PLACES: the volume into which a small cube goes, negative inside out. */
function determinant(support, [a, b, c]) {
  const rows = [[SLOPES[a], VALUES[b], VALUES[c]], [VALUES[a], SLOPES[b], VALUES[c]],
    [VALUES[a], VALUES[b], SLOPES[c]]];
  const [s, t, u] = rows.map(([along, across, deep]) => {
    const sum = [0, 0, 0];
    for (let n = 0; n < 64; ++n) {
      const weight = along[n >> 4] * across[(n >> 2) & 3] * deep[n & 3];
      for (let axis = 0; axis < 3; ++axis) sum[axis] += weight * support[3 * n + axis];
    }
    return sum;
  });
  return s[0] * (t[1] * u[2] - t[2] * u[1]) - s[1] * (t[0] * u[2] - t[2] * u[0]) +
    s[2] * (t[0] * u[1] - t[1] * u[0]);
}

function supportOf({ dims, points }, [i, j, k]) {
  const support = new Float64Array(192);
  for (let n = 0; n < 64; ++n) {
    const at = ((i + (n >> 4)) * dims[1] + j + ((n >> 2) & 3)) * dims[2] + k + (n & 3);
    support.set(points.subarray(3 * at, 3 * at + 3), 3 * n);
  }
  return support;
}

function* triples([a, b, c]) {
  for (let i = 0; i < a; ++i) for (let j = 0; j < b; ++j) for (let k = 0; k < c; ++k) yield [i, j, k];
}

const MANY_CELLS = 200;  // of which corners and middles suffice, as they are small

/**
 * Looks at the sign of det J at 125 places of each cell, 27 of many: {cells, folded, first}, the number of cells, of
 * those with a place that is inside out, and the first of these. Between the places a fold may be missed.
 */
export function folds(lattice) {
  const counts = lattice.dims.map((n) => n - 3);
  const cells = counts[0] * counts[1] * counts[2];
  const places = [...triples([5, 5, 5])].filter((place) => cells < MANY_CELLS || place.every((at) => at % 2 === 0));
  let [folded, first] = [0, null];
  for (const cell of triples(counts)) {
    const support = supportOf(lattice, cell);
    for (const place of places) {
      if (determinant(support, place) >= 0) continue;
      folded += 1;
      first ??= cell;
      break;
    }
  }
  return { cells, folded, first };
}
