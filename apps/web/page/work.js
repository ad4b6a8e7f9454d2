// Deform: the mesh, its lattice and the core that carries it; settings, files and the picture.
// SPDX-License-Identifier: Apache-2.0

import { byId, choices, element } from "./dom.js";
import { folds } from "./lattice.js";
import { BUILT_IN } from "./mesh/built_in.js";
import { CoreChoice } from "./settings/core.js";
import { DeformationChoice } from "./settings/deformation.js";
import { Files } from "./settings/files.js";
import { PointFields } from "./settings/point.js";
import { PointControls } from "./view/points.js";
import { Scene } from "./view/scene.js";

const FIRST_DIMS = [5, 6, 5];
const NOTHING = { dims: [4, 4, 4], points: new Float32Array(0) };

export class Work {
  constructor(notice) {
    Object.assign(this, { notice, engine: null, mesh: null, lattice: NOTHING });
    this.makeView();
    this.core = new CoreChoice((core) => this.open(core));
    this.deformation = new DeformationChoice((text) => this.shape(text));
    this.fields = new PointFields(() => this.lattice, {
      choose: (index) => this.controls ? this.controls.choose(index) : this.chosen(index),
      move: (index, place) => { this.movePoint(index, place); this.tellFolds(); },
    });
    this.files = new Files(this, notice);
    this.offerMeshes();
    byId("mesh").addEventListener("change", () => this.setMesh(BUILT_IN[byId("mesh").value]()));
    byId("look").addEventListener("click", () => this.look());
    byId("rest").addEventListener("click", () => { this.deformation.reset(); this.shape(""); });
    for (const axis of [0, 1, 2]) byId(`dims-${axis}`).addEventListener("change", () => this.setDims());
  }

  /** The built-in meshes, and the one that is shown if it is another. */
  offerMeshes(shown = null) {
    const names = Object.keys(BUILT_IN);
    choices(byId("mesh"), names.map((name) => [name, name]));
    if (shown === null) return;
    if (!names.includes(shown)) byId("mesh").append(element("option", { disabled: true }, shown));
    byId("mesh").value = shown;
  }

  makeView() {
    try {
      this.scene = new Scene(byId("view"));
    } catch {
      this.scene = null;
      byId("view").hidden = true;
      byId("look").hidden = true;
      const text = byId("no-view");
      text.hidden = false;
      text.textContent = "This browser has no WebGL, so there is no picture here; the core, its figures and the " +
        "tables work without.";
      return;
    }
    this.controls = new PointControls(this.scene, () => this.lattice, {
      choose: (index) => this.chosen(index),
      move: (index, place) => this.movePoint(index, place),
      end: () => this.tellFolds(),
    });
  }

  /** What is done before the worker has cores is kept here, and sent then: without one it refuses a mesh. */
  connect(engine) {
    engine.on("ready", ({ cores }) => {
      this.engine = engine;
      this.core.offer(cores);
      this.sendDims(FIRST_DIMS);
      const first = this.mesh;
      this.mesh = BUILT_IN.amphora();  // what comes back if the worker refuses the one that was loaded before
      this.setMesh(first ?? this.mesh);
    });
    engine.on("error", ({ asked }) => {
      if (asked === "mesh" && this.before) this.setMesh(this.before);
    });
    engine.on("lattice", (lattice) => {
      if (!engine.hasNewerPoints()) this.takeLattice(lattice);
    });
    engine.on("deformed", ({ positions }) => {
      if (positions.length !== this.mesh?.positions.length) return;
      this.scene?.moveMesh(positions);
      if (!this.isNew) return;
      this.look();
      this.isNew = engine.isBusyWith("deformed");
    });
  }

  open(core) {
    this.engine?.send({ type: "open", core });
  }

  setMesh(mesh) {
    this.before = this.mesh;  // what comes back if the worker refuses the new one
    this.mesh = mesh;
    this.isNew = true;
    this.offerMeshes(mesh.name);
    this.scene?.setMesh(mesh);
    this.deformation.reset();
    this.engine?.forgetWaiting();
    this.engine?.send({ type: "mesh", positions: mesh.positions });
  }

  setDims() {
    const fields = [0, 1, 2].map((axis) => byId(`dims-${axis}`));
    for (const field of fields) field.value = Math.min(16, Math.max(4, Math.round(Number(field.value) || 4)));
    this.sendDims(fields.map((field) => Number(field.value)));
  }

  sendDims(dims) {
    this.isNew = true;
    this.deformation.reset();
    this.engine?.forgetWaiting();
    this.engine?.send({ type: "dims", dims });
  }

  shape(deformation) {
    this.engine?.sendNewest({ type: "shape", deformation });
  }

  /** A lattice from a file: the control points go where it has them. */
  setLattice({ dims, points }) {
    this.deformation.reset();
    this.engine?.forgetWaiting();
    const other = dims.some((n, axis) => n !== this.lattice.dims[axis]);
    if (other) this.engine?.send({ type: "dims", dims });
    this.engine?.send({ type: "points", points });
    this.takeLattice({ dims, points });
  }

  takeLattice({ dims, points }) {
    const same = dims.every((n, axis) => n === this.lattice.dims[axis]) &&
      points.length === this.lattice.points.length;
    this.lattice = { dims: [...dims], points: new Float32Array(points) };
    dims.forEach((n, axis) => { byId(`dims-${axis}`).value = n; });
    if (same) this.scene?.moveLattice(this.lattice.points);
    else this.scene?.setLattice(dims, this.lattice.points);
    if (!same) this.controls?.choose(null);
    this.fields.show();
    this.showChosen();
    this.tellFolds();
  }

  look() {
    if (this.lattice.points.length > 0) this.scene?.look(this.lattice.points);
  }

  chosen(index) {
    this.fields.choose(index);
    this.showChosen();
  }

  showChosen() {
    const index = this.controls?.chosen ?? null;
    this.scene?.choose(index === null ? null : this.lattice.points.subarray(3 * index, 3 * index + 3));
  }

  /** Unless another lattice is on its way. */
  movePoint(index, place) {
    if (["mesh", "dims"].includes(this.engine?.newestLattice)) return;
    this.lattice.points.set(place, 3 * index);
    this.scene?.moveLattice(this.lattice.points);
    this.fields.showSoon();
    this.showChosen();
    this.engine?.sendNewest({ type: "points", points: this.lattice.points.slice() });
  }

  tellFolds() {
    const found = folds(this.lattice);
    byId("folds").textContent = found.folded === 0 ? "" :
      `The lattice folds in ${found.folded} of its ${found.cells} cells, first in (${found.first.join(", ")}): the ` +
      "mesh turns inside out there.";
  }
}
