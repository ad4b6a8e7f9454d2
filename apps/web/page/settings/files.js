// Files of the reader, by button or dropped on the page: meshes and lattices; and the lattice as a file.
// SPDX-License-Identifier: Apache-2.0

import { byId, save } from "../dom.js";
import { readLattice, writeLattice } from "../lattice.js";
import { readMesh } from "../mesh/read.js";
import { Refused } from "../mesh/refused.js";

export class Files {
  constructor(work, notice) {
    Object.assign(this, { work, notice });
    for (const id of ["mesh-file", "lattice-file"]) {
      byId(id).addEventListener("change", () => this.chosen(byId(id)));
    }
    byId("save-lattice").addEventListener("click", () => {
      save("lattice.json", writeLattice(work.lattice), "application/json");
    });
    this.acceptDrops();
  }

  chosen(input) {
    if (input.files.length > 0) this.take(input.files[0]);
    input.value = "";  // so that the same file may be chosen again
  }

  acceptDrops() {
    const hint = byId("drop");
    addEventListener("dragover", (event) => {
      event.preventDefault();
      hint.hidden = false;
    });
    addEventListener("dragleave", (event) => { hint.hidden = event.relatedTarget === null; });
    addEventListener("drop", (event) => {
      event.preventDefault();
      hint.hidden = true;
      if (event.dataTransfer.files.length > 0) this.take(event.dataTransfer.files[0]);
    });
  }

  async take(file) {
    this.notice.clear();
    try {
      if (file.name.toLowerCase().endsWith(".json")) {
        this.work.setLattice(readLattice(file.name, await file.text()));
      } else {
        this.work.setMesh(await readMesh(file));
      }
    } catch (error) {
      if (!(error instanceof Refused)) throw error;
      this.notice.say(error.message);
    }
  }
}
