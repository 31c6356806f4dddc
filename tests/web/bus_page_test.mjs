// The page of a real bus: what is gone is said to be, and nothing is sent that nobody has asked for.
//
//     python3 tests/own_network.py node --test tests/web/bus_page_test.mjs
import assert from "node:assert/strict";
import { createServer } from "node:net";
import { test } from "node:test";
import { ask, look_at, open_browser, serve, start, view } from "./browser.mjs";

test("a node that was killed, and a bus that has one gone, are not shown as before", async () => {
  const bus = "udp:239.74.163.44:43144";
  const device = start("device", "charger", bus, "--node-id", "5");
  const server = await serve("view", bus, "--allow-write", "nmt");
  const browser = await open_browser();
  try {
    const page = await look_at(browser.context, server.url);
    await view(page, "Nodes");
    const state = page.locator("main .state", { hasText: "operational" });
    await state.first().waitFor();
    const asked = [];
    page.on("dialog", (dialog) => { asked.push(dialog.message()); void dialog.dismiss(); });
    const pick = page.getByRole("combobox", { name: /^NMT/ });
    await pick.focus();
    await page.keyboard.press("ArrowDown");
    assert.deepEqual(asked, [], "a key in a list sends nothing");
    await page.getByRole("button", { name: /^Send/ }).click();
    assert.match(asked[0], /Send "stop" to .* on a real bus\?/);
    device.kill("SIGKILL");
    await page.getByRole("alert").filter({ hasText: /No heartbeat any more/ }).waitFor();
    await page.locator("main .state", { hasText: "silent" }).waitFor();
    await view(page, "Overview");
    await page.locator(".summary .headline", { hasText: "1 of 1 nodes is silent" }).waitFor();
    await page.locator(".events li", { hasText: /no heartbeat any more/ }).waitFor();
  } finally {
    await browser.close();
    await server.end();
    device.kill("SIGKILL");
  }
});

/** A socketcand as its protocol has it, with one node that is heard each 200 ms; gives what ends it. */
function remote_bus(port) {
  const clients = new Set();
  const server = createServer((socket) => {
    clients.add(socket);
    socket.on("error", () => {});
    socket.write("< hi >");
    let is_raw = false;
    const beat = setInterval(() => is_raw && socket.write("< frame 705 1.000000 05 >"), 200);
    socket.on("data", (data) => {
      for (const [request] of String(data).matchAll(/<[^>]*>/g)) {
        if (/open|rawmode/.test(request)) socket.write("< ok >");
        is_raw ||= request.includes("rawmode");
      }
    });
    socket.on("close", () => { clearInterval(beat); clients.delete(socket); });
  });
  return new Promise((resolve) => server.listen(port, "127.0.0.1", () => resolve({
    port: server.address().port,
    end: () => new Promise((ended) => { server.close(ended); clients.forEach((each) => each.destroy()); }),
  })));
}

test("a bus that is off, and a clock that was set, are said first, and nothing is green", async () => {
  const remote = await remote_bus(0);
  const server = await serve("view", `tcp:127.0.0.1:${remote.port}/can0`);
  const browser = await open_browser();
  try {
    const page = await browser.context.newPage();
    let told = {};  // what no adapter of this machine says, and no clock that tests may set
    await page.routeWebSocket(/\/live/, (socket) => {
      socket.connectToServer().onMessage((text) => {
        const message = JSON.parse(text);
        for (const state of [message.state, message.change]) if (state?.snapshot) Object.assign(state.snapshot, told);
        else if (state) state.snapshot = told;
        socket.send(JSON.stringify(message));
      });
    });
    await page.goto(server.url);
    await page.locator(".summary.good .headline", { hasText: "The only node is operational" }).waitFor();
    for (const [state, tone, headline] of [
      ["error-passive", "warn", "The bus is error-passive."],
      ["bus-off", "bad", "This program is bus-off"],
    ]) {
      told = { bus_state: state };
      await page.locator(`.summary.${tone} .headline`, { hasText: headline }).waitFor();
      await page.getByRole("alert").filter({ hasText: `The bus is ${state}.` }).waitFor();
      assert.equal(await page.locator(".summary.good").count(), 0);
    }
    told = { bus_state: "error-active", clock_ahead_s: 3600 };
    await page.getByRole("alert").filter({ hasText: "all times here are 3600 s behind it" }).waitFor();
    told = { bus_state: "error-active", clock_ahead_s: -5 };
    await page.getByRole("alert").filter({ hasText: "all times here are 5 s ahead of it" }).waitFor();
  } finally {
    await browser.close();
    await server.end();
    await remote.end();
  }
});

test("a bus that is lost is said to be, in the first line and as an event, and so is that it is back", async () => {
  let remote = await remote_bus(0);
  const bus = `tcp:127.0.0.1:${remote.port}/can0`;
  const server = await serve("view", bus, "--allow-write", "all");
  const browser = await open_browser();
  try {
    const page = await look_at(browser.context, server.url);
    await page.locator(".summary .headline", { hasText: "The only node is operational" }).waitFor();
    await page.locator(".figure", { hasText: /frames a second\s*[4-6]$/ }).waitFor();
    await page.locator(".trends path.line").waitFor();
    const { port } = remote;
    await remote.end();
    await page.locator(".summary.bad .headline", { hasText: "The bus is lost" }).waitFor();
    await page.getByRole("alert").filter({ hasText: /The bus: .*closed the connection/ }).waitFor();
    await page.locator(".events li.bad", { hasText: "the bus is lost" }).waitFor();
    await page.locator(".events li.bad", { hasText: "node 5 (05h): no heartbeat any more" }).waitFor();
    // It would be carried out when the bus comes back.
    const path = `/api/networks/${encodeURIComponent(bus)}/nodes/5/objects/1017`;
    const answer = await ask(server, path, { method: "POST", body: JSON.stringify({ value: "300ms" }) });
    assert.equal(answer.status, 409);
    assert.match((await answer.json()).error, /^the bus is lost: .*closed the connection/);
    remote = await remote_bus(port);
    await page.locator(".events li.good", { hasText: "the bus is back" }).waitFor();
    await page.locator(".summary.good .headline", { hasText: "The only node is operational" }).waitFor();
    await page.locator(".events li.good", { hasText: "its heartbeat is back" }).waitFor();
    assert.equal(await page.getByRole("alert").count(), 0);
  } finally {
    await browser.close();
    await server.end();
    await remote.end();
  }
});
