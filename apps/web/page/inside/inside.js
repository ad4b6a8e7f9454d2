// "See inside": the clock is stepped by hand or runs slowly, and what the core does in it is shown.
// SPDX-License-Identifier: Apache-2.0

import { byId, count, number } from "../dom.js";
import { Drawing } from "./drawing.js";
import { Ports } from "./ports.js";
import { drawTimeline } from "./timeline.js";

const SPEEDS = [1, 2, 5, 10, 30, 100, 1000, 10000];  // clocks per second
const PICTURES = 10;  // per second, at most

export class Inside {
  constructor(engine, work) {
    Object.assign(this, { engine, work, state: null, timer: null, shown: 0 });
    this.drawing = new Drawing();
    this.ports = new Ports(engine);
    engine.on("opened", (opened) => this.opened(opened));
    engine.on("state", (state) => this.show(state));
    engine.on("busy", () => byId("inside").setAttribute("aria-busy", engine.isBusyWith("state")));
    byId("run").addEventListener("click", () => this.toggle());
    byId("step-clock").addEventListener("click", () => this.step({ clocks: 1 }));
    byId("step-vertex").addEventListener("click", () => this.step({ vertex: true }));
    byId("speed").addEventListener("input", () => this.showSpeed());
    new ResizeObserver(() => this.drawTimeline()).observe(byId("timeline"));
    this.showSpeed();
  }

  opened(opened) {
    this.halt();
    this.state = null;
    this.drawing.open(opened);
    this.ports.open(opened.ports);
    const core = this.work.core.current;
    byId("formula").textContent = core ? formulaOf(core) : "-";
    byId("timeline").replaceChildren();
    for (const id of ["clock", "vertices", "mismatches", "rate", "per-vertex"]) byId(`inside-${id}`).textContent = "-";
  }

  step(how) {
    this.halt();
    this.engine.send({ type: "inside", ...how });
  }

  /** Asks for the next state unless one is on its way. */
  advance(clocks) {
    if (!this.engine.isBusyWith("state")) this.engine.send({ type: "inside", clocks });
  }

  get speed() {
    return SPEEDS[Number(byId("speed").value)];
  }

  showSpeed() {
    byId("speed-text").textContent = count(this.speed);
    if (this.timer !== null) this.run();
  }

  toggle() {
    if (this.timer === null) this.run();
    else this.halt();
  }

  run() {
    clearInterval(this.timer);
    const pictures = Math.min(this.speed, PICTURES);
    this.timer = setInterval(() => this.advance(this.speed / pictures), 1000 / pictures);
    byId("run").setAttribute("aria-pressed", "true");
    byId("run").textContent = "Pause";
  }

  halt() {
    clearInterval(this.timer);
    if (this.timer !== null && this.state) this.engine.send({ type: "vcd" });
    this.timer = null;
    byId("run").setAttribute("aria-pressed", "false");
    byId("run").textContent = "Run";
  }

  show(state) {
    this.showRate(state.vertices);
    this.state = state;
    byId("inside-clock").textContent = count(state.clock);
    byId("inside-vertices").textContent = count(state.vertices);
    byId("inside-mismatches").textContent = count(state.mismatches);
    byId("inside-mismatches").classList.toggle("wrong", state.mismatches > 0);
    byId("inside-per-vertex").textContent = perVertex(state.timeline);
    this.drawing.light(state.busy);
    this.ports.show(state, this.timer !== null);
    this.drawTimeline();
  }

  /** How fast the clock really goes; where it stands, none. */
  showRate(vertices) {
    const now = performance.now();
    const passed = vertices - (this.state?.vertices ?? vertices);
    byId("inside-rate").textContent = this.timer === null ? "-" : number(1000 * passed / (now - this.shown));
    this.shown = now;
  }

  drawTimeline() {
    if (this.state) drawTimeline(byId("timeline"), this.state.timeline);
  }
}

/** The formula of the clocks per vertex, and its value unless it is that already. */
function formulaOf({ formula, formula_clocks: clocks }) {
  return formula === String(clocks) ? formula : `${formula}: ${number(clocks)}`;
}

/** Clocks from vertex to vertex, counted where the last lane begins to work on each. */
function perVertex({ lanes }) {
  const begins = new Map();
  for (const [begin, , vertex] of lanes.at(-1)?.spans ?? []) {
    if (!begins.has(vertex)) begins.set(vertex, begin);
  }
  const clocks = [...begins.values()];
  if (clocks.length < 2) return "-";
  return number((clocks.at(-1) - clocks[0]) / (clocks.length - 1));
}
