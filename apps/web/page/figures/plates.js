// The plates of the paper as scenes: each model in its lattice, at rest and deformed, seen as the plates see it.
// SPDX-License-Identifier: Apache-2.0

import { byId, choices, count } from "../dom.js";
import { packedData } from "../embedded.js";
import { Scene } from "../view/scene.js";

/** The plates in the paper's order: of each subject first at rest, then deformed, from each side. */
function platesOf(subjects) {
  return subjects.flatMap((subject) => [["at rest", subject.rest], [subject.deformation, subject.deformed]]
    .flatMap(([pose, state]) => subject.views.map((view) => ({ subject, pose, state, view }))));
}

export class Plates {
  constructor(work) {
    Object.assign(this, { plates: [], work, scene: null });
    byId("plates").hidden = false;
    byId("plate").addEventListener("change", () => this.show());
    byId("plate-live").addEventListener("click", () => this.deform());
    // Unpacked and drawn when they come into sight.
    const seen = new IntersectionObserver((entries) => {
      if (!entries.some((entry) => entry.isIntersecting)) return;
      seen.disconnect();
      this.begin();
    }, { rootMargin: "400px" });
    seen.observe(byId("plates"));
  }

  async begin() {
    this.plates = platesOf(await packedData("plates"));
    choices(byId("plate"), this.plates.map(({ subject, pose }, at) =>
      [String(at), `${at + 1}: ${subject.model}, ${pose}`]));
    try {
      this.scene = new Scene(byId("plate-view"));
    } catch {
      byId("plate-stage").hidden = true;  // no WebGL, of which the first picture has told
    }
    this.show();
  }

  get plate() {
    return this.plates[Number(byId("plate").value)];
  }

  show() {
    const { subject, pose, state, view } = this.plate;
    byId("plate-text").textContent = `Plate ${Number(byId("plate").value) + 1}: ${subject.model}, ${pose}; ` +
      `${count(state.positions.length / 3)} vertices, one cell of 64 control points.`;
    if (!this.scene) return;
    const places = (numbers) => Float32Array.from(numbers, (number) => number * subject.step);
    const indices = new Uint32Array(subject.triangles);
    this.scene.setMesh({ positions: places(state.positions), indices });
    this.scene.setLattice(subject.dims, places(state.points));
    const both = [subject.rest, subject.deformed].flatMap(({ positions, points }) => [...positions, ...points]);
    this.scene.look(places(both), view);
  }

  /** Takes the model, at rest, into the live core. */
  deform() {
    if (this.plates.length === 0) return;
    const { subject } = this.plate;
    this.work.setMesh({ name: subject.model, indices: new Uint32Array(subject.triangles),
      positions: Float32Array.from(subject.rest.positions, (number) => number * subject.step) });
    byId("work").scrollIntoView();
  }
}
