// The figures of the live page in a browser: how soon something is seen, and how often it is drawn.
// bench/page runs it.
import { ask, view, look_at, open_browser, serve } from "../tests/web/browser.mjs";

const row = (what, measured, goal = "") => console.log(`${what.padEnd(58)} ${measured.padStart(16)} ${goal.padStart(10)}`);
const median = (all) => [...all].sort((a, b) => a - b)[Math.floor(all.length / 2)];

// What chromium takes on this machine, with the load that it has now, for a page of one word.
const empty = "data:text/html,<p>empty";
const painted = (page) => page.evaluate(() => performance.getEntriesByName("first-contentful-paint")[0]?.startTime ?? 0);

async function first_paint(browser) {
  const server = await serve("run", "charger", "--web");
  const all = [];
  const of_empty = [];
  // In a tab that is there: to make one takes chromium longer than either.
  const page = await look_at(browser.context, server.url);
  for (let i = 0; i < 11; ++i) {
    await page.goto(empty);
    await page.waitForTimeout(500);
    of_empty.push(await painted(page));
    await page.goto(server.url);
    await page.waitForTimeout(1000);
    all.push(await painted(page));
  }
  await page.close();
  await server.end();
  row("first paint on loopback, the median of eleven", `${median(all).toFixed(0)} ms`, "100 ms");
  row("  of an empty page", `${median(of_empty).toFixed(0)} ms`);
}

/** Number of times per second that the page could be drawn, over ten seconds. */
const rate = (page) => page.evaluate(() => new Promise((resolve) => {
  let first = 0;
  let count = 0;
  const tick = (at) => {
    first ||= at;
    if (at - first < 10000) return ++count && requestAnimationFrame(tick);
    resolve(count / ((at - first) / 1000));
  };
  requestAnimationFrame(tick);
}));

async function drawing(browser) {
  const server = await serve("run", "lift", "--lifts", "8", "--floors", "20", "--percent", "12", "--web", "--speed", "1");
  const page = await look_at(browser.context, server.url);
  for (const name of ["World", "Load", "Frames"]) {
    await view(page, name);
    await page.waitForTimeout(2000);
    const buses = await page.evaluate(() => fetch("/api/networks").then((answer) => answer.json()).then((all) => all.length));
    row(`drawing, 8 lifts on ${buses} buses, ${name}`, `${(await rate(page)).toFixed(1)} Hz`, "60 Hz");
  }
  await page.goto(empty);
  row("  of an empty page", `${(await rate(page)).toFixed(1)} Hz`);
  await page.close();
  await server.end();
}

/** The share of a core that the page's thread takes: scripts, lay-out and drawing, by its own time, so that others on the machine do not count. */
async function busy(page, seconds) {
  const session = await page.context().newCDPSession(page);
  await session.send("Performance.enable", { timeDomain: "threadTicks" });
  const worked = async () => (await session.send("Performance.getMetrics")).metrics.find((each) => each.name === "TaskDuration").value;
  const before = await worked();
  await page.waitForTimeout(1000 * seconds);
  const share = ((await worked()) - before) / seconds;
  await session.detach();
  return share;
}

/** A log played 60 times as fast as it was, so that 2,000 frames come each second. */
async function page_share(browser, log) {
  const server = await serve("view", log);
  const page = await look_at(browser.context, server.url);
  const run = (what, body) => ask(server, `/api/run/${what}`, { method: "POST", body: JSON.stringify(body) });
  for (const name of ["Overview", "Frames", "Nodes", "Load"]) {
    await view(page, name);
    await run("restart", {});
    await run("speed", { speed: 60 });
    await page.waitForTimeout(3000);
    row(`the page's thread at 2,000 frames a second, ${name}: of a core`, `${(100 * (await busy(page, 10))).toFixed(1)} %`, "8 %");
  }
  await page.close();
  await server.end();
}

/** Bytes that a browser takes for the page, with the first messages. */
async function wire(browser) {
  const server = await serve("run", "charger", "--web");
  const page = await browser.context.newPage();
  const session = await page.context().newCDPSession(page);
  await session.send("Network.enable");
  let files = 0;
  let messages = 0;
  session.on("Network.loadingFinished", (event) => (files += event.encodedDataLength));
  session.on("Network.webSocketFrameReceived", (event) => (messages += event.response.payloadData.length));
  await page.goto(server.url);
  await page.waitForTimeout(2000);
  row("files of the page on the wire, with heads", `${(files / 1000).toFixed(0)} kB`, "54 kB");
  row("  messages of the first two seconds, before deflate", `${(messages / 1000).toFixed(0)} kB`);
  await page.close();
  await server.end();
}

const browser = await open_browser();
await wire(browser);
if (process.argv[2]) await page_share(browser, process.argv[2]);
await first_paint(browser);
await drawing(browser);
await browser.close();
