// A table that its heads sort.
// SPDX-License-Identifier: Apache-2.0

import { element } from "../dom.js";

/** The value of a cell for sorting: a number where it is one, what is missing last. */
function sortable(text) {
  if (text === "-") return Infinity;
  const value = Number(text.replaceAll(",", ""));
  return Number.isNaN(value) ? text : value;
}

function compared(a, b) {
  if (typeof a === "string" && typeof b === "string") return a.localeCompare(b, "en", { numeric: true });
  return a < b ? -1 : a > b ? 1 : 0;
}

/** Shows {header: [text, ...], rows: [[text, ...], ...]}. */
export function showTable(table, { header, rows }) {
  const body = element("tbody");
  const heads = header.map((title, column) => {
    const button = element("button", { type: "button" }, title);
    const head = element("th", { scope: "col" }, button);
    button.addEventListener("click", () => {
      const down = head.getAttribute("aria-sort") === "ascending";
      heads.forEach((one) => one.removeAttribute("aria-sort"));
      head.setAttribute("aria-sort", down ? "descending" : "ascending");
      fill((a, b) => {
        const [x, y] = [sortable(a[column]), sortable(b[column])];
        if (x === Infinity || y === Infinity) return compared(x, y);
        return down ? compared(y, x) : compared(x, y);
      });
    });
    return head;
  });
  const fill = (order) => {
    const sorted = order ? [...rows].sort(order) : rows;
    body.replaceChildren(...sorted.map(([name, ...figures]) => element("tr", {},
      element("th", { scope: "row" }, name), ...figures.map((text) => element("td", { class: "figure" }, text)))));
  };
  fill(null);
  table.replaceChildren(element("thead", {}, element("tr", {}, ...heads)), body);
}
