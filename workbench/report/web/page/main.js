// What report.html does in a browser, but for its tree inspector.

import { drawCharts, fitToPaper, fitToScreen } from "./charts.js";
import { makeSortable } from "./tables.js";

function saveResults() {
  const results = JSON.parse(document.getElementById("results").textContent);
  const text = JSON.stringify(results, null, 1);
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([text], { type: "application/json" }));
  link.download = "results.json";
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

const save = document.getElementById("save");
save.hidden = false;
save.addEventListener("click", saveResults);
document.querySelectorAll("table.sortable").forEach(makeSortable);
window.addEventListener("beforeprint", fitToPaper);
window.addEventListener("afterprint", fitToScreen);
drawCharts();
