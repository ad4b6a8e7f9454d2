// Short names for what the panels do with the document: find, make and fill elements.
// SPDX-License-Identifier: Apache-2.0

const SVG = "http://www.w3.org/2000/svg";

export const byId = (id) => document.getElementById(id);

function filled(made, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (value === true) made.setAttribute(name, "");
    else if (value !== false && value !== null) made.setAttribute(name, value);
  }
  made.append(...children);
  return made;
}

/** A new HTML element; attributes that are false or null are left out. */
export function element(tag, attributes = {}, ...children) {
  return filled(document.createElement(tag), attributes, children);
}

/** The same of a picture. */
export function svg(tag, attributes = {}, ...children) {
  return filled(document.createElementNS(SVG, tag), attributes, children);
}

/** Fills a list of choices, [[value, text], ...], and keeps the one that is chosen if it is still there. */
export function choices(select, options) {
  const chosen = select.value;
  select.replaceChildren(...options.map(([value, text]) => element("option", { value }, text)));
  if (options.some(([value]) => value === chosen)) select.value = chosen;
}

/** Hands text or bytes to the reader as a file. */
export function save(name, content, type) {
  const link = element("a", { download: name, href: URL.createObjectURL(new Blob([content], { type })) });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

/** A function that does what it is asked for last, at most once in so many milliseconds: figures that can be read. */
export function paced(does, pause = 120) {
  let timer = null;
  let waiting = null;
  const next = () => {
    timer = null;
    if (waiting === null) return;
    does(...waiting);
    waiting = null;
    timer = setTimeout(next, pause);
  };
  return (...given) => {
    waiting = given;
    if (timer === null) next();
  };
}

const whole = new Intl.NumberFormat("en-US", { maximumFractionDigits: 0 });
const short = new Intl.NumberFormat("en-US", { maximumSignificantDigits: 4 });

export const count = (value) => whole.format(value);
export const number = (value) => short.format(value);
