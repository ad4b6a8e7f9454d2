// Reads a value change dump (IEEE 1364, section 18) as far as the waveform needs it.
// SPDX-License-Identifier: Apache-2.0

/** {signals: [{name, width, changes: [[time, bits], ...]}], begin, end: the first and the last time} */
export function parseVcd(text) {
  const signals = new Map();
  let [time, begin] = [0, null];
  for (const line of text.split("\n")) {
    const variable = /^\s*\$var\s+\S+\s+(\d+)\s+(\S+)\s+(\S+)/.exec(line);
    if (variable) signals.set(variable[2], { name: variable[3], width: Number(variable[1]), changes: [] });
    else if (line[0] === "#") {
      time = Number(line.slice(1));
      begin ??= time;
    } else if (/^[01xz]/i.test(line)) signals.get(line.slice(1).trim())?.changes.push([time, line[0]]);
    else if (/^b/i.test(line)) {
      const [bits, code] = line.slice(1).trim().split(/\s+/);
      signals.get(code)?.changes.push([time, bits]);
    }
  }
  return { signals: [...signals.values()], begin: begin ?? 0, end: time };
}
