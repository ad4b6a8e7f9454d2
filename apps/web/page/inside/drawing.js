// The drawing of the core, as the engine made it of the elaborated design, lit by the signals of this clock.
// SPDX-License-Identifier: Apache-2.0

import { byId } from "../dom.js";

export class Drawing {
  open({ drawing, blocks }) {
    this.blocks = blocks;
    const parsed = new DOMParser().parseFromString(drawing, "image/svg+xml").documentElement;
    byId("drawing").replaceChildren(document.importNode(parsed, true));
    this.parts = blocks.map(({ id }) => byId(`block-${id}`));
    byId("lit").textContent = "";
  }

  /** @param busy  0 or 1 for each block */
  light(busy) {
    this.parts.forEach((part, at) => part?.classList.toggle("busy", busy[at] === 1));
    const names = this.blocks.filter((_, at) => busy[at] === 1).map(({ title }) => title);
    byId("lit").textContent = `Busy in this clock: ${names.join(", ") || "nothing"}.`;
  }
}
