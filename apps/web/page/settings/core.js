// Which core: organization and format, of those that the worker has.
// SPDX-License-Identifier: Apache-2.0

import { byId, choices } from "../dom.js";

const FIRST = "factored";

export class CoreChoice {
  constructor(open) {
    Object.assign(this, { open, cores: [], current: null });
    byId("organization").addEventListener("change", () => this.chosen());
    byId("format").addEventListener("change", () => this.chosen());
  }

  /** Shows what there is, and opens the first choice. */
  offer(cores) {
    this.cores = cores;
    const names = [...new Set(cores.map(label))];
    choices(byId("organization"), names.map((name) => [name, name]));
    if (names.includes(FIRST)) byId("organization").value = FIRST;
    this.chosen();
  }

  chosen() {
    const fitting = this.cores.filter((core) => label(core) === byId("organization").value);
    choices(byId("format"), fitting.map((core) => [core.format, core.format]));
    this.current = fitting.find((core) => core.format === byId("format").value);
    this.open(this.current.name);
  }
}

/** The organization as the tables call it. */
function label(core) {
  return core.org;
}
