// report.html in a real browser: made by the program, opened from the disk, used as readers use it.
// Usage: COPPICE=path/to/coppice [SCREENSHOTS=folder] node report.mjs [report.html]
// Without a report one is made of a small scene. Ends with 77 if there is no browser.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, mkdtempSync, rmSync, statSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

import { launchBrowser } from "./browser.mjs";

const browser = await launchBrowser();
const work = mkdtempSync(join(tmpdir(), "coppice-report-"));
const screenshots = resolve(process.env.SCREENSHOTS ?? join(work, "screenshots"));
mkdirSync(screenshots, { recursive: true });

function makeReport() {
  const coppice = (...words) => execFileSync(process.env.COPPICE, words, { cwd: work, stdio: "ignore" });
  coppice("generate", "spheres", "--triangles", "3000", "-o", "balls.ply");
  coppice("experiment", "balls.ply", "--rates", "100,50,10", "--seeds", "2", "--tolerance", "20", "--out", "out");
  return join(work, "out", "report.html");
}

const report = process.argv[2] ?? makeReport();

// Opens the report and collects all that goes wrong on the page.
async function openReport(options, prepare = async () => {}) {
  const page = await browser.newPage(options);
  page.complaints = [];
  page.on("console", (message) => {
    const isOurs = /willReadFrequently/.test(message.text()); // the tests read canvases, not the page
    if (["error", "warning"].includes(message.type()) && !isOurs) page.complaints.push(message.text());
  });
  page.on("pageerror", (error) => page.complaints.push(String(error)));
  page.on("request", (request) => {
    if (!/^(file|data|blob):/.test(request.url())) page.complaints.push(`asks for ${request.url()}`);
  });
  await prepare(page);
  await page.goto(pathToFileURL(report).href);
  await page.waitForSelector("html[data-charts=drawn]", { state: "attached" });
  return page;
}

const photograph = (page, name) => page.screenshot({ path: join(screenshots, `${name}.png`) });

const checks = [];
const check = (name, run) => checks.push({ name, run });

check("is under 8 MB", () => assert.ok(statSync(report).size < 8e6));

check("shows picture, answer and main chart on the first screen", async (page) => {
  for (const selector of ["p.answer", ".picture img", ".scene-answer .plot svg"]) {
    const box = await page.locator(selector).first().boundingBox();
    assert.ok(box.height > 20 && box.y + box.height <= 800, `${selector}: ${JSON.stringify(box)}`);
  }
  assert.ok(await page.locator(".picture img").first().evaluate((image) => image.naturalWidth > 100));
});

check("draws every chart", async (page) => {
  const drawn = await page.locator("[data-chart]").evaluateAll((plots) =>
    plots.map((plot) => [plot.dataset.chart, plot.querySelectorAll("svg path").length]),
  );
  assert.ok(drawn.length >= 15);
  for (const [id, marks] of drawn) assert.ok(marks > 5, `${id} has ${marks} marks`);
});

check("tells of a point in a tooltip", async (page) => {
  await page.locator(".scene-answer .plot .mark-symbol path").first().hover({ force: true });
  await page.locator("#vg-tooltip-element.visible").waitFor();
  assert.match(await page.locator("#vg-tooltip-element").innerText(), /SAH cost/);
});

check("sorts tables by mouse and keyboard", async (page) => {
  const table = page.locator("table.rows").first();
  const button = table.getByRole("button", { name: "total" });
  const heading = button.locator("xpath=..");
  const totals = async () => {
    const column = await heading.evaluate((cell) => [...cell.parentNode.cells].indexOf(cell));
    const texts = await table.locator(`tbody tr > :nth-child(${column + 1})`).allInnerTexts();
    return texts.map((text) => Number.parseFloat(text.replace(/[<,]/g, "")));
  };
  const isRising = (numbers) => numbers.every((number, i) => i === 0 || numbers[i - 1] <= number);
  const asWritten = await totals();
  assert.ok(!isRising(asWritten));
  await button.click();
  assert.equal(await heading.getAttribute("aria-sort"), "ascending");
  assert.ok(isRising(await totals()));
  await page.keyboard.press("Enter");
  assert.equal(await heading.getAttribute("aria-sort"), "descending");
  assert.ok(isRising((await totals()).reverse()));
  await page.keyboard.press("Space");
  assert.equal(await heading.getAttribute("aria-sort"), "none");
  assert.deepEqual(await totals(), asWritten);
});

