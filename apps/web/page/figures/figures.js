// "Figures": tables and pictures from the project's reports, which the build has put into the page.
// SPDX-License-Identifier: Apache-2.0

import { byId } from "../dom.js";
import { data, hasPacked } from "../embedded.js";
import { Pareto } from "./pareto.js";
import { Plates } from "./plates.js";
import { showTable } from "./table.js";

export function showFigures(work) {
  const table = data("organizations");
  if (table) showTable(byId("organizations"), table);
  const cores = data("pareto");
  if (cores) new Pareto(cores);
  if (hasPacked("plates")) new Plates(work);
}
