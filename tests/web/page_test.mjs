// The page as people use it: they press, type and read.
//
//     CANVOY=build/canvoy node --test tests/web/page_test.mjs
import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { ask, load, look_at, open_browser, path_of, PATIENCE_MS, pause, run, serve, view } from "./browser.mjs";

let browser;
const folder = mkdtempSync(join(tmpdir(), "canvoy-page-test-"));
before(async () => (browser = await open_browser()));
after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true, force: true });
});

/** A page of a run, for the length of a test. */
async function shown(command, work) {
  const server = await serve(...command);
  const page = await look_at(browser.context, server.url);
  try {
    await work(page, server);
    assert.deepEqual(page.complaints, []);
  } finally {
    await page.close();
    await server.end();
  }
}

const lift = ["run", "lift", "--floors", "6", "--percent", "0", "--web", "--speed", "20"];
const charger = ["run", "charger", "--web", "--speed", "60"];
const event = (page, text) => page.locator(".events li", { hasText: text }).first();
const number_in = async (locator) => Number((await locator.innerText()).replace(/[^0-9.]/g, ""));

test("a landing call by a click makes the car come, and carries who called", async () => {
  await shown(lift, async (page) => {
    await page.getByRole("button", { name: "Somebody at floor 4 wants up" }).click();
    await page.getByText(/A visitor at floor 4 wants to floor [56]\./).waitFor();
    await event(page, /call up at floor 4 is acknowledged/).waitFor();
    await event(page, /lift 1 is open at floor 4/).waitFor();
    const carried = page.locator(".figure", { hasText: "carried" }).locator(".figure-value");
    await assert.doesNotReject(page.waitForFunction(() => [...document.querySelectorAll(".figure")].some((each) => /carried\s*1$/.test(each.innerText.trim()))));
    assert.equal(await number_in(carried), 1);
  });
});

test("a call is made by the keyboard alone", async () => {
  await shown(lift, async (page) => {
    const call = page.getByRole("button", { name: "Somebody at floor 2 wants down" });
    await call.focus();
    await page.keyboard.press("Enter");
    await event(page, /call down at floor 2 is acknowledged/).waitFor();
  });
});

test("a fault by a click is told with its code, and with its verdict", async () => {
  await shown(charger, async (page) => {
    await page.waitForFunction(() => /^[1-9]:/.test(document.querySelector(".clock").innerText));
    await page.getByLabel("What should go wrong?").selectOption("heartbeat-loss");
    await page.locator("label.field.small", { hasText: /^for/ }).locator("select").selectOption("30");
    await page.getByRole("button", { name: "Let it happen" }).click();
    await event(page, "FAULT begins: heartbeat-loss").waitFor();
    await event(page, /EMERGENCY 8130h: life guard or heartbeat error/).waitFor();
    await view(page, "Events");
    const verdict = page.locator(".verdicts tr", { hasText: "heartbeat-loss" }).first();
    await verdict.getByText("PASS", { exact: true }).waitFor();
  });
});

test("a link and a file play the same run", async () => {
  await shown(charger, async (page) => {
    await page.waitForFunction(() => /^[1-9]:/.test(document.querySelector(".clock").innerText));
    await pause(page); // the link's time is the fault's, to the microsecond
    await page.getByLabel("What should go wrong?").selectOption("pilot-loss");
    await page.getByRole("button", { name: "Let it happen" }).click();
    const begins = event(page, "FAULT begins: pilot-loss");
    await begins.waitFor();
    const told = await begins.innerText();
    await page.getByRole("button", { name: "Share" }).click();
    const link = await page.locator("#share-link").inputValue();
    const command = await page.locator("#share-command").inputValue();
    assert.match(command, /^canvoy run charger --seed 1 --fault pilot-loss@[0-9.]+[mu]?s\+30s$/);
    const download = page.waitForEvent("download");
    await page.getByRole("link", { name: "Save the run as a file" }).click();
    await (await download).saveAs(join(folder, "run.toml"));
    const played = (...what) => {
      run("run", ...what, "--log", join(folder, "played.log"));
      return readFileSync(join(folder, "played.log"), "ascii");
    };
    const length = ["--for", "20min"];
    assert.ok(played(join(folder, "run.toml"), ...length) === played(...command.split(" ").slice(2), ...length), "the file and the command play the same frames");
    await shown(charger, async (other, server) => {
      const asked = [];
      other.on("dialog", (dialog) => { asked.push(dialog.message()); dialog.accept().catch(() => {}); });
      await other.goto(`${server.url}${new URL(link).hash}`);
      await event(other, "FAULT begins: pilot-loss").waitFor();
      assert.equal(await event(other, "FAULT begins: pilot-loss").innerText(), told);
      assert.match(asked[0], /starts anew for everyone/);
      await other.reload();
      await event(other, "FAULT begins: pilot-loss").waitFor();
      assert.equal(asked.length, 1, "a link to the run that plays asks nothing");
    });
  });
});

