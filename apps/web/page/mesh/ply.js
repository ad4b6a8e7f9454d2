// PLY, text and binary of either order of bytes: the vertices' x, y and z and the faces' lists of vertices.
// SPDX-License-Identifier: Apache-2.0

import { Refused, checkCount } from "./refused.js";

const FORMATS = ["ascii", "binary_little_endian", "binary_big_endian"];
const TYPES = {
  char: ["getInt8", 1], uchar: ["getUint8", 1], short: ["getInt16", 2], ushort: ["getUint16", 2],
  int: ["getInt32", 4], uint: ["getUint32", 4], float: ["getFloat32", 4], double: ["getFloat64", 8],
  int8: ["getInt8", 1], uint8: ["getUint8", 1], int16: ["getInt16", 2], uint16: ["getUint16", 2],
  int32: ["getInt32", 4], uint32: ["getUint32", 4], float32: ["getFloat32", 4], float64: ["getFloat64", 8],
};

/** Takes numbers one after the other from binary data. */
class Binary {
  constructor(bytes, at, little) {
    Object.assign(this, { view: new DataView(bytes), at, little });
  }

  next(type) {
    const [get, size] = TYPES[type];
    const value = this.view[get](this.at, this.little);  // beyond the end it throws
    this.at += size;
    return value;
  }
}

/** The same from text. */
class Words {
  constructor(text) {
    Object.assign(this, { words: text.split(/\s+/).filter((word) => word !== ""), at: 0 });
  }

  next() {
    if (this.at >= this.words.length) throw new RangeError("end");
    return Number(this.words[this.at++]);
  }
}

/** {format, elements: [{name, count, properties}], end: where the data begins} */
function header(name, bytes) {
  const text = new TextDecoder("latin1").decode(bytes.slice(0, 65536));
  const found = /^ply\r?\n[^]*?\nend_header[ \t]*\r?\n/.exec(text);
  if (!found) throw new Refused(`${name} is no PLY file: it lacks the lines from 'ply' to 'end_header'.`);
  const elements = [];
  let format = "";
  for (const line of found[0].split("\n")) {
    const words = line.trim().split(/\s+/);
    if (words[0] === "format") format = words[1];
    else if (words[0] === "element") elements.push({ name: words[1], count: Number(words[2]), properties: [] });
    else if (words[0] === "property") elements.at(-1)?.properties.push(property(name, words));
  }
  if (!FORMATS.includes(format)) throw new Refused(`${name} is no PLY file: its format is none of ${FORMATS.join(", ")}.`);
  return { format, elements, end: found[0].length };
}

function property(name, words) {
  const list = words[1] === "list";
  const types = list ? words.slice(2, 4) : [words[1]];
  if (types.some((type) => !Object.hasOwn(TYPES, type))) {
    throw new Refused(`${name} is no PLY file that this page reads: '${words.join(" ")}' is not known.`);
  }
  return { name: words.at(-1), type: types.at(-1), counted: list ? types[0] : null };
}

function readElement(source, element, take) {
  if (element.properties.length === 0) return;
  for (let n = 0; n < element.count; ++n) {
    for (const one of element.properties) {
      if (one.counted === null) {
        take(one.name, source.next(one.type), n);
        continue;
      }
      const values = Array.from({ length: source.next(one.counted) }, () => source.next(one.type));
      take(one.name, values, n);
    }
  }
}

function readElements(name, source, elements, vertices) {
  const positions = new Float32Array(3 * vertices);
  const indices = [];
  const takers = {
    vertex: (property, value, n) => {
      const axis = "xyz".indexOf(property);
      if (property.length === 1 && axis >= 0) positions[3 * n + axis] = value;
    },
    face: (property, corners) => {
      if (!/^vertex_ind(ex|ices)$/.test(property)) return;
      const wrong = corners.find((corner) => !(Number.isInteger(corner) && corner >= 0 && corner < vertices));
      if (wrong !== undefined) {
        throw new Refused(`${name} is no mesh: a face names vertex ${wrong}, which it does not have.`);
      }
      for (let k = 2; k < corners.length; ++k) indices.push(corners[0], corners[k - 1], corners[k]);
    },
  };
  for (const element of elements) readElement(source, element, takers[element.name] ?? (() => {}));
  return { positions, indices: new Uint32Array(indices) };
}

/** {positions, indices} of the bytes of a file. */
export function readPly(name, bytes) {
  const { format, elements, end } = header(name, bytes);
  const vertices = elements.find((element) => element.name === "vertex")?.count ?? 0;
  checkCount(name, vertices);
  const source = format === "ascii" ? new Words(new TextDecoder().decode(bytes.slice(end)))
    : new Binary(bytes, end, format === "binary_little_endian");
  try {
    return readElements(name, source, elements, vertices);
  } catch (error) {
    if (!(error instanceof RangeError)) throw error;
    throw new Refused(`${name} ends before the ${vertices} vertices and the faces that it promises.`);
  }
}
