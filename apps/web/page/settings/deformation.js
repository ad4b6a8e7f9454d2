// Which deformation of the whole lattice, and how much of it: the words of docs/lattice.md, section 6.
// SPDX-License-Identifier: Apache-2.0

import { byId, choices, number } from "../dom.js";

// Kind -> its amounts: from, to, step, the first one, and whether an axis may follow.
const KINDS = {
  "at rest": null,
  twist: { from: -180, to: 180, step: 1, first: 90, axis: true, unit: "degrees" },
  helix: { from: -360, to: 360, step: 1, first: 90, axis: true, unit: "degrees" },
  bend: { from: -180, to: 180, step: 1, first: 60, axis: true, unit: "degrees" },
  shear: { from: -1, to: 1, step: 0.01, first: 0.5, axis: false, unit: "of the height" },
  taper: { from: 0.1, to: 2, step: 0.01, first: 0.5, axis: true, unit: "times" },
  scale: { from: 0.25, to: 2, step: 0.01, first: 1.5, axis: false, unit: "times" },
  random: { from: 1, to: 100, step: 1, first: 1, axis: false, unit: "is the seed" },
};

export class DeformationChoice {
  constructor(shape) {
    this.shape = shape;
    choices(byId("kind"), Object.keys(KINDS).map((kind) => [kind, kind]));
    byId("kind").addEventListener("change", () => this.chosen());
    byId("axis").addEventListener("change", () => this.changed());
    byId("amount").addEventListener("input", () => this.changed());
    this.reset();
  }

  /** Back to rest, without asking for it. */
  reset() {
    byId("kind").value = "at rest";
    this.show();
  }

  show() {
    const kind = KINDS[byId("kind").value];
    byId("amount").disabled = kind === null;
    byId("axis").disabled = !kind?.axis;
    byId("amount-text").textContent = kind ? `${number(Number(byId("amount").value))} ${kind.unit}` : "";
  }

  chosen() {
    const kind = KINDS[byId("kind").value];
    if (kind) {
      const { from: min, to: max, step, first } = kind;
      Object.assign(byId("amount"), { min, max, step });
      byId("amount").value = first;
    }
    this.changed();
  }

  changed() {
    const kind = KINDS[byId("kind").value];
    const axis = kind?.axis && byId("axis").value !== "y" ? `:${byId("axis").value}` : "";
    this.show();
    this.shape(kind ? `${byId("kind").value}:${byId("amount").value}${axis}` : "");
  }
}
