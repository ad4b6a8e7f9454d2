// The end of what was recorded as a waveform: levels for single bits, values in hexadecimal for wider ports.
// SPDX-License-Identifier: Apache-2.0

import { svg } from "../dom.js";

const [ROW, HIGH, LOW] = [24, 4, 18];
const LETTER = 6.6;
const CLOCK = 32;  // pixels

function hexadecimal(bits) {
  if (/[xz]/i.test(bits)) return "x";
  return BigInt(`0b${bits}`).toString(16);
}

/** [[begin, end, bits], ...] of a signal between two times. */
function stretches({ changes }, from, end) {
  const found = [];
  changes.forEach(([time, bits], at) => {
    const next = changes[at + 1]?.[0] ?? end;
    if (next > from && time < end) found.push([Math.max(time, from), Math.min(next, end), bits]);
  });
  return found;
}

function bitTrace(parts, x, y) {
  const level = (bits) => y + (bits === "1" ? HIGH : LOW);
  const steps = parts.map(([begin, end, bits], at) =>
    `${at === 0 ? "M" : "L"}${x(begin)} ${level(bits)}H${x(end)}`);
  return [svg("path", { class: "trace", d: steps.join("") })];
}

function wordTrace(parts, x, y) {
  return parts.flatMap(([begin, end, bits]) => {
    const [left, right] = [x(begin), x(end)];
    const edge = Math.min(3, (right - left) / 2);
    const middle = y + (HIGH + LOW) / 2;
    const shape = `M${left} ${middle}L${left + edge} ${y + HIGH}H${right - edge}L${right} ${middle}` +
      `L${right - edge} ${y + LOW}H${left + edge}Z`;
    const text = hexadecimal(bits);
    const fits = Math.floor((right - left - 8) / LETTER);
    const shown = text.length <= fits ? text : fits >= 3 ? `${text.slice(0, fits - 1)}…` : "";
    return [svg("path", { class: "trace", d: shape }), svg("text", { x: left + 5, y: y + LOW - 3.5 }, shown)];
  });
}

/** Times of a clock: what lies between two rises of the first signal, if that is the clock. */
function period({ name, changes }) {
  const rises = changes.filter(([, bits]) => bits === "1");
  return /clk$/.test(name) && rises.length > 1 ? rises[1][0] - rises[0][0] : 1;
}

/** Draws the last clocks into the element, as wide as it is. */
export function drawWaveform(place, { signals, begin, end }) {
  if (signals.length === 0) {
    place.replaceChildren();
    return;
  }
  const width = Math.max(280, place.clientWidth - 18);
  const left = Math.min(150, 12 + 6.4 * Math.max(...signals.map(({ name }) => name.length)));
  const clock = period(signals[0]);
  const clocks = Math.min(Math.max(8, Math.floor((width - left) / CLOCK)), Math.ceil((end - begin) / clock));
  const from = end - clock * clocks;
  const x = (time) => left + (width - left - 6) * (time - from) / Math.max(end - from, 1);
  const height = ROW * signals.length + 6;
  const picture = svg("svg", { viewBox: `0 0 ${width} ${height}`, width, height, role: "img",
    "aria-label": `The watched ports in the last ${clocks} clocks` });
  signals.forEach((signal, row) => {
    const parts = stretches(signal, from, end);
    picture.append(svg("text", { x: left - 6, y: ROW * row + 15, "text-anchor": "end" }, signal.name),
      ...(signal.width === 1 ? bitTrace : wordTrace)(parts, x, ROW * row));
  });
  place.replaceChildren(picture);
}
