// A headless Chromium for the tests, or the reason why there is none.

import { existsSync } from "node:fs";

const candidates = process.env.CHROMIUM
  ? [process.env.CHROMIUM]
  : ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"];

// A test that cannot run ends with the code that ctest is told to take for it.
function skip(reason) {
  console.error(`SKIPPED: the report is NOT tested in a browser: ${reason}`);
  process.exit(77);
}

export async function launchBrowser() {
  const executablePath = candidates.find(existsSync);
  if (executablePath === undefined) skip("no Chromium (Debian: chromium); run tools/setup --for checks");
  const playwright = await import("playwright-core").catch(() =>
    skip("playwright-core is not installed; run tools/setup --for checks"),
  );
  return playwright.chromium.launch({
    executablePath,
    // There is no graphics card: WebGL is drawn by the processor.
    args: ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
  });
}
