// The command's page in Debian's chromium: what the tests of the page have in common.
import { spawn, spawnSync } from "node:child_process";
import { existsSync, mkdtempSync, rmSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";

const modules = createRequire(new URL("../../canvoy/web/page/package.json", import.meta.url));
const canvoy = process.env.CANVOY ?? "build/canvoy";
/** How long is waited for what takes a few seconds at most. */
export const PATIENCE_MS = 120000;
const chromium_path = ["/usr/bin/chromium", "/usr/bin/chromium-browser"].find(existsSync);

/** Ends the test as skipped. */
export function skip(reason) {
  console.log(`skipped: ${reason}`);
  process.exit(process.env.CI === "true" ? 1 : 77);
}

export function load(name) {
  try {
    return modules(name);
  } catch {
    return skip(`npm ci was not run in canvoy/web/page: ${name} is missing`);
  }
}
export const path_of = (name) => modules.resolve(name);

const { chromium } = load("playwright-core");
if (!chromium_path) skip("there is no chromium");

/** Starts the command, and looks at nothing that it says. */
export const start = (...command) => spawn(canvoy, command, { stdio: ["pipe", "ignore", "inherit"] });

/** Starts the command; gives its address and what ends it, also where it has ended by itself. */
export async function serve(...command) {
  const child = spawn(canvoy, command, { stdio: ["ignore", "pipe", "inherit"] });
  const gone = new Promise((resolve) => child.once("close", resolve));
  let text = "";
  const url = await new Promise((resolve, reject) => {
    child.stdout.once("data", (data) => {
      child.stdout.on("data", (more) => (text += more));
      resolve(String(data).trim());
    });
    gone.then((code) => reject(new Error(`canvoy ended with ${code}`)));
  });
  const end = async () => {
    child.kill("SIGTERM");
    return { code: await gone, text };
  };
  return { url, end, pid: child.pid };
}

/** What the API of a server answers: with its token, which is in the address. */
export function ask(server, path, options = {}) {
  const url = new URL(server.url);
  const headers = { Authorization: `Bearer ${url.searchParams.get("token")}`, "Content-Type": "application/json", ...options.headers };
  return fetch(new URL(path, url.origin), { ...options, headers });
}

/** Runs the command to its end; that it could is what the test wants. */
export function run(...command) {
  const { status, stderr } = spawnSync(canvoy, command, { encoding: "utf8" });
  if (status !== 0) throw new Error(`canvoy ${command.join(" ")} ended with ${status}: ${stderr}`);
}

/** `options`: as playwright takes them, beside those that all tests have. */
export async function open_browser(options = {}) {
  const folder = mkdtempSync(join(tmpdir(), "canvoy-page-"));
  const context = await chromium.launchPersistentContext(folder, {
    executablePath: chromium_path,
    headless: true,
    viewport: { width: 1280, height: 720 },
    ...options,
    args: [
      "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
      "--disable-background-networking", "--disable-component-update", "--disable-sync",
    ],
  });
  context.setDefaultTimeout(PATIENCE_MS);
  const close = async () => {
    await context.close();
    rmSync(folder, { recursive: true, force: true });
  };
  return { context, close };
}

/** A page at the address; whatever it complains of ends the test. */
export async function look_at(context, url) {
  const page = await context.newPage();
  page.complaints = [];
  page.on("pageerror", (error) => page.complaints.push(String(error)));
  page.on("console", (message) => {
    if (message.type() === "error") page.complaints.push(message.text());
  });
  await page.goto(url);
  await page.waitForSelector("main[data-view] > *");
  return page;
}

export const view = (page, name) => page.getByRole("navigation").getByRole("button", { name, exact: true }).click();

/** Pauses a run, and waits until the state at which time stands is drawn: frames that were on their way come first. */
export async function pause(page) {
  await page.getByRole("button", { name: "Pause" }).click();
  await page.getByRole("button", { name: "Play" }).waitFor();
  const clock = page.locator(".clock");
  for (let before = "", now = await clock.innerText(); now !== before; now = await clock.innerText()) {
    before = now;
    await page.waitForTimeout(500);
  }
}
