// The panel "RTL against model": what the last run of the mesh through the core counted.
// SPDX-License-Identifier: Apache-2.0

import { byId, count, number, paced } from "./dom.js";

const hexadecimal = (word) => `0x${word.toString(16).padStart(8, "0")}`;

export class Comparison {
  constructor(engine) {
    this.engine = engine;
    engine.on("deformed", paced((run) => this.show(run)));
    engine.on("busy", () => byId("compare").setAttribute("aria-busy", engine.isBusyWith("deformed")));
    this.button = byId("fault");
    this.button.addEventListener("click", () => this.toggleFault());
  }

  show(run) {
    byId("vertices").textContent = count(run.vertices);
    byId("words").textContent = count(run.words);
    byId("clocks").textContent = count(run.clocks);
    byId("clocks-per-vertex").textContent = number(run.clocks_per_vertex);
    byId("rate").textContent = count(run.vertices / run.seconds);
    byId("saturated").textContent = count(run.saturated);
    byId("mismatches").textContent = count(run.mismatches);
    byId("verdict").dataset.state = run.mismatches === 0 ? "equal" : "differ";
    this.say(run);
  }

  /** Only what differs from the text that stands there, since each change is read aloud. */
  say({ mismatches, first, words }) {
    let text = "words differ: every bit is as the model has it";
    if (mismatches > 0) {
      text = `of ${count(words)} words differ from the model`;
      if (first) text += `; the first is word ${first.word} of vertex ${first.vertex}: ${hexadecimal(first.rtl)}, not ${hexadecimal(first.model)}`;
    }
    const place = byId("verdict-text");
    if (place.textContent !== text) place.textContent = text;
  }

  toggleFault() {
    const on = this.button.getAttribute("aria-pressed") !== "true";
    this.button.setAttribute("aria-pressed", String(on));
    this.button.textContent = on ? "Remove the fault" : "Plant a fault";
    this.engine.send({ type: "fault", on });
  }
}
