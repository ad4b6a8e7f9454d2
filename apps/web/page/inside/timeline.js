// The last clocks as lanes, in the form of the pictures of `make organizations`: a row for each unit, a colour for
// each vertex.
// SPDX-License-Identifier: Apache-2.0

import { svg } from "../dom.js";

const [ROW, BAR, TOP] = [17, 13, 4];
const COLOURS = 4;

/** [begin, end, vertex] of each run in which the last operation to enter is of one vertex. */
export function runs(spans, clocks) {
  const busy = new Array(clocks).fill(null);
  for (const [begin, end, vertex] of spans) busy.fill(vertex, begin, end);
  const found = [];
  busy.forEach((vertex, clock) => {
    if (vertex === null) return;
    const last = found.at(-1);
    if (last && last[1] === clock && last[2] === vertex) last[1] = clock + 1;
    else found.push([clock, clock + 1, vertex]);
  });
  return found;
}

/** Clocks for the marks below, some `most` of them at round numbers. */
function marks(first, clocks, most) {
  const step = [1, 2, 5, 10, 20, 25, 50, 100].find((one) => clocks / one <= most) ?? 200;
  const found = [];
  for (let clock = Math.ceil(first / step) * step; clock <= first + clocks; clock += step) found.push(clock);
  return found;
}

/** Draws into the element, as wide as it is. */
export function drawTimeline(place, { first_clock: first, clocks, lanes }) {
  const width = Math.max(280, place.clientWidth - 18);
  const left = Math.min(150, 12 + 6.4 * Math.max(...lanes.map(({ name }) => name.length), 4));
  const height = TOP + ROW * lanes.length + 22;
  const x = (clock) => left + (width - left - 16) * clock / Math.max(clocks, 1);
  const picture = svg("svg", { viewBox: `0 0 ${width} ${height}`, width, height, role: "img",
    "aria-label": `Busy units in clocks ${first} to ${first + clocks}` });
  for (const clock of marks(first, clocks, width / 75)) {
    const at = x(clock - first);
    picture.append(svg("line", { class: "grid", x1: at, x2: at, y1: TOP, y2: height - 18 }),
      svg("text", { x: at, y: height - 5, "text-anchor": "middle" }, String(clock)));
  }
  lanes.forEach(({ name, spans }, row) => {
    const y = TOP + ROW * row;
    picture.append(svg("text", { x: left - 6, y: y + BAR - 2, "text-anchor": "end" }, name));
    for (const [begin, end, vertex] of runs(spans, clocks)) {
      picture.append(svg("rect", { class: `v${vertex % COLOURS}`, x: x(begin), y, height: BAR,
        width: Math.max(0.5, x(end) - x(begin)) }));
    }
  });
  place.replaceChildren(picture);
}
