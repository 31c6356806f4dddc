// How fast the module plays networks, without a browser: of one lift it has to be so many times real time.
//
//     node playground/measure.cjs build/playground/site 20
"use strict";
const { readFileSync } = require("node:fs");
const { join } = require("node:path");

const [folder, least] = process.argv.slice(2);
const patience_ms = 300_000;
globalThis.canvoy_worker = {};
globalThis.postMessage = () => {};
require(join(__dirname, "worker.js"));
const { load, say, told } = globalThis.canvoy_worker;

/** Speed and memory of ten minutes of it, as a page sees them, in slices of some milliseconds. */
async function play(command) {
  const module = await load(new Uint8Array(readFileSync(join(folder, "canvoy.wasm"))));
  const length = module.canvoy_begin(say(`run ${command} --for 10min`));
  if (length) throw new Error(told(length));
  module.canvoy_connect(false);
  module.canvoy_said(say('{"id":1,"do":"speed","speed":1000000}'));
  const begun = performance.now();
  let end_s = 0;
  let time_s = 0;
  while (end_s === 0 || time_s < end_s) {
    if (performance.now() - begun > patience_ms) throw new Error(`${command}: stands at ${time_s} s`);
    module.canvoy_advance((performance.now() - begun) * 1000);
    const size = module.canvoy_next();
    if (!size) continue;
    const message = JSON.parse(told(size));
    end_s = message.hello?.end ?? end_s;
    time_s = message.state?.time ?? message.change?.time ?? time_s;
  }
  return { times: Math.round(end_s / ((performance.now() - begun) / 1000)), megabytes: Math.round(module.memory.buffer.byteLength / 1e6) };
}

(async () => {
  const all = {};
  for (const command of ["lift", "lift --lifts 8 --floors 20", "charger", "charger --chargers 3 --batteries 5 --goal 80@06:00", "taxi", "police", "bus", "excavator"]) {
    all[command] = await play(command);
    console.log(`${command}: ${all[command].times} times real time, ${all[command].megabytes} MB of memory`);
  }
  if (all.lift.times < Number(least)) {
    console.error(`playground: a lift is to be played at ${least} times real time`);
    process.exit(1);
  }
})();
