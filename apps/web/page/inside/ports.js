// The core's ports: their values in this clock, which of them are watched, and those as a waveform.
// SPDX-License-Identifier: Apache-2.0

import { byId, element, save } from "../dom.js";
import { parseVcd } from "./vcd.js";
import { drawWaveform } from "./waveform.js";

const WATCHED_FIRST = 8;
const PAUSE = 700;  // ms

export class Ports {
  constructor(engine) {
    Object.assign(this, { engine, waves: null, saving: false, drawn: -Infinity });
    engine.on("vcd", ({ text }) => this.take(text));
    byId("save-vcd").addEventListener("click", () => {
      this.saving = true;
      engine.send({ type: "vcd" });
    });
    new ResizeObserver(() => this.draw()).observe(byId("waveform"));
  }

  open(ports) {
    this.waves = null;
    byId("waveform").replaceChildren();
    this.rows = ports.map((port, at) => this.row(port, at < WATCHED_FIRST));
    byId("ports").tBodies[0].replaceChildren(...this.rows.map(({ line }) => line));
    this.watch();
  }

  row({ name, width, description }, watched) {
    const box = element("input", { type: "checkbox", "aria-label": `Watch ${name}`, checked: watched });
    box.addEventListener("change", () => this.watch());
    const value = element("td", {}, "-");
    const title = width > 1 ? `${name}[${width - 1}:0]` : name;
    const line = element("tr", {}, element("td", {}, box), element("th", { scope: "row" }, title), value,
      element("td", {}, description));
    return { name, box, value, line };
  }

  watch() {
    const ports = this.rows.filter(({ box }) => box.checked).map(({ name }) => name);
    this.engine.send({ type: "watch", ports });
  }

  /** While the clock runs, the waveform is asked for now and then: it is long. */
  show({ ports }, runs) {
    for (const { name, value } of this.rows ?? []) value.textContent = ports[name] || "-";
    const now = performance.now();
    if (this.engine.isBusyWith("vcd") || (runs && now < this.drawn + PAUSE)) return;
    this.drawn = now;
    this.engine.send({ type: "vcd" });
  }

  take(text) {
    if (this.saving) save("hwffd.vcd", text, "text/plain");
    this.saving = false;
    this.waves = parseVcd(text);
    this.draw();
  }

  draw() {
    if (this.waves) drawWaveform(byId("waveform"), this.waves);
  }
}