test("a write out of range is refused with its range, and by the node with its abort", async () => {
  await shown([...lift, "--allow-write", "all"], async (page) => {
    await view(page, "Objects");
    await page.getByRole("button", { name: "All of the profile" }).click();
    await page.getByLabel("Search").fill("producer heartbeat");
    const value = page.getByLabel(/New value: Producer heartbeat time/i).first();
    const row = page.locator(".writer").filter({ has: value }).first();
    await value.fill("70000");
    await row.getByRole("button", { name: "Write" }).click();
    await row.getByRole("status").filter({ hasText: /out of range/ }).waitFor();
    await value.fill("hex:01");
    await row.getByRole("button", { name: "Write" }).click();
    await row.getByRole("status").filter({ hasText: /0607001[0-3]h/ }).waitFor();
    await value.fill("700");
    await row.getByRole("button", { name: "Write" }).click();
    await row.getByRole("status").filter({ hasText: /^written$/ }).waitFor();
    await row.getByRole("button", { name: "Read" }).click();
    await row.getByRole("status").filter({ hasText: /700 ms/ }).waitFor();
  });
});

test("a node says who it is when it is asked", async () => {
  await shown(lift, async (page, server) => {
    await view(page, "Nodes");
    const row = page.locator("tr", { hasText: "lift-drive" });
    await row.getByRole("button", { name: "Ask" }).click();
    const identity = row.locator(".mono span");
    await identity.nth(3).filter({ hasText: /[0-9]/ }).waitFor();
    for (const sub of [1, 2, 3, 4]) {
      const answer = await (await ask(server, `/api/networks/lift1/nodes/2/objects/1018:${sub}/read`, { method: "POST", body: "{}" })).json();
      assert.equal((await identity.nth(sub - 1).innerText()).trim(), answer.text);
    }
  });
});

test("objects are a tree of network, node, object and sub-index", async () => {
  await shown(charger, async (page) => {
    await view(page, "Objects");
    await page.getByRole("button", { name: "Tree", exact: true }).click();
    const tree = page.locator(".tree");
    await tree.getByText("sim0", { exact: true }).waitFor();
    await tree.locator("summary", { hasText: /^battery/ }).press("Enter");
    await tree.locator("summary", { hasText: /^Of the device profile/ }).press("Enter");
    const object = tree.locator("summary", { hasText: "6060h" });
    await object.getByText("CiA 418").waitFor();
    await object.press("Enter");
    const entry = tree.locator("li", { has: page.locator("form.writer") }).filter({ hasText: ":00" }).filter({ hasText: "battery_voltage" }).last();
    await entry.locator(".latest", { hasText: /[45][0-9]\.[0-9]+ V/ }).waitFor();
    await tree.locator("summary", { hasText: /^charger/ }).press("Enter");
    await page.getByLabel("Search").fill("6000");
    await tree.locator("summary", { hasText: "6000h" }).getByText("CiA 419, 7.2.1").waitFor();
    await page.getByLabel("Search").fill("no such object");
    await tree.getByText("Nothing is called so.").first().waitFor();
  });
});