// The pixels of each of the inspector's canvases as one number, and how many colours they have.
const lookAt = (page) =>
  page.locator(".inspector canvas").evaluateAll((canvases) =>
    canvases.map((canvas) => {
      const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
      const colours = new Set();
      let hash = 0;
      for (const pixel of new Uint32Array(data.buffer)) {
        colours.add(pixel);
        hash = (Math.imul(hash, 31) + pixel) | 0;
      }
      return { hash, colours: colours.size };
    }),
  );

// Does something that must change both views.
async function mustChange(page, what, act) {
  const before = await lookAt(page);
  await act();
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  const after = await lookAt(page);
  after.forEach((view, i) => assert.notEqual(view.hash, before[i].hash, `${what}: view ${i}`));
}

check("draws two trees and follows slider, colours, mouse and keys", async (page) => {
  await page.locator(".inspector").first().scrollIntoViewIfNeeded();
  await page.locator(".inspector[data-drawn]").waitFor();
  const views = await lookAt(page);
  assert.equal(views.length, 2);
  for (const view of views) assert.ok(view.colours > 50, `${view.colours} colours`);
  const slider = page.locator(".inspector [name=level]");
  const level = Number(await slider.inputValue());
  await slider.focus();
  await mustChange(page, "slider", () => page.keyboard.press("ArrowLeft"));
  assert.equal(await page.locator(".inspector output").innerText(), String(level - 1));
  assert.match(await page.locator(".inspector .readout").first().innerText(), new RegExp(`Level ${level - 1} has \\d`));
  await page.keyboard.press("ArrowRight");
  await mustChange(page, "colour", () => page.locator("[name=colour]").selectOption("counts"));
  await mustChange(page, "scene", () => page.locator("[name=scene]").uncheck());
  await mustChange(page, "scene again", () => page.locator("[name=scene]").check());
  const canvas = page.locator(".inspector canvas").last();
  await mustChange(page, "key", async () => {
    await canvas.focus();
    await page.keyboard.press("ArrowRight");
  });
  await mustChange(page, "mouse", async () => {
    const { x, y } = await page.locator(".inspector canvas").first().boundingBox();
    await page.mouse.move(x + 100, y + 100);
    await page.mouse.down();
    await page.mouse.move(x + 160, y + 120, { steps: 3 });
    await page.mouse.up();
  });
  await mustChange(page, "reset", () => page.locator("[name=reset]").click());
});

check("takes the reader's colours", async (page) => {
  const ground = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const light = await ground();
  await photograph(page, "light-inspector");
  await mustChange(page, "dark", () => page.emulateMedia({ colorScheme: "dark" }));
  assert.notEqual(await ground(), light);
  await photograph(page, "dark-inspector");
  await page.evaluate(() => window.scrollTo(0, 0));
  await photograph(page, "dark");
  await page.emulateMedia({ colorScheme: "light" });
  await photograph(page, "light");
});

check("fits a narrow screen", async (page) => {
  await page.setViewportSize({ width: 390, height: 800 });
  await page.waitForTimeout(300);
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth));
  await photograph(page, "narrow");
  await page.setViewportSize({ width: 1280, height: 800 });
});

check("prints", async (page) => {
  const pdf = await page.pdf({ path: join(screenshots, "print.pdf"), format: "A4" });
  assert.ok(pdf.length > 50_000);
});

check("leaves nothing to complain of", (page) => assert.deepEqual(page.complaints, []));

async function withoutWebGl() {
  const page = await openReport({ viewport: { width: 1280, height: 800 } }, (fresh) =>
    fresh.addInitScript(() => {
      const original = HTMLCanvasElement.prototype.getContext;
      HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
        return kind.startsWith("webgl") ? null : original.call(this, kind, ...rest);
      };
    }),
  );
  assert.match(await page.locator(".inspector .message").innerText(), /needs WebGL 2/);
  assert.deepEqual(page.complaints, []);
}

let failed = 0;
try {
  const page = await openReport({ viewport: { width: 1280, height: 800 } });
  check("says so where there is no WebGL", withoutWebGl);
  for (const { name, run } of checks) {
    const start = performance.now();
    const error = await Promise.resolve(page).then(run).then(() => null, (reason) => reason);
    console.log(`${error === null ? "ok" : "FAILED"}: the report ${name} (${Math.round(performance.now() - start)} ms)`);
    if (error !== null) {
      console.log(error.stack);
      failed += 1;
    }
  }
} finally {
  await browser.close();
  rmSync(work, { recursive: true, force: true });
}
process.exitCode = failed === 0 ? 0 : 1;
