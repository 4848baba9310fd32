// Draws the charts of report.html, one after the other in the order of the page, and saves its data.
"use strict";
(() => {
  const views = new Map(); // of each drawn plot
  const specification = (id) => JSON.parse(document.getElementById(id).textContent);

  const options = (id) => ({
    mode: "vega-lite",
    renderer: "svg",
    ast: true, // interprets expressions: the page forbids eval
    actions: { export: { svg: true, png: true }, source: false, compiled: false, editor: false },
    downloadFileName: id,
    scaleFactor: 2,
  });

  async function drawCharts() {
    for (const plot of document.querySelectorAll("[data-chart]")) {
      const id = plot.dataset.chart;
      try {
        views.set(plot, (await vegaEmbed(plot, specification(id), options(id))).view);
        const menu = plot.querySelector("summary");
        if (menu) menu.setAttribute("aria-label", "Save this chart");
      } catch (error) {
        plot.textContent = `This chart cannot be drawn: ${error.message}`;
        console.error(id, error);
      }
    }
    document.documentElement.dataset.charts = "drawn";
  }

  // A chart made for the screen would be shrunk on paper, text and all: draw it in paper's size.
  function fitToPaper() {
    for (const [plot, view] of views) {
      view.signal("width", plot.closest(".scene-answer") ? 660 : 325).run();
    }
  }

  const fitToScreen = () => window.dispatchEvent(new Event("resize"));

  function saveResults() {
    const text = JSON.stringify(specification("results"), null, 1);
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([text], { type: "application/json" }));
    link.download = "results.json";
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  }

  const save = document.getElementById("save");
  save.hidden = false;
  save.addEventListener("click", saveResults);
  window.addEventListener("beforeprint", fitToPaper);
  window.addEventListener("afterprint", fitToScreen);
  drawCharts();
})();
