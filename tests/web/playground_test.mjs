// The playground as a visitor uses it, from any static web server: scripts/playground --test runs this, as it has built it.
//
//     CANVOY=build/canvoy node --test tests/web/playground_test.mjs
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { createServer } from "node:http";
import { tmpdir } from "node:os";
import { basename, join } from "node:path";
import { after, before, test } from "node:test";
import { look_at, open_browser, skip, view } from "./browser.mjs";

const site = process.env.CANVOY_PLAYGROUND ?? "build/playground/site";
const canvoy = process.env.CANVOY ?? "build/canvoy";
if (!existsSync(join(site, "canvoy.wasm"))) skip("the playground was not built: make playground");

const types = { html: "text/html", js: "text/javascript", css: "text/css", svg: "image/svg+xml", wasm: "application/wasm" };
const folder = mkdtempSync(join(tmpdir(), "canvoy-playground-test-"));
const asked = []; // paths, of the server
let browser;
let server;
before(async () => {
  browser = await open_browser();
  server = createServer((request, response) => {
    const path = new URL(request.url, "http://localhost").pathname;
    asked.push(path);
    const file = join(site, path === "/play/" ? "index.html" : basename(path));
    if (!path.startsWith("/play/") || !existsSync(file)) return response.writeHead(404).end();
    response.writeHead(200, { "Content-Type": types[file.split(".").pop()] }).end(readFileSync(file));
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
});
after(async () => {
  await browser?.close();
  server?.close();
  rmSync(folder, { recursive: true, force: true });
});

const address = (command) => `http://127.0.0.1:${server.address().port}/play/${command ? `?run=${encodeURIComponent(command)}` : ""}`;
const event = (page, text) => page.locator(".events li", { hasText: text }).first();

async function shown(command, work) {
  const page = await look_at(browser.context, address(command));
  try {
    await work(page);
    assert.deepEqual(page.complaints, []);
  } finally {
    await page.close();
  }
}

async function saved(page, name) {
  const download = page.waitForEvent("download");
  await page.getByRole("link", { name }).click();
  const path = join(folder, name.replaceAll(" ", "-"));
  await (await download).saveAs(path);
  return path;
}

test("a lift plays without a command", async () => {
  await shown("", async (page) => {
    await page.getByRole("button", { name: "Somebody at floor 4 wants up" }).click();
    await event(page, /call up at floor 4 is acknowledged/).waitFor();
  });
});

test("a visitor breaks a lift, and reads its emergency and the verdict", async () => {
  await shown("lift --floors 6 --percent 20 --speed 30", async (page) => {
    await page.getByLabel("What should go wrong?").selectOption("door-lock");
    await page.getByRole("button", { name: "Let it happen" }).click();
    await event(page, "FAULT begins: door-lock").waitFor();
    await event(page, /EMERGENCY FF04h/).waitFor();
    await view(page, "Events");
    await page.locator(".verdicts tr", { hasText: "door-lock" }).first().getByText("PASS", { exact: true }).waitFor();
  });
});

for (const network of ["charger", "charger --chargers 2 --batteries 3 --goal 80@06:00", "taxi", "police", "bus", "excavator"]) {
  test(`${network} plays, and tells frames in words`, async () => {
    await shown(network, async (page) => {
      await view(page, "Frames");
      await page.locator(".frame-list .service", { hasText: /[a-z]/i }).first().waitFor({ state: "attached" });
    });
  });
}

test("the command and the file that are shared play what was seen, frame by frame", async () => {
  await shown("charger --for 10min --speed 600 --fault heartbeat-loss@5min+30s", async (page) => {
    await page.waitForFunction(() => /^10:00/.test(document.querySelector(".clock").innerText));
    await page.getByRole("button", { name: "Share" }).click();
    const command = await page.locator("#share-command").inputValue();
    assert.match(command, /^canvoy run charger --for 10min .*--seed 1/);
    const link = new URL(await page.locator("#share-link").inputValue());
    assert.equal(link.searchParams.get("run"), "charger --for 10min --speed 600 --fault heartbeat-loss@5min+30s");
    const here = readFileSync(await saved(page, "Save frames as a log"), "ascii");
    const file = await saved(page, "Save the run as a file");
    assert.match(readFileSync(file, "utf8"), /^# A CiA 419 charger charges a CiA 418 battery/);
    const log = join(folder, "played.log");
    const { status, stderr } = spawnSync(canvoy, ["run", file, "--for", "10min", "--log", log], { encoding: "utf8" });
    assert.equal(status, 0, stderr);
    assert.ok(here.length > 500_000);
    assert.equal(readFileSync(log, "ascii") === here, true, "frames of the browser and of the command");
  });
});

test("an object is read and written", async () => {
  await shown("lift --floors 6 --percent 0", async (page) => {
    await view(page, "Objects");
    await page.getByRole("button", { name: "All of the profile" }).click();
    await page.getByLabel("Search").fill("producer heartbeat");
    const value = page.getByLabel(/New value: Producer heartbeat time/i).first();
    const row = page.locator(".writer").filter({ has: value }).first();
    await value.fill("700");
    await row.getByRole("button", { name: "Write" }).click();
    await row.getByRole("status").filter({ hasText: /^written$/ }).waitFor();
  });
});

test("a command that makes no sense is refused in the words of the command", async () => {
  const page = await browser.context.newPage();
  await page.goto(address("lift --lifts 9"));
  await page.getByRole("status").filter({ hasText: /--lifts.*1.*8/ }).waitFor();
  await page.getByLabel("Network and options").fill("taxi");
  await page.getByRole("button", { name: "Play", exact: true }).first().click();
  await page.waitForSelector("main[data-view] > *");
  assert.equal(new URL(page.url()).searchParams.get("run"), "taxi");
  await page.close();
});

test("nothing is asked of a server but the files of the folder", () => {
  const files = ["", "page.js", "page.css", "uplot.js", "icon.svg", "playground.js", "worker.js", "canvoy.wasm"];
  assert.deepEqual([...new Set(asked)].filter((path) => !files.includes(path.slice("/play/".length))), []);
});