test("a frame's details say in which clause its service and its objects are", async () => {
  await shown(charger, async (page) => {
    await view(page, "Frames");
    const details = page.locator(".details");
    // By the keyboard: rows that move on are hard to hit, for people as well.
    const pick = async (filter, service) => {
      await page.getByLabel("Filter").fill(filter);
      await page.waitForFunction((wanted) => {
        const services = [...document.querySelectorAll(".frame-list .service")].map((each) => each.innerText);
        return services.length > 0 && services.every((each) => each.startsWith(wanted));
      }, service);
      await page.locator(".frame-list").press("ArrowDown");
      await details.locator("h3", { hasText: service }).waitFor();
    };
    await pick("object=6060h and service=TPDO", "TPDO");
    await details.getByText("CiA 301, 7.2.2", { exact: true }).waitFor();
    await details.locator(".clause", { hasText: /^CiA 418$/ }).first().waitFor();
    await pick('object=1000h and service="SDO response"', "SDO");
    await page.locator(".frame-list").press("ArrowDown");
    await details.getByText("CiA 301, 7.2.4", { exact: true }).waitFor();
    await details.locator(".clause", { hasText: /^CiA 301, 7\.5\.2\.1$/ }).first().waitFor();
  });
});

test("a recording is begun and ended by a button, where a folder was given for it", async () => {
  await shown(charger, async (page) => {
    await view(page, "Frames");
    await page.locator(".frame-list .frame-row").first().waitFor();
    assert.equal(await page.getByRole("button", { name: /Record/ }).count(), 0);
  });
  await shown([...charger, "--allow-record", folder], async (page) => {
    await view(page, "Frames");
    await page.getByRole("button", { name: /Record$/ }).click();
    await page.getByRole("status").filter({ hasText: /canvoy-1\.log: [1-9][0-9,]* frames/ }).waitFor();
    await page.getByRole("button", { name: "Stop recording" }).click();
    await page.getByRole("button", { name: /Record$/ }).waitFor();
    assert.match(readFileSync(join(folder, "canvoy-1.log"), "ascii"), /^(\([0-9]{10}\.[0-9]{6}\) sim0 [0-9A-F]+#[0-9A-FR]*\n)+$/);
  });
});

test("an excavator digs: its arm moves, sticks are held, the display shows what it does", async () => {
  await shown(["run", "excavator", "--web", "--speed", "10"], async (page) => {
    const arm = page.locator(".machine .beam").last();
    const before = await arm.getAttribute("d");
    await page.waitForFunction((stood) => [...document.querySelectorAll(".machine .beam")].at(-1).getAttribute("d") !== stood, before);
    await page.waitForFunction(() => [...document.querySelectorAll(".stick svg")].some((each) => !/: 0 %(, 0 %)?$/.test(each.getAttribute("aria-label"))));
    await page.locator(".seat-display div", { hasText: "Fuel" }).getByText(/^[0-9]+ %$/).waitFor();
    await page.locator(".seat .chips li.on", { hasText: "ready" }).waitFor();
    await page.locator(".figure", { hasText: "cycles" }).getByText(/^[1-9]/).waitFor();
    await page.getByLabel("What should go wrong?").selectOption("broken-wire");
    await page.getByRole("button", { name: "Let it happen" }).click();
    await event(page, "FAULT begins: broken-wire").waitFor();
    await page.locator(".seat .chips li.on.bad", { hasText: "fault" }).waitFor();
  });
});

test("frames are filtered as on the command line, and a wrong filter is explained", async () => {
  await shown(charger, async (page) => {
    await view(page, "Frames");
    await page.locator(".frame-list .frame-row").first().waitFor();
    const filter = page.getByLabel("Filter");
    await filter.fill("heartbeat and node=10");
    await page.waitForFunction(() => {
      const services = [...document.querySelectorAll(".frame-list .service")].map((each) => each.innerText);
      return services.length > 3 && services.every((service) => service === "heartbeat");
    });
    await page.locator(".frame-list").press("ArrowDown");
    await page.locator(".details").getByText("70Ah").waitFor();
    await filter.fill("tempersture>40");
    await page.getByText(/no object is called 'tempersture'; did you mean 'temperature'/).waitFor();
  });
});

test("frames that are followed are never out of sight, and stay where they are when one scrolls", async () => {
  await shown(charger, async (page) => {
    await view(page, "Frames");
    const list = page.locator(".frame-list");
    await list.locator(".frame-row").nth(20).waitFor();
    const fewest = await page.evaluate(async () => {
      const box = document.querySelector(".frame-list");
      let least = Infinity;
      for (let i = 0; i < 100; ++i) {
        await new Promise(requestAnimationFrame);
        const room = box.getBoundingClientRect();
        const seen = [...box.querySelectorAll(".frame-row")].filter((row) => {
          const { top, bottom } = row.getBoundingClientRect();
          return bottom > room.top && top < room.bottom;
        });
        const fit = Math.floor(room.height / box.querySelector(".frame-row").offsetHeight);
        least = Math.min(least, seen.length / fit);
      }
      return least;
    });
    assert.ok(fewest >= 0.9, `${(100 * fewest).toFixed(0)} % of the list have rows`);
    await list.hover();
    await page.mouse.wheel(0, -2000);
    await page.waitForFunction(() => !document.querySelector(".check input").checked);
    const first = () => list.locator(".frame-row").first().innerText();
    const before = await first();
    const count = page.locator(".tools .count").last();
    const counted = await count.innerText();
    await page.waitForFunction((then) => [...document.querySelectorAll(".tools .count")].at(-1).innerText !== then, counted);
    assert.equal(await first(), before);
  });
});

test("a server that is gone leaves nothing green", async () => {
  const server = await serve(...charger);
  const page = await look_at(browser.context, server.url);
  try {
    const verdict = page.locator("button.verdict");
    await verdict.filter({ hasText: /all holds|none broken/ }).waitFor();
    assert.equal(await page.locator(".lost").count(), 0);
    process.kill(server.pid, "SIGKILL");
    await page.getByRole("alert").filter({ hasText: /connection to the server is lost: what is shown is \d+ s old/ }).waitFor();
    await verdict.filter({ hasText: "unknown" }).waitFor();
    assert.doesNotMatch(await verdict.getAttribute("class"), /good/);
    await page.locator(".summary .headline", { hasText: "It is not known how it is now" }).waitFor();
    assert.equal(await page.locator(".summary.good").count(), 0);
  } finally {
    await page.close();
    await server.end();
  }
});

test("a server that says nothing is told from a run that stands, though neither ends the connection", async () => {
  await shown(charger, async (page, server) => {
    const verdict = page.locator("button.verdict");
    await verdict.filter({ hasText: /all holds|none broken/ }).waitFor();
    const asked = [];
    const answered = [];
    const session = await page.context().newCDPSession(page);
    await session.send("Network.enable");
    session.on("Network.webSocketFrameSent", ({ response }) => asked.push(response.payloadData));
    session.on("Network.webSocketFrameReceived", ({ response }) => answered.push(response.payloadData));
    const until = async (holds) => { while (!holds()) await page.waitForTimeout(50); };
    const count = (all, what) => all.filter((each) => each.includes(what)).length;
    await pause(page);
    const before = count(asked, '"do":"values"');
    await until(() => count(asked, '"do":"values"') >= before + 4);
    assert.deepEqual(await page.locator(".lost").allInnerTexts(), [], "a run that stands is asked, and answers");
    assert.match(await verdict.getAttribute("class"), /good/);
    const moving = () => document.querySelector(".cable .flow").getAnimations().filter((each) => each.playState === "running").length;
    assert.equal(await page.evaluate(moving), 0, "no current flows while time stands");
    process.kill(server.pid, "SIGSTOP");
    await page.getByRole("alert").filter({ hasText: /The server has said nothing for \d+ s/ }).waitFor();
    await verdict.filter({ hasText: "unknown" }).waitFor();
    await page.locator(".summary .headline", { hasText: "It is not known how it is now" }).waitFor();
    assert.doesNotMatch(await verdict.getAttribute("class"), /good/);
    process.kill(server.pid, "SIGCONT");
    await verdict.filter({ hasText: /all holds|none broken/ }).waitFor();
    await page.waitForFunction(() => !document.querySelector(".lost"));
    await page.getByRole("button", { name: "Play" }).click();
    await page.waitForFunction(moving);
  });
});

test("a page that slept for a minute shows what is so when it wakes", { timeout: PATIENCE_MS }, async () => {
  await shown(charger, async (page, server) => {
    await page.locator("button.verdict", { hasText: /all holds|none broken/ }).waitFor();
    const session = await page.context().newCDPSession(page);
    await session.send("Page.enable");
    await session.send("Page.setWebLifecycleState", { state: "frozen" });
    process.kill(server.pid, "SIGKILL");
    await session.send("Page.setWebLifecycleState", { state: "active" });
    await page.getByRole("alert").filter({ hasText: /lost|nothing/ }).waitFor();
    await page.locator("button.verdict", { hasText: "unknown" }).waitFor();
  });
});

test("each car of a bus is drawn with what its own displays say, and doors as they are", async () => {
  const file = join(folder, "three-cars.toml");
  writeFileSync(file, 'network = "bus"\n[vehicle]\ncars = 3\n');
  await shown(["run", file, "--web", "--speed", "60"], async (page, server) => {
    await page.waitForFunction(() => document.querySelectorAll(".cars > svg").length === 3);
    const state = async () => (await (await ask(server, "/api/state")).json()).snapshot;
    await ask(server, "/api/run/pause", { method: "POST", body: JSON.stringify({ paused: true }) });
    await ask(server, "/api/run/seek", { method: "POST", body: JSON.stringify({ time: 548 }) });
    await page.waitForFunction(() => /^9:08/.test(document.querySelector(".clock").innerText));
    const { displays, plant } = await state();
    for (const car of [1, 2, 3]) {
      const shown_there = await page.locator(".cars > svg").nth(car - 1).locator("text").allTextContents();
      const sign = displays.find((each) => each.car === car && /next-stop/.test(each.display));
      assert.ok(shown_there.includes(sign.text.replace(/\s+/g, " ").trim()), `car ${car} says ${shown_there}, its sign ${sign.text}`);
    }
    assert.deepEqual(await page.locator(".bus-door").evaluateAll((all) => all.map((each) => each.getAttribute("class").split(" ")[1])), plant.doors);
  });
});

test("a value that is pinned is drawn", async () => {
  await shown(charger, async (page) => {
    await view(page, "Objects");
    await page.getByLabel("Search").fill("battery_voltage");
    await page.getByRole("button", { name: "Pin to the plots: battery_voltage", exact: true }).first().click();
    await view(page, "Plots");
    await page.locator(".plot canvas").first().waitFor();
    await page.locator(".plot h3", { hasText: /[45][0-9]\.[0-9]+ V/ }).first().waitFor();
  });
});

test("a plot is zoomed by dragging, and is whole again by a double click", async () => {
  await shown(charger, async (page) => {
    await view(page, "Objects");
    await page.getByLabel("Search").fill("battery_voltage");
    await page.getByRole("button", { name: "Pin to the plots: battery_voltage", exact: true }).first().click();
    await view(page, "Plots");
    await page.waitForFunction(() => /^([2-9]|\d\d):/.test(document.querySelector(".clock").innerText));
    await pause(page);
    /** Where a share of the plot's width is: labels of other lengths move its begin. */
    const at = async (share) => {
      const area = await page.locator(".plot .u-over").boundingBox();
      return [area.x + area.width * share, area.y + area.height / 2];
    };
    /** The time under the pointer at the left end, which the legend says. */
    const begin = async () => {
      await page.mouse.move(...await at(0.5));
      await page.mouse.move(...await at(0.0005));
      await page.waitForFunction(() => /^\d+:\d\d\.\d$/.test(document.querySelector(".u-legend .u-value").innerText));
      const [minutes, seconds] = (await page.locator(".u-legend .u-value").first().innerText()).split(":").map(Number);
      return 60 * minutes + seconds;
    };
    const whole = await begin();
    await page.mouse.move(...await at(0.5));
    await page.mouse.down();
    await page.mouse.move(...await at(0.75), { steps: 5 });
    await page.mouse.up();
    const zoomed = await begin();
    assert.ok(zoomed > whole + 10, `from ${zoomed} s, not from ${whole} s`);
    const [from] = new URLSearchParams(new URL(page.url()).hash.slice(1)).get("zoom").split(" ").map(Number);
    assert.ok(Math.abs(zoomed - from) <= 0.1, `the curve begins at ${zoomed} s, where ${from} s are shown`);
    await page.mouse.dblclick(...await at(0.5));
    assert.equal(await begin(), whole);
  });
});

test("a log's time line is dragged, and all is as it was then", async () => {
  const log = join(folder, "night.log");
  run("run", "charger", "--for", "10min", "--log", log);
  await shown(["view", log, "--node", "10=418"], async (page) => {
    await view(page, "Objects");
    await page.getByLabel("Search").fill("6060");
    const value = page.locator(".value-row .strong").first();
    const at_end = parseFloat(await value.innerText());
    const line = page.locator("header input[type=range]");
    const box = await line.boundingBox();
    await page.mouse.move(box.x + box.width - 4, box.y + box.height / 2);
    await page.mouse.down();
    await page.mouse.move(box.x + box.width * 0.1, box.y + box.height / 2, { steps: 8 });
    await page.mouse.up();
    await page.waitForFunction(() => /^[01]:/.test(document.querySelector(".clock").innerText));
    await page.waitForFunction((end) => parseFloat(document.querySelector(".value-row .strong").innerText) < end, at_end);
    await line.press("End");
    await page.waitForFunction((end) => parseFloat(document.querySelector(".value-row .strong").innerText) === end, at_end);
  });
});

/**
 * A minute of two nodes: node 5 is heard for 20 s, then no more; the battery's temperature (CiA 418, 6010h: eighths of a
 * degree, in TPDO1 of node 10) goes from 20 to 21 °C after 30 s; one line is none.
 */
function minute_log() {
  const at = (seconds) => `(${(1_700_000_000 + seconds).toFixed(6)}) can0`;
  const lines = [];
  for (let i = 0; i <= 60; ++i) {
    lines.push(`${at(i)} 70A#05`, `${at(i + 0.1)} 18A#${i < 30 ? "A0" : "A8"}0001`);
    if (i <= 20) lines.push(`${at(i + 0.2)} 705#05`);
    if (i === 40) lines.push("(1700000040.5) can0 cut off he");
  }
  const log = join(folder, "minute.log");
  writeFileSync(log, `${lines.join("\n")}\n`);
  return log;
}

test("a log opens with what matters: who is silent, what could not be read, its traffic and its values", async () => {
  await shown(["view", minute_log(), "--node", "10=418"], async (page) => {
    await page.locator(".summary .headline", { hasText: "1 of 2 nodes is silent" }).waitFor();
    await page.locator(".summary .detail", { hasText: /No heartbeat any more: node 5/ }).waitFor();
    await page.getByRole("alert").filter({ hasText: /1 line of this log could not be read.*line 10[0-9]/s }).waitFor();
    await event(page, /node 5.*: no heartbeat any more/).waitFor();
    await page.locator(".trends", { hasText: "The whole log" }).locator("path.line").waitFor();
    await page.locator(".tiles li.bad", { hasText: /node 5.*silent/s }).waitFor();
    await page.locator(".main-values dd", { hasText: "21.000 °C" }).first().waitFor();
    await page.locator(".main-values, .tiles").first().waitFor();
  });
});

test("a log whose nodes never told their profile says so, and which would explain it", async () => {
  const log = join(folder, "lift.log");
  run("run", "lift", "--for", "2min", "--log", log);
  const told = "No node has told its profile (1000h): PDOs are not decoded; they look like CiA 417-4: --profile 417-4.";
  await shown(["view", log], async (page) => {
    await page.getByRole("alert").getByText(told, { exact: true }).waitFor();
  });
  await shown(["view", log, "--profile", "417-4"], async (page) => {
    await page.locator(".main-values dd").first().waitFor();
    assert.equal(await page.getByText("has told its profile").count(), 0);
  });
});

test("a value of a log is drawn from the log's beginning, though it is pinned at the end", async () => {
  await shown(["view", minute_log(), "--node", "10=418"], async (page, server) => {
    await page.locator(".main-values dd", { hasText: "21.000 °C" }).first().waitFor();
    const past = await (await ask(server, "/api/networks/can0/nodes/10/objects/6010:00/history")).json();
    assert.deepEqual(past, { times: [1_700_000_000.1, 1_700_000_030.1], values: [20, 21] });
    await view(page, "Objects");
    await page.getByLabel("Search").fill("6010:00");
    await page.getByRole("button", { name: /^Pin to the plots/ }).first().click();
    await view(page, "Plots");
    const area = await page.locator(".plot .u-over").boundingBox();
    await page.mouse.move(area.x + area.width * 0.1, area.y + area.height / 2);
    await page.locator(".u-legend .u-value").last().filter({ hasText: /^20$/ }).waitFor();
    await page.mouse.move(area.x + area.width * 0.9, area.y + area.height / 2);
    await page.locator(".u-legend .u-value").last().filter({ hasText: /^21$/ }).waitFor();
    assert.match(await page.locator(".u-legend .u-value").first().innerText(), /^\d\d:\d\d:\d\d\.\d$/, "the time of day, as the clock has it");
    assert.equal(await page.locator(".trend-scale, .u-axis").count() > 0, true);
  });
});

test("a fault that was made is taken back, and the run is the one without it", async () => {
  await shown(charger, async (page) => {
    await page.waitForFunction(() => /^[1-9]:/.test(document.querySelector(".clock").innerText));
    await page.getByLabel("What should go wrong?").selectOption("pilot-loss");
    await page.getByRole("button", { name: "Let it happen" }).click();
    await event(page, "FAULT begins: pilot-loss").waitFor();
    await page.locator(".summary .faults-now", { hasText: /fault pilot-loss, since [1-9]/ }).waitFor();
    await page.getByRole("button", { name: /^Take back pilot-loss/ }).click();
    await page.waitForFunction(() => !location.hash.includes("fault=") && ![...document.querySelectorAll(".events li")].some((each) => each.innerText.includes("FAULT")));
    assert.equal(await page.locator(".faults-now").count(), 0);
  });
});

test("tables are sorted by a click on a head, the other way by a second, and as before by a third", async () => {
  await shown(["run", "lift", "--lifts", "3", "--floors", "12", "--web", "--speed", "60"], async (page) => {
    await page.waitForFunction(() => /^[2-9]:/.test(document.querySelector(".clock").innerText));
    await pause(page);
    const column = (table, number) => table.locator(`tbody td:nth-child(${number})`).allInnerTexts();
    const sorted_by = async (table, title, number) => {
      const before = await column(table, number);
      await table.getByRole("button", { name: title }).click();
      const once = (await column(table, number)).map(parseFloat);
      assert.deepEqual(once, [...once].sort((a, b) => a - b), title);
      await table.getByRole("button", { name: title }).click();
      const twice = (await column(table, number)).map(parseFloat);
      assert.deepEqual(twice, [...once].reverse(), title);
      await table.getByRole("button", { name: title }).click();
      assert.deepEqual(await column(table, number), before, title);
    };
    await sorted_by(page.getByRole("region", { name: "Lifts", exact: true }).locator("table"), "Starts", 6);
    await view(page, "Load");
    await sorted_by(page.locator("table").nth(1), "Frames a second", 2);
    await view(page, "Objects");
    await page.getByRole("button", { name: "Name", exact: true }).click();
    const names = (await page.locator(".value-row.entry .name-cell").allInnerTexts()).map((text) => text.replace(/^.*: /, ""));
    assert.ok(names.length > 5);
    assert.deepEqual(names, [...names].sort((a, b) => a.localeCompare(b, "en", { numeric: true })));
  });
});

test("a visitor goes where the page's user says, and nobody is made up", async () => {
  await shown(["run", "lift", "--floors", "6", "--percent", "0", "--web", "--speed", "20"], async (page) => {
    await page.getByLabel(/^Press a call button/).selectOption("5");
    await page.getByRole("button", { name: "Somebody at floor 2 wants up" }).click();
    await page.getByText("A visitor at floor 2 wants to floor 5.").waitFor();
    await page.getByRole("button", { name: "Somebody at floor 2 wants down" }).click();
    await page.getByText("A visitor at floor 2 wants to floor 1.").waitFor();
    // Both are part of the run: of its command, of the link, and of the address.
    await page.getByRole("button", { name: "Share" }).click();
    const command = await page.locator("#share-command").inputValue();
    assert.match(command, / --act visit:from=2:to=5@[0-9.]+(us|ms|s|min) --act visit:from=2:to=1@[0-9.]+(us|ms|s|min)$/);
    const acts = (url) => new URLSearchParams(new URL(url).hash.slice(1)).getAll("act");
    assert.equal(acts(await page.locator("#share-link").inputValue()).length, 2);
    assert.deepEqual(acts(page.url()), acts(await page.locator("#share-link").inputValue()));
    await page.getByText("2 visitors, reads, writes and commands").waitFor();
  });
});

test("a click on the time of an event goes there", async () => {
  await shown(charger, async (page) => {
    await page.waitForFunction(() => /^([2-9]|\d\d):/.test(document.querySelector(".clock").innerText));
    await pause(page);
    await page.locator(".events li", { hasText: "tells the time" }).locator("button.time").last().click();
    await page.waitForFunction(() => /^0:58/.test(document.querySelector(".clock").innerText));
  });
});

test("time stands when it is told to, goes in steps and back", async () => {
  await shown(charger, async (page) => {
    await page.waitForFunction(() => /^[1-9]:/.test(document.querySelector(".clock").innerText));
    await pause(page);
    const clock = page.locator(".clock");
    const stood = await clock.innerText();
    await page.waitForTimeout(300);
    assert.equal(await clock.innerText(), stood);
    await page.getByRole("button", { name: "Step by 100 ms" }).click();
    await page.waitForFunction((before) => document.querySelector(".clock").innerText !== before, stood);
    await page.getByRole("button", { name: "From the start" }).click();
    await page.waitForFunction(() => document.querySelector(".clock").innerText === "0:00.0");
  });
});

const pages = { lift, charger, taxi: ["run", "taxi", "--web", "--speed", "60"], police: ["run", "police", "--web", "--speed", "60"], bus: ["run", "bus", "--web", "--speed", "60"], excavator: ["run", "excavator", "--web", "--speed", "10"], yard: ["run", "charger", "--chargers", "3", "--batteries", "5", "--goal", "80@06:00", "--web", "--speed", "600"] };
const shots = process.env.CANVOY_SHOTS;
const views = ["World", "Nodes", "Objects", "Frames", "Load", "Events"];

for (const [name, command] of Object.entries(pages)) {
  test(`axe finds nothing serious in ${name}, in light and dark, and nothing is cut off at a phone's width`, async () => {
    const axe = readFileSync(path_of("axe-core"), "utf8");
    await shown(command, async (page) => {
      await page.waitForTimeout(shots ? 8000 : 1500);
      for (const scheme of ["light", "dark"]) {
        await page.emulateMedia({ colorScheme: scheme });
        for (const each of name === "lift" || name === "charger" ? views : ["World"]) {
          await view(page, each);
          await page.waitForTimeout(300);
          await page.evaluate(axe);
          const found = await page.evaluate(() => window.axe.run(document, { runOnly: ["wcag2a", "wcag2aa", "wcag21aa"] }));
          const serious = found.violations.filter((it) => ["serious", "critical"].includes(it.impact));
          assert.deepEqual(serious.map((it) => `${each} ${scheme} ${it.id}: ${it.nodes[0].html.slice(0, 160)} ${it.nodes[0].any[0]?.message ?? ""}`), []);
          assert.doesNotMatch(await page.locator("main").innerText(), /\[object|undefined|NaN/);
          if (shots) await page.screenshot({ path: `${shots}/${name}-${each.toLowerCase()}-${scheme}.png` });
        }
      }
      await page.setViewportSize({ width: 390, height: 800 });
      await view(page, "World");
      await page.waitForTimeout(200);
      const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
      assert.ok(wide <= 0, `the page is ${wide} pixels wider than a phone`);
      if (shots) await page.screenshot({ path: `${shots}/${name}-phone.png` });
      await page.setViewportSize({ width: 1280, height: 720 });
    });
  });
}

test("nothing moves by itself while the page comes", async () => {
  await shown(lift, async (page) => {
    const shift = await page.evaluate(() => new Promise((resolve) => {
      let sum = 0;
      new PerformanceObserver((list) => list.getEntries().forEach((entry) => (sum += entry.hadRecentInput ? 0 : entry.value))).observe({ type: "layout-shift", buffered: true });
      setTimeout(() => resolve(sum), 1500);
    }));
    assert.ok(shift < 0.1, `lay-out shift ${shift}`);
  });
});
