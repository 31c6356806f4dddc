// A report as who got it by mail opens it: from a file, without a server.
//
//     CANVOY=build/canvoy node --test tests/web/report_test.mjs
import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import { open_browser, path_of, run } from "./browser.mjs";

let browser;
const folder = mkdtempSync(join(tmpdir(), "canvoy-report-"));
before(async () => (browser = await open_browser()));
after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true, force: true });
});

/** The report's page, for the length of a test: it asks for nothing but itself, and complains of nothing. */
async function shown(command, work) {
  const file = join(folder, "report.html");
  run("report", ...command, "--out", file);
  const page = await browser.context.newPage();
  const complaints = [];
  const asked = [];
  page.on("pageerror", (error) => complaints.push(String(error)));
  page.on("console", (message) => { if (message.type() === "error") complaints.push(message.text()); });
  page.on("request", (request) => asked.push(request.url()));
  page.on("websocket", (socket) => asked.push(socket.url()));
  await page.goto(pathToFileURL(file).href);
  await page.locator("h1").waitFor();
  await work(page);
  await page.close();
  assert.deepEqual(asked, [pathToFileURL(file).href]);
  assert.deepEqual(complaints, []);
}

test("a run's report has its picture over time, verdicts, statistics and events", async () => {
  await shown(["charger", "--for", "10min", "--fault", "pilot-loss@2min+30s"], async (page) => {
    await page.locator("h1", { hasText: /all holds|none broken/ }).waitFor();
    await page.getByText("canvoy run charger --for 10min --fault pilot-loss@2min+30s --seed 1").waitFor();
    await page.locator(".verdicts tr", { hasText: "pilot-loss" }).getByText("PASS", { exact: true }).waitFor();
    await page.locator(".events li", { hasText: "FAULT begins: pilot-loss" }).waitFor();
    await page.locator("tr", { hasText: /^Energy\s*[0-9.]+ Wh$/ }).waitFor();
    await page.locator(".curve", { hasText: "battery_voltage" }).locator(".line").first().waitFor();
    const charge = page.locator(".charger .charge");
    const last = Number(await charge.getAttribute("width"));
    await page.getByRole("slider").focus();
    await page.keyboard.press("Home");
    await page.getByText("As it was at").getByText("0:00", { exact: true }).waitFor();
    assert.ok(Number(await charge.getAttribute("width")) < last, "there was less in the battery at the start");
  });
});

for (const kind of ["lift", "taxi", "police", "bus", "excavator"]) {
  test(`the report of ${kind} has its world`, async () => {
    await shown([kind, "--for", "3min"], async (page) => {
      await page.locator(".world svg").first().waitFor();
      await page.getByRole("slider").press("Home");
      await page.locator(".verdicts tr").first().waitFor();
    });
  });
}

test("a report is read without a script, on a phone and on paper", async () => {
  const file = join(folder, "plain.html");
  run("report", "charger", "--for", "10min", "--fault", "pilot-loss@2min+30s", "--out", file);
  const reader = await open_browser({ javaScriptEnabled: false, viewport: { width: 390, height: 844 } });
  const page = await reader.context.newPage();
  try {
    await page.goto(pathToFileURL(file).href);
    await page.locator(".verdicts tr", { hasText: /pilot-loss: .* allowed\./ }).first().waitFor();
    await page.locator(".curve .line").first().waitFor();
    await page.locator(".fault-band").first().waitFor();
    await page.locator(".events li", { hasText: "FAULT begins: pilot-loss" }).waitFor();
    assert.ok((await page.locator("main").boundingBox()).width <= 390);
    await page.emulateMedia({ media: "print" });
    const events = await page.locator(".events").boundingBox();
    const last = await page.locator(".events li").last().boundingBox();
    assert.ok(last.y + last.height <= events.y + events.height + 1, "all events are printed");
  } finally {
    await reader.close();
  }
});

test("a log's report has its nodes, load and values, and axe finds nothing serious", async () => {
  const log = join(folder, "night.log");
  run("run", "charger", "--for", "2min", "--log", log);
  await shown([log, "--node", "10=418"], async (page) => {
    await page.locator("td", { hasText: "CiA 418 (10)" }).first().waitFor();
    await page.locator(".curve .line").first().waitFor();
    await page.getByText(/^Last values/).first().click();
    await page.locator("td", { hasText: /^battery_voltage$/ }).first().waitFor();
    await page.evaluate(readFileSync(path_of("axe-core"), "utf8"));
    for (const colorScheme of ["light", "dark"]) {
      await page.emulateMedia({ colorScheme });
      const found = await page.evaluate(() => window.axe.run(document, { runOnly: ["wcag2a", "wcag2aa", "wcag21aa"] }));
      assert.deepEqual(found.violations.filter((it) => ["serious", "critical"].includes(it.impact)).map((it) => `${it.id}: ${it.nodes[0].html}`), []);
    }
    await page.setViewportSize({ width: 390, height: 800 });
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), "nothing is cut off at a phone's width");
  });
});
