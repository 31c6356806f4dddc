// Everything fits at all sizes, is hit by a finger, can be read, and axe finds nothing. Tests look at what differs most;
// `make fit` looks at all views of all worlds at all sizes, in light and dark.
//
//     CANVOY=build/canvoy CANVOY_WHOLE=1 node --test tests/web/fit_test.mjs
import assert from "node:assert/strict";
import { mkdirSync, readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { look_at, open_browser, path_of, serve, view } from "./browser.mjs";
import { misfits, sizes, views, worlds } from "./fit.mjs";

const whole = !!process.env.CANVOY_WHOLE;
const shots = process.env.CANVOY_SHOTS; // a folder for pictures of all
const axe = readFileSync(path_of("axe-core"), "utf8");
let browser;
before(async () => {
  browser = await open_browser();
  if (shots) mkdirSync(shots, { recursive: true });
});
after(async () => browser?.close());

async function axe_findings(page) {
  await page.evaluate(axe);
  const found = await page.evaluate(() => window.axe.run(document, { resultTypes: ["violations"] }));
  return found.violations.map((it) => `${it.id}: ${it.nodes[0].html.slice(0, 160)} ${it.nodes[0].any[0]?.message ?? ""}`);
}

const short_worlds = ["lift", "charger"];
for (const [name, command] of Object.entries(worlds)) {
  if (!whole && !short_worlds.includes(name)) continue;
  test(`${name} fits at all sizes`, async () => {
    const server = await serve(...command);
    const page = await look_at(browser.context, server.url);
    const told = [];
    try {
      await page.waitForFunction(() => /^([1-9]|\d\d):/.test(document.querySelector(".clock").innerText));
      for (const each of views) {
        await view(page, each);
        for (const [width, height] of sizes) {
          await page.setViewportSize({ width, height });
          await page.waitForTimeout(120);
          const where = `${name}, ${each}, ${width} x ${height}`;
          told.push(...(await page.evaluate(misfits)).map((it) => `${where}: ${it}`));
          if (shots) await page.screenshot({ path: `${shots}/${name}-${each.toLowerCase()}-${width}.png` });
          if (!whole && width !== 768) continue;
          for (const colorScheme of whole ? ["light", "dark"] : ["light"]) {
            await page.emulateMedia({ colorScheme });
            told.push(...(await axe_findings(page)).map((it) => `${where}, ${colorScheme}: ${it}`));
          }
        }
      }
      assert.deepEqual(page.complaints, []);
    } finally {
      await page.close();
      await server.end();
    }
    assert.deepEqual(told, []);
  });
}
