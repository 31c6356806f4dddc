// The page in Debian's firefox: every view with what is in it, by keys and clicks. What is tried more deeply is in
// page_test.mjs; its library drives another firefox than this one.
//
//     CANVOY=build/canvoy node --test tests/web/firefox_test.mjs
import assert from "node:assert/strict";
import { existsSync } from "node:fs";
import { after, before, test } from "node:test";
import { load, PATIENCE_MS, serve, skip } from "./browser.mjs";
import { misfits, sizes, views, worlds } from "./fit.mjs";

const puppeteer = load("puppeteer-core");
const firefox_path = ["/usr/bin/firefox-esr", "/usr/bin/firefox"].find(existsSync);
if (!firefox_path) skip("there is no firefox");

let browser;
before(async () => (browser = await puppeteer.launch({
  browser: "firefox",
  executablePath: firefox_path,
  headless: true,
  defaultViewport: { width: 1280, height: 720 },
})));
after(async () => browser?.close());

/** A page of a run, for the length of a test. */
async function shown(command, work) {
  const server = await serve(...command);
  const page = await browser.newPage();
  page.setDefaultTimeout(PATIENCE_MS);
  const complaints = [];
  page.on("pageerror", (error) => complaints.push(String(error)));
  page.on("console", (message) => { if (message.type() === "error") complaints.push(message.text()); });
  try {
    await page.goto(server.url);
    await page.waitForSelector("main[data-view] > *");
    await work(page);
    assert.deepEqual(complaints, []);
  } finally {
    await page.close();
    await server.end();
  }
}

const button = (page, name) => page.locator(`::-p-aria([name="${name}"][role="button"])`);
const field = (page, name) => page.locator(`::-p-aria([name="${name}"])`);
/** Waits until an element of the selector says what is looked for. */
const says = (page, selector, wanted) => page.waitForFunction(
  (where, pattern) => [...document.querySelectorAll(where)].some((each) => new RegExp(pattern).test(each.innerText)), {}, selector, wanted.source);
const view = async (page, name) => {
  await page.locator(`::-p-xpath(//nav//button[normalize-space()="${name}"])`).click();
  await page.waitForSelector(`main[data-view="${name.toLowerCase()}"] > *`);
};

test("a call on a landing brings the car, by a click and by the keyboard", async () => {
  await shown(["run", "lift", "--floors", "6", "--percent", "0", "--web", "--speed", "20"], async (page) => {
    await button(page, "Somebody at floor 4 wants up").click();
    await says(page, ".events li", /call up at floor 4 is acknowledged/);
    await says(page, ".events li", /lift 1 is open at floor 4/);
    await page.$eval('[aria-label="Somebody at floor 2 wants down"]', (each) => each.focus());
    await page.keyboard.press("Enter");
    await says(page, ".events li", /call down at floor 2 is acknowledged/);
  });
});

test("each view of a charger shows what there is", async () => {
  await shown(["run", "charger", "--web", "--speed", "60"], async (page) => {
    await view(page, "Nodes");
    await says(page, "main tr, main section", /battery[^]*operational/);
    await view(page, "Objects");
    await field(page, "Search").fill("battery_voltage");
    await says(page, "main", /[45][0-9]\.[0-9]+\s*V/);
    await field(page, "Pin to the plots: battery_voltage").click();
    await view(page, "Plots");
    await says(page, ".plot h3", /[45][0-9]\.[0-9]+ V/);
    await page.waitForSelector(".plot canvas");
    await view(page, "Frames");
    await field(page, "Filter").fill("heartbeat and node=10");
    await page.waitForFunction(() => {
      const services = [...document.querySelectorAll(".frame-list .service")].map((each) => each.innerText);
      return services.length > 3 && services.every((service) => service === "heartbeat");
    });
    await page.focus(".frame-list");
    await page.keyboard.press("ArrowDown");
    await says(page, ".details", /70Ah/);
    await view(page, "Load");
    await says(page, "main tr", /sim0[^]*[1-9]/);
    await view(page, "World");
    await page.select("::-p-aria(What should go wrong?)", "pilot-loss");
    await page.select("label.field.small select", "30");
    await button(page, "Let it happen").click();
    await says(page, ".events li", /FAULT begins: pilot-loss/);
    await view(page, "Events");
    await says(page, ".verdicts tr", /^PASS\s+pilot-loss/);
  });
});

for (const [kind, command] of Object.entries(worlds)) {
  if (kind !== "lift" && !process.env.CANVOY_WHOLE) continue;  // a building of 30 floors
  test(`${kind} fits at all sizes, in all views`, async () => {
    await shown(command, async (page) => {
      const told = [];
      for (const each of views) {
        await view(page, each);
        for (const [width, height] of sizes) {
          await page.setViewport({ width, height });
          told.push(...(await page.evaluate(misfits)).map((it) => `${each}, ${width} x ${height}: ${it}`));
        }
      }
      assert.deepEqual(told, []);
    });
  });
}

for (const kind of ["taxi", "police", "bus", "excavator"]) {
  test(`the world of ${kind} is drawn and moves`, async () => {
    await shown(["run", kind, "--web", "--speed", "20"], async (page) => {
      await page.waitForSelector(".world svg, main svg");
      const before = await page.$eval("main", (main) => main.innerHTML);
      await page.waitForFunction((stood) => document.querySelector("main").innerHTML !== stood, {}, before);
      const cut = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
      assert.ok(cut <= 0, `the page is ${cut} pixels wider than its window`);
    });
  });
}
