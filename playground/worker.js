// Plays a network by the module of playground.cpp, and tells the page what a server would: messages
// of its WebSocket, and answers of its API.
"use strict";

const look_period_ms = 50;
const messages_at_once = 20;
const encoder = new TextEncoder();
const decoder = new TextDecoder();
let module = null; // what it exports
let is_played = false;
let is_looked_at = false;

const bytes = () => new Uint8Array(module.memory.buffer);
const view = () => new DataView(module.memory.buffer);
const told = (length) => decoder.decode(bytes().subarray(module.canvoy_output(), module.canvoy_output() + length));

function say(text) {
  const said = encoder.encode(text);
  bytes().set(said, module.canvoy_input(said.length));
  return said.length;
}

/** Of WASI what the standard library asks for: a clock, and somewhere to complain. The rest is not there. */
function system() {
  const not_there = 52; // ENOSYS
  const nothing = (...places) => {
    for (const place of places) view().setUint32(place, 0, true);
    return 0;
  };
  const calls = {
    clock_time_get(id, _precision, place) {
      const now_ms = id === 0 ? Date.now() : performance.now();
      view().setBigUint64(place, BigInt(Math.round(now_ms * 1e6)), true);
      return 0;
    },
    fd_write(_file, places, count, written) {
      let text = "";
      let length = 0;
      for (let i = 0; i < count; ++i) {
        const [at, size] = [0, 4].map((member) => view().getUint32(places + 8 * i + member, true));
        text += decoder.decode(bytes().subarray(at, at + size));
        length += size;
      }
      console.warn(text);
      view().setUint32(written, length, true);
      return 0;
    },
    environ_sizes_get: nothing,
    environ_get: () => 0,
    args_sizes_get: nothing,
    args_get: () => 0,
    fd_close: () => 0,
    proc_exit(status) {
      throw new Error(`the network has ended with ${status}`);
    },
  };
  return new Proxy({}, { get: (_, name) => calls[name] ?? (() => not_there) });
}

async function load(source) {
  const imports = { wasi_snapshot_preview1: system(), env: system() };
  const { instance } =
    source instanceof Uint8Array ? await WebAssembly.instantiate(source, imports)
    : await WebAssembly.instantiateStreaming(fetch(source), imports);
  module = instance.exports;
  module._initialize?.();
  return module;
}

function look() {
  if (!is_played) return;
  module.canvoy_advance(performance.now() * 1000);
  for (let i = 0; is_looked_at && i < messages_at_once; ++i) {
    const length = module.canvoy_next();
    if (length) postMessage({ message: told(length) });
    if (!module.canvoy_is_behind()) break;
  }
}

const deeds = {
  async begin(command) {
    if (!module) await load("canvoy.wasm");
    const length = module.canvoy_begin(say(command));
    is_played = length === 0;
    postMessage(is_played ? { playing: command } : { refused: told(length) });
  },
  connect(wants_values) {
    module.canvoy_connect(wants_values);
    is_looked_at = true;
  },
  said(text) {
    if (!is_played) return;
    module.canvoy_said(say(text));
    look();
  },
  get({ path, id }) {
    postMessage({ got: is_played ? told(module.canvoy_get(say(path))) : "", id });
  },
};

if (typeof importScripts === "function") {
  onmessage = async ({ data }) => {
    try {
      for (const [deed, what] of Object.entries(data)) await deeds[deed](what);
    } catch (error) {
      is_played = false;
      postMessage({ refused: `the network cannot be played here: ${error.message}` });
    }
  };
  setInterval(() => {
    try {
      look();
    } catch (error) {
      is_played = false;
      postMessage({ refused: `the network has ended: ${error.message}` });
    }
  }, look_period_ms);
}
if (typeof globalThis.canvoy_worker === "object") Object.assign(globalThis.canvoy_worker, { load, say, told });
