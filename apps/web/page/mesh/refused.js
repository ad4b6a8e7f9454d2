// Why a file is not taken: one sentence for the reader, and the bounds that files have here.
// SPDX-License-Identifier: Apache-2.0

export const MOST_VERTICES = 2_000_000;
export const MOST_BYTES = 256 * 1024 * 1024;

export class Refused extends Error {}

/** Refuses a mesh of too many vertices as soon as their number is known. */
export function checkCount(name, vertices) {
  if (vertices > MOST_VERTICES) {
    const millions = (value) => (value / 1e6).toLocaleString("en-US", { maximumFractionDigits: 1 });
    throw new Refused(`${name} has ${millions(vertices)} million vertices, and this page takes at most ` +
                      `${millions(MOST_VERTICES)} million: load a coarser one, or take the command hwffd.`);
  }
}
