// Vertices per second against size, each dot a core: docs/pareto.svg, to point at and to filter by format.
// SPDX-License-Identifier: Apache-2.0

import { byId, count, element, number, svg } from "../dom.js";

const HEIGHT = 330;
const EDGE = { left: 58, right: 14, top: 10, bottom: 34 };

// One picture of the cores that have been routed, by the second, and one of all, by the clock.
const PANELS = [
  { title: "Routed: vertices per second", rate: (core) => core.per_second },
  { title: "Mapped: vertices per clock cycle", rate: (core) => 1 / core.interval },
];

/** Those that no other beats in size and rate, by size. */
export function front(cores, rate) {
  const beats = (a, b) => a.size <= b.size && rate(a) >= rate(b) && (a.size < b.size || rate(a) > rate(b));
  return cores.filter((one) => !cores.some((other) => beats(other, one))).sort((a, b) => a.size - b.size);
}

/** Powers of ten between two values, with 2 and 5 where they are few. */
function ticks(low, high) {
  const factors = Math.log10(high / low) > 2.2 ? [1] : [1, 2, 5];
  const found = [];
  for (let power = Math.floor(Math.log10(low)); power <= Math.log10(high); ++power) {
    for (const factor of factors) found.push(factor * 10 ** power);
  }
  return found.filter((value) => value >= low && value <= high);
}

function scale(values, from, to) {
  const [low, high] = [Math.min(...values) / 1.25, Math.max(...values) * 1.25];
  const at = (value) => from + (to - from) * Math.log(value / low) / Math.log(high / low);
  return { at, ticks: ticks(low, high) };
}

const compact = new Intl.NumberFormat("en-US", { notation: "compact", maximumSignificantDigits: 3 });

export class Pareto {
  constructor(cores) {
    this.cores = cores;
    const formats = [...new Set(cores.map((core) => core.format))].sort();
    this.boxes = formats.map((format) => {
      const box = element("input", { type: "checkbox", checked: true, value: format });
      box.addEventListener("change", () => this.draw());
      byId("pareto-formats").append(element("label", {}, box, ` ${format}`));
      return box;
    });
    this.figures = PANELS.map((panel) => {
      const place = element("div", { class: "sheet" });
      byId("pareto").append(element("figure", {}, element("figcaption", {}, panel.title), place));
      return { ...panel, place };
    });
    new ResizeObserver(() => this.draw()).observe(byId("pareto"));
    this.draw();
  }

  draw() {
    const formats = new Set(this.boxes.filter((box) => box.checked).map((box) => box.value));
    const shown = this.cores.filter((core) => formats.has(core.format));
    for (const figure of this.figures) this.drawPanel(figure, shown.filter((core) => figure.rate(core) !== null));
  }

  drawPanel({ title, rate, place }, cores) {
    if (cores.length === 0) {
      place.replaceChildren(element("p", { class: "hint" }, "None of these formats."));
      return;
    }
    const width = Math.max(260, place.clientWidth - 18);
    const x = scale(cores.map((core) => core.size), EDGE.left, width - EDGE.right);
    const y = scale(cores.map(rate), HEIGHT - EDGE.bottom, EDGE.top);
    const picture = svg("svg", { viewBox: `0 0 ${width} ${HEIGHT}`, width, height: HEIGHT, role: "group",
      "aria-label": `${title}, against LUTs` });
    drawAxes(picture, x, y, width);
    const best = front(cores, rate);
    picture.append(svg("polyline", { class: "front",
      points: best.map((core) => `${x.at(core.size)},${y.at(rate(core))}`).join(" ") }));
    picture.append(...labels(best, x, y, rate, width));
    const others = cores.filter((core) => !best.includes(core));
    for (const core of [...others, ...best]) {
      picture.append(this.dot(core, x.at(core.size), y.at(rate(core)), best.includes(core)));
    }
    place.replaceChildren(picture);
  }

  dot(core, cx, cy, best) {
    const text = said(core);
    const dot = svg("circle", { class: best ? "core best" : "core", cx, cy, r: best ? 5 : 3.5, role: "img",
      tabindex: best ? 0 : null, "aria-label": text, "data-core": core.name });
    for (const event of ["pointerenter", "focus"]) {
      dot.addEventListener(event, () => { byId("pareto-text").textContent = text; });
    }
    return dot;
  }
}

/** Names of the best, above them to the left, or right of the first; where they would meet, the second is left out. */
function labels(best, x, y, rate, width) {
  const taken = [];
  return best.flatMap((core) => {
    const [right, below] = [x.at(core.size) - 8, y.at(rate(core)) - 6];
    const long = 6.2 * core.label.length;
    const left = right - long < EDGE.left ? right + 16 : right - long;
    if (left + long > width || taken.some((one) => Math.abs(one.below - below) < 13 && one.left < left + long &&
        left < one.left + one.long)) return [];
    taken.push({ left, below, long });
    return [svg("text", { x: left, y: below }, core.label)];
  });
}

function drawAxes(picture, x, y, width) {
  for (const value of x.ticks) {
    const at = x.at(value);
    picture.append(svg("line", { class: "grid", x1: at, x2: at, y1: EDGE.top, y2: HEIGHT - EDGE.bottom }),
      svg("text", { x: at, y: HEIGHT - EDGE.bottom + 14, "text-anchor": "middle" }, compact.format(value)));
  }
  for (const value of y.ticks) {
    const at = y.at(value);
    picture.append(svg("line", { class: "grid", x1: EDGE.left, x2: width - EDGE.right, y1: at, y2: at }),
      svg("text", { x: EDGE.left - 6, y: at + 4, "text-anchor": "end" }, compact.format(value)));
  }
  picture.append(svg("text", { x: width - EDGE.right, y: HEIGHT - 4, "text-anchor": "end" }, "LUTs"));
}

function said(core) {
  const clock = core.clock_mhz === null ? "not routed" :
    `${number(core.clock_mhz)} MHz, ${number(core.per_second / 1e6)} million vertices per second`;
  const multipliers = core.multipliers === null ? "" : `, ${count(core.multipliers)} multipliers`;
  return `${core.label}: ${count(core.size)} LUTs${multipliers}, ${number(core.interval)} cycles per vertex, ${clock}.`;
}
