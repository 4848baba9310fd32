// Draws the charts of report.html, one after the other in the order of the page.

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

const narrowPlot = 480; // pixels

// Legends with fewer columns, of one where labels may be long.
function withNarrowLegends(part) {
  if (Array.isArray(part)) return part.map(withNarrowLegends);
  if (part === null || typeof part !== "object") return part;
  const copy = Object.entries(part).map(([key, value]) => {
    if (key !== "legend" || value === null) return [key, withNarrowLegends(value)];
    return [key, { ...value, columns: value.labelLimit > 300 ? 1 : 2 }];
  });
  return Object.fromEntries(copy);
}

function specificationFor(plot) {
  const chart = specification(plot.dataset.chart);
  if (plot.clientWidth >= narrowPlot) return chart;
  const { datasets, data, ...rest } = chart;
  return { ...withNarrowLegends(rest), ...(datasets && { datasets }), ...(data && { data }) };
}

export async function drawCharts() {
  for (const plot of document.querySelectorAll("[data-chart]")) {
    const id = plot.dataset.chart;
    try {
      views.set(plot, (await vegaEmbed(plot, specificationFor(plot), options(id))).view);
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
export function fitToPaper() {
  for (const [plot, view] of views) {
    view.signal("width", plot.closest(".scene-answer") ? 660 : 325).run();
  }
}

export const fitToScreen = () => window.dispatchEvent(new Event("resize"));
