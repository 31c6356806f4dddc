// The page of a real bus: what is gone is said to be, and nothing is sent that nobody has asked for.
//
//     python3 tests/own_network.py node --test tests/web/bus_page_test.mjs
import assert from "node:assert/strict";
import { test } from "node:test";
import { look_at, open_browser, serve, start, view } from "./browser.mjs";

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
  } finally {
    await browser.close();
    await server.end();
    device.kill("SIGKILL");
  }
});
