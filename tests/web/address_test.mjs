// What is shown stands in the address: Back goes back, a reload shows the same, a link shows it to others.
//
//     CANVOY=build/canvoy node --test tests/web/address_test.mjs
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { look_at, open_browser, PATIENCE_MS, pause, serve, view } from "./browser.mjs";

let browser;
before(async () => (browser = await open_browser()));
after(async () => browser?.close());

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

const charger = ["run", "charger", "--web", "--speed", "60"];
const shows = (page, name) => page.locator(`main[data-view="${name}"]`).waitFor();
const parts = (page) => new URLSearchParams(new URL(page.url()).hash.slice(1));
/** Until the address has it: it is written when the page knows. */
const says = (page, name, value) =>
  page.waitForFunction(([key, wanted]) => new URLSearchParams(location.hash.slice(1)).get(key) === wanted, [name, value]);

test("Back and Forward go through views, lists and nodes, and a reload stays", async () => {
  await shown(charger, async (page) => {
    await view(page, "Objects");
    await page.getByRole("button", { name: "Tree", exact: true }).click();
    await view(page, "Load");
    await page.goBack();
    await shows(page, "objects");
    await page.locator(".tree").waitFor();
    await page.goBack();
    await page.locator(".value-list").waitFor();
    await page.goBack();
    await shows(page, "world");
    await page.goForward();
    await shows(page, "objects");
    await page.reload();
    await shows(page, "objects");
  });
});

test("filter, search, selection and pins are in the address", async () => {
  await shown(charger, async (page) => {
    await view(page, "Frames");
    await page.getByLabel("Filter").fill("heartbeat and node=10");
    await says(page, "filter", "heartbeat and node=10");
    await page.waitForFunction(() => {
      const services = [...document.querySelectorAll(".frame-list .service")].map((each) => each.innerText);
      return services.length > 3 && services.every((service) => service === "heartbeat");
    });
    await page.getByRole("button", { name: "Pause" }).last().click();
    await page.locator(".frame-list").press("ArrowDown");
    const details = await page.locator(".details").innerText();
    assert.match(parts(page).get("frame"), /^[0-9.]+ sim0 70A#05$/);
    await view(page, "Objects");
    await page.getByLabel("Search").fill("battery voltage");
    await page.getByRole("button", { name: "Pin to the plots: battery_voltage", exact: true }).click();
    assert.equal(parts(page).get("search"), "battery voltage");
    assert.deepEqual(parts(page).getAll("pin"), ["sim0 10 6060:00"]);
    await view(page, "Frames");
    await page.reload();
    assert.equal(await page.getByLabel("Filter").inputValue(), "heartbeat and node=10");
    await page.locator(".details").filter({ hasText: details.split("\n")[0] }).waitFor();
    await view(page, "Plots");
    await page.locator(".plot canvas").first().waitFor();
  });
});

test("time is in the address while it stands, and Back goes back to it", async () => {
  await shown(charger, async (page) => {
    const clock = page.locator(".clock");
    await page.waitForFunction(() => /^[1-9]:/.test(document.querySelector(".clock").innerText));
    await pause(page);
    await page.waitForFunction(() => new URLSearchParams(location.hash.slice(1)).has("at"));
    const stood = await clock.innerText();
    await page.getByRole("slider", { name: "Time line" }).focus();
    await page.keyboard.press("End");
    await page.waitForFunction((before) => document.querySelector(".clock").innerText !== before, stood);
    await page.goBack();
    await page.waitForFunction((before) => document.querySelector(".clock").innerText === before, stood);
    await page.getByRole("button", { name: "Play" }).click();
    await page.waitForFunction(() => !new URLSearchParams(location.hash.slice(1)).has("at"));
  });
});

test("Back takes back a seek of which no state has come yet", { timeout: PATIENCE_MS }, async () => {
  await shown(charger, async (page) => {
    const kept = [];
    let holds = false;
    let seeks = 0;
    let second;
    const is_taken_back = new Promise((resolve) => (second = resolve));
    await page.routeWebSocket(/./, (socket) => {
      const behind = socket.connectToServer();
      socket.onMessage((message) => {
        const { do: what, time } = JSON.parse(message);
        if (what === "seek" && ++seeks === 2) second(time);
        behind.send(message);
      });
      behind.onMessage((message) => {
        if (!holds) return socket.send(message);
        const { answers, ...rest } = JSON.parse(message);
        if (answers) socket.send(JSON.stringify({ answers }));
        kept.push(() => socket.send(JSON.stringify(rest)));
      });
    });
    await page.reload();
    await page.waitForFunction(() => /^[1-9]:/.test(document.querySelector(".clock").innerText));
    await pause(page);
    await page.waitForFunction(() => new URLSearchParams(location.hash.slice(1)).has("at"));
    const stood = parts(page).get("at");
    const clock = await page.locator(".clock").innerText();
    holds = true;
    await page.getByRole("slider", { name: "Time line" }).focus();
    await page.keyboard.press("End");
    await page.waitForFunction((before) => new URLSearchParams(location.hash.slice(1)).get("at") !== before, stood);
    await page.goBack();
    assert.equal(await is_taken_back, Number(stood));
    holds = false;
    kept.forEach((send) => send());
    await page.waitForFunction((before) => document.querySelector(".clock").innerText === before, clock);
  });
});

test("a link of a server that others reach works for whom it is sent to", async () => {
  await shown(["run", "charger", "--web", "0.0.0.0:0", "--speed", "60"], async (page, server) => {
    assert.doesNotMatch(server.url, /0\.0\.0\.0/);
    await page.waitForFunction(() => /^[1-9]:/.test(document.querySelector(".clock").innerText));
    await pause(page);
    await view(page, "Objects");
    await page.getByLabel("Search").fill("temperature");
    const time = await page.locator(".clock").innerText();
    await page.getByRole("button", { name: "Share" }).click();
    const link = await page.locator("#share-link").inputValue();
    assert.match(link, /^http:\/\/(?!127\.|localhost)[0-9.]+:[0-9]+\/\?token=[0-9a-f]{32}#.*search=temperature/);
    assert.equal(await page.getByText("Only this machine reaches this address").count(), 0);
    // Who gets it has no cookie of this server.
    const other = await open_browser();
    try {
      const theirs = await look_at(other.context, link);
      await shows(theirs, "objects");
      assert.equal(await theirs.getByLabel("Search").inputValue(), "temperature");
      await theirs.waitForFunction((wanted) => document.querySelector(".clock").innerText === wanted, time);
      assert.deepEqual(theirs.complaints, []);
    } finally {
      await other.close();
    }
  });
});

test("a link that would move the time of others asks, and a no leaves it", async () => {
  await shown(charger, async (page, server) => {
    await pause(page);
    await page.waitForFunction(() => new URLSearchParams(location.hash.slice(1)).has("at"));
    const stood = await page.locator(".clock").innerText();
    const other = await browser.context.newPage();
    const asked = [];
    other.on("dialog", (dialog) => { asked.push(dialog.message()); void dialog.dismiss(); });
    await other.goto(`${server.url}#view=load&at=600`);
    await shows(other, "load");
    await other.waitForFunction(() => new URLSearchParams(location.hash.slice(1)).get("at") !== "600");
    assert.match(asked[0], /10:00\.0.*everyone/);
    assert.equal(await page.locator(".clock").innerText(), stood);
    await other.close();
  });
});

test("a server of this machine alone says that its link is for nobody else", async () => {
  await shown(charger, async (page) => {
    await page.getByRole("button", { name: "Share" }).click();
    await page.getByText(/Only this machine reaches this address/).waitFor();
  });
});
