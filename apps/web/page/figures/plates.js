// The plates of the paper as scenes: the model in its lattice, as the core's model has moved it.
// SPDX-License-Identifier: Apache-2.0

import { byId, choices, count } from "../dom.js";
import { Scene } from "../view/scene.js";

export class Plates {
  /** @param plates  [{title, deformation, view, triangles, positions, dims, points}], a number for each triple */
  constructor(plates, work) {
    Object.assign(this, { plates, work, scene: null });
    byId("plates").hidden = false;
    choices(byId("plate"), plates.map(({ title }, at) => [String(at), `${at + 1}: ${title}`]));
    byId("plate").addEventListener("change", () => this.show());
    byId("plate-live").addEventListener("click", () => this.deform());
    // Drawn when it is first seen: most of the work of a scene is done then.
    const seen = new IntersectionObserver((entries) => {
      if (!entries.some((entry) => entry.isIntersecting)) return;
      seen.disconnect();
      this.begin();
    });
    seen.observe(byId("plate-stage"));
  }

  begin() {
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

  mesh(positions) {
    return { name: this.plate.title, positions: new Float32Array(positions),
      indices: new Uint32Array(this.plate.triangles) };
  }

  show() {
    const { title, dims, points, positions, view, rest } = this.plate;
    byId("plate-text").textContent = `Plate ${Number(byId("plate").value) + 1}: ${title}, ` +
      `${count(positions.length / 3)} vertices in one cell of 64 control points.`;
    if (!this.scene) return;
    this.scene.setMesh(this.mesh(positions));
    this.scene.setLattice(dims, points);
    this.scene.look([...rest, ...points], view);
  }

  /** Takes the model, at rest, into the live core. */
  deform() {
    this.work.setMesh(this.mesh(this.plate.model));
    byId("work").scrollIntoView();
  }
}
