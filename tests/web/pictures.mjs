// The pictures of docs/web.md, each of a run at one time of it: so they can be made anew, and looked at, after a change.
//
//     CANVOY=build/canvoy node tests/web/pictures.mjs docs/pictures
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { ask, look_at, open_browser, run, serve, view } from "./browser.mjs";

const folder = process.argv[2] ?? "docs/pictures";
const size = { width: 1280, height: 800 };
const browser = await open_browser();

/** A page of the command at a time of the run, where it stands. */
async function at(name, seconds, command, ready, work = async () => {}) {
  const server = await serve("run", ...command, "--web");
  const page = await look_at(browser.context, server.url);
  await page.setViewportSize(size);
  const run = (what, body) => ask(server, `/api/run/${what}`, { method: "POST", body: JSON.stringify(body) });
  await run("pause", { paused: true });
  await run("seek", { time: seconds });
  await page.waitForFunction((wanted) => document.querySelector(".clock").innerText === wanted, ready);
  await work(page);
  await page.waitForTimeout(500);
  await page.screenshot({ path: join(folder, `web-${name}.png`) });
  await page.close();
  await server.end();
}

const lifts = ["lift", "--lifts", "3", "--floors", "12", "--traffic", "lunch"];
const charger = ["charger", "--fault", "pilot-loss@2min+30s"];
await at("lift", 300, lifts, "5:00.0");
await at("nodes", 300, lifts, "5:00.0", (page) => view(page, "Nodes"));
await at("load", 300, lifts, "5:00.0", (page) => view(page, "Load"));
await at("charger", 600, charger, "10:00.0");
await at("objects", 600, charger, "10:00.0", (page) => view(page, "Objects"));
await at("events", 600, charger, "10:00.0", (page) => view(page, "Events"));
await at("plots", 600, charger, "10:00.0", async (page) => {
  await view(page, "Objects");
  for (const name of ["battery_voltage", "charge_current_requested", "temperature"]) {
    const pin = page.getByRole("button", { name: `Pin to the plots: ${name}` }).first();
    if (await pin.count()) await pin.click();
  }
  await view(page, "Plots");
  await page.getByRole("button", { name: "Play" }).click();
  await page.locator("header select").selectOption("60");
  await page.waitForFunction(() => /^1[5-9]:/.test(document.querySelector(".clock").innerText));
  await page.getByRole("button", { name: "Pause" }).click();
});
await at("taxi", 1500, ["taxi"], "25:00.0");
await at("police", 1500, ["police"], "25:00.0");
await at("bus", 548, ["bus"], "9:08.0");
await at("excavator", 95, ["excavator"], "1:35.0");

// A log, which stands at its end.
const made = mkdtempSync(join(tmpdir(), "canvoy-pictures-"));
const log = join(made, "night.log");
run("run", ...charger, "--for", "10min", "--log", log);
const server = await serve("view", log, "--node", "10=418", "--node", "6=419");
const page = await look_at(browser.context, server.url);
await page.setViewportSize(size);
await page.locator(".trends path.line").waitFor();
await page.locator(".main-values dd").first().waitFor();
await page.waitForTimeout(500);
await page.screenshot({ path: join(folder, "web-overview.png") });
await view(page, "Frames");
await page.getByLabel("Filter").fill("emcy or (node=10 and battery_voltage>48V)");
await page.waitForFunction(() => [...document.querySelectorAll(".frame-list .said-text")].some((each) => /battery_voltage/.test(each.innerText)));
await page.locator(".frame-list").press("ArrowDown");
await page.waitForTimeout(500);
await page.screenshot({ path: join(folder, "web-frames.png") });
await page.close();
await server.end();
rmSync(made, { recursive: true, force: true });
await browser.close();
