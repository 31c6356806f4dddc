// The connection to the server, and its data: a state that is complete at first and then changes,
// events, values of objects, and frames.
import { useEffect, useState } from "preact/hooks";
import { parts_of, refine_lists } from "./address";

export type Json = any;

export interface Value {
  time: number;
  bus: string;
  node: number;
  index: string;
  sub: string;
  name?: string;
  unit?: string;
  raw: string;
  value: number | string | boolean | object | null;
  text?: string; // with its unit
  changes: number; // since the page was opened
}
export interface Frame {
  n: number;
  time: number;
  bus: string;
  frame: string;
  service: string;
  node?: number;
  text?: string;
  values?: Json[];
  marks?: string[];
  news?: string;
}

/** A value from a time on: a number, or the name of a state. */
export type Sample = [time: number, value: number | string];

export const frames_max = 200_000;
const events_max = 10_000;
const samples_max = 20_000;
const quiet_ms = 1000;  // a run that stands says nothing by itself: the server is asked then
const silent_ms = 5000;
const draw_ms = 200;  // between two drawings of lists and tables, which nobody reads faster

export const live = {
  is_open: false,
  is_silent: false,  // the server has said nothing for a while, though it was asked
  heard_at: 0,  // time of the last message of the server, by performance.now()
  lost_place: false,  // lost to a newer viewer: the server requests no other try
  hello: {} as Json,
  state: {} as Json,
  events: [] as Json[],
  values: new Map<string, Value>(), // by place_of()
  samples: new Map<string, Sample[]>(),  // pinned values, by place_of()
  frames: [] as Frame[],
  frames_lost: 0,
  frames_searched: 1,  // for a log, by a filter; -1: more match than are reported
  rates: {} as Json,  // of each bus: frames and bits per second, by node and service
  pictures: 0,  // number of states received
};

/** What the page says and hears: a server's, or what plays a network here in its place (playground/playground.js). */
type Socket = Pick<WebSocket, "send" | "onopen" | "onmessage" | "onclose">;
const here: ((url: string) => Socket) | undefined = (globalThis as Json).canvoy_socket;
/** There is no server: what is chosen stands in the address, and nobody else looks on. */
export const plays_here = !!here;

let socket: Socket | null = null;
let last_id = 0;
let frame_number = 0;
let wanted: (() => void)[] = [];  // messages to send at each connection
let frames_asked = 0;  // the unanswered request for frames: frames before its answer belong to another filter
const waiting = new Map<number, (answer: Json) => void>();
const listeners = new Set<() => void>();
let is_due = false;  // with the next picture of the screen
let timer: ReturnType<typeof setTimeout> | undefined;
let drawn_at = -Infinity;
let moves = false;

/** Sets whether the view has a picture that moves: it is drawn with each message. */
export const draw_each = (each: boolean) => void (moves = each);

function draw() {
  clearTimeout(timer);
  timer = undefined;
  is_due = false;
  drawn_at = performance.now();
  listeners.forEach((listener) => listener());
}

/** Draws what has changed, once for all changes until then: with the next picture of the screen, or later if it has time. */
function changed(has_time = false) {
  if (is_due) return;
  const wait = document.hidden ? 500 : has_time ? drawn_at + draw_ms - performance.now() : 0;
  if (wait > 0) {
    timer ??= setTimeout(draw, wait);
    return;
  }
  is_due = true;
  requestAnimationFrame(draw);
}

/** Draws a component again whenever a message has arrived. */
export function useLive() {
  const [, set] = useState(0);
  useEffect(() => {
    const listener = () => set((n) => n + 1);
    listeners.add(listener);
    return () => void listeners.delete(listener);
  }, []);
  return live;
}

/** Applies a merge patch (RFC 7386). */
export function merge(target: Json, patch: Json): Json {
  if (patch === null || typeof patch !== "object" || Array.isArray(patch)) return patch;
  const made = target && typeof target === "object" && !Array.isArray(target) ? { ...target } : {};
  for (const [key, value] of Object.entries(patch)) {
    if (value === null) delete made[key];
    else made[key] = merge(made[key], value);
  }
  return made;
}

let counted: { at: number; counts: Json } | null = null;

/** Frames and bits a second of each bus, and of its nodes and services. */
function rates_between(counts: Json, before: Json, passed: number): Json {
  const rate = (now: Json, old: Json) => ({
    frames: (now.frames - (old?.frames ?? 0)) / passed,
    bits: (now.bits - (old?.bits ?? 0)) / passed,
  });
  const parts = (now: Json, old: Json) => Object.fromEntries(Object.entries<Json>(now).map(([name, each]) => [name, rate(each, old?.[name])]));
  return Object.fromEntries(Object.entries<Json>(counts).map(([bus, now]) => [
    bus, { ...rate(now, before[bus]), nodes: parts(now.nodes, before[bus]?.nodes), services: parts(now.services, before[bus]?.services) },
  ]));
}

/** Rates from two counts at least a second apart, by the time of the run; of the first count, the mean from the start. */
function count() {
  const { counted: time, counts } = live.state;
  if (!counts) return;
  if (counted && time < counted.at) counted = null;
  if (counted && time - counted.at < 1) return;
  const passed = time - (counted?.at ?? live.hello.begin ?? 0);
  if (passed > 0 && (counted || live.hello.kind !== "bus")) live.rates = rates_between(counts, counted?.counts ?? {}, passed);
  counted = { at: time, counts };
}

function begin_anew(hello: Json) {
  const is_first = !live.hello.kind;
  live.hello = hello;
  if (is_first) restore_pins();
  live.events = [];
  live.values = new Map();
  live.frames = [];
  live.frames_lost = 0;
  live.samples.forEach((samples) => (samples.length = 0));
  remember_all();
  counted = null;
  live.rates = {};
  document.title = `Canvoy: ${hello.kind}`;
}

/** Key of a value, with the name of the bus; keys of the server have its number. */
export const place_of = (of: { bus: string; node: number; index: string; sub: string }) => `${of.bus} ${of.node} ${of.index}:${of.sub}`;

function take_values(values: Json) {
  for (const { values: list, ...place } of Object.values<Json>(values)) {
    const value = { ...place, ...list[0] };
    const key = place_of(value);
    value.changes = (live.values.get(key)?.changes ?? 0) + 1;
    live.values.set(key, value);
    const samples = live.samples.get(key);
    const sampled = sampled_value(value);
    const last = samples?.at(-1);
    if (samples && sampled !== null && sampled !== last?.[1] && value.time > (last?.[0] ?? -Infinity)) {
      samples.push([value.time, sampled]);
      if (samples.length > samples_max) samples.splice(0, samples_max / 10);
    }
  }
}

function sampled_value(value: Value): number | string | null {
  const it = value.value;
  return typeof it === "number" || typeof it === "string" ? it : typeof it === "boolean" ? Number(it) : null;
}

/** The past of a pinned value, from the server; later samples stay. */
async function remember(key: string) {
  const [place, sub] = key.split(":");
  const [bus, node, index] = [place.split(" ").slice(0, -2).join(" "), ...place.split(" ").slice(-2)];
  const { times, values } = await ask("history", { bus, node: Number(node), object: `${index}:${sub}` });
  const samples = live.samples.get(key);
  if (!samples || !times?.length) return;
  const past = times.map((time: number, i: number): Sample => [time, values[i]]);
  live.samples.set(key, [...past, ...samples.filter(([time]) => time > times.at(-1))]);
  changed();
}

const remember_all = () => live.samples.forEach((_, key) => void remember(key));

function take(message: Json) {
  const was_seeking = live.state.play?.seeking;
  if (message.hello) begin_anew(message.hello);
  if (message.state) live.state = message.state;
  if (message.change) live.state = merge(live.state, message.change);
  if (message.state || message.change) {
    ++live.pictures;
    count();
    if (was_seeking && !live.state.play?.seeking) remember_all();  // only the ends of steps were told on the way
  }
  if (message.events) {
    live.events.push(...message.events);
    if (live.events.length > events_max) live.events.splice(0, live.events.length - events_max);
  }
  if (message.values) take_values(message.values);
  if (message.answers?.some((answer: Json) => answer.id === frames_asked)) {
    frames_asked = 0;
    live.frames = [];
  }
  if (message.frames && !frames_asked) {
    for (const frame of message.frames) {
      frame.n = ++frame_number;
      live.frames.push(frame);
    }
    if (live.frames.length > frames_max * 1.1) live.frames.splice(0, live.frames.length - frames_max);
  }
  if (message.frames_searched !== undefined) live.frames_searched = message.frames_searched;
  if (message.frames_lost) live.frames_lost += message.frames_lost;
  for (const answer of message.answers ?? []) {
    waiting.get(answer.id)?.(answer);
    waiting.delete(answer.id);
  }
  changed(!moves && !message.hello && !message.answers);
}

/** What is shown is of now: the server is there, and answers. */
export const is_current = () => live.is_open && !live.is_silent;

/** A connection may be dead without an end, as behind a laptop that has slept. */
function watch_silence() {
  let asks = false;
  setInterval(() => {
    if (!live.is_open) return;
    const silence = performance.now() - live.heard_at;
    if (silence > quiet_ms && !asks) {
      asks = true;
      void ask("values", { on: told_values }).then(() => (asks = false));
    }
    if (silence <= silent_ms) return;
    live.is_silent = true;
    changed();
  }, quiet_ms);
}

export function start() {
  connect();
  watch_silence();
}

function connect() {
  told_values = wants_values();
  const url = `ws://${location.host}/live${told_values ? "" : "?values=off"}`;
  socket = here ? here(url) : new WebSocket(url);
  socket.onopen = () => {
    live.is_open = true;
    live.is_silent = false;
    live.heard_at = performance.now();
    tell_values();
    wanted.forEach((say) => say());
    changed();
  };
  socket.onmessage = (event) => {
    live.heard_at = performance.now();
    live.is_silent = false;
    take(JSON.parse(event.data));
  };
  socket.onclose = (event) => {
    live.is_open = false;
    live.lost_place = event.code === 1013;
    waiting.forEach((answer) => answer({ error: "the connection is lost" }));
    waiting.clear();
    changed();
    if (!live.lost_place) setTimeout(connect, 1000);
  };
}

/** Sends a request to the server; the answer has `error` if it was refused. */
export function ask(what: string, members: Json = {}): Promise<Json> {
  return new Promise((resolve) => {
    if (!live.is_open || !socket) return resolve({ error: "there is no connection" });
    const id = ++last_id;
    waiting.set(id, resolve);
    socket.send(JSON.stringify({ id, do: what, ...members }));
  });
}

/** Requests frames until the returned function is called. */
export function watch_frames(filter: string, done: (error: string) => void): () => void {
  const say = () => {
    live.frames = [];
    live.frames_lost = 0;
    live.frames_searched = 1;
    void ask("frames", { on: true, filter }).then((answer) => done(answer.error ?? ""));
    frames_asked = live.is_open ? last_id : 0;
  };
  wanted.push(say);
  if (live.is_open) say();
  return () => {
    wanted = wanted.filter((each) => each !== say);
    void ask("frames", { on: false });
  };
}

let view_wants_values = false;
const wants_values = () => view_wants_values || live.samples.size > 0;
let told_values = false;  // known to the server

function tell_values() {
  if (!live.is_open || told_values === wants_values()) return;
  told_values = wants_values();
  void ask("values", { on: told_values });
}

/** Sets whether the view shows values of objects. Pinned values are sent for all views. */
export function want_values(wants: boolean) {
  view_wants_values = wants;
  tell_values();
}

/** The pinned values: from the address, or else from the last visit. */
function restore_pins() {
  let all = parts_of("pin");
  try {
    if (all.length === 0) all = JSON.parse(localStorage.getItem(pin_key()) ?? "[]");
  } catch {
    // A browser may forbid it, or another version has written it.
  }
  if (!Array.isArray(all)) return;
  for (const key of all.map(String)) if (!live.samples.has(key)) live.samples.set(key, first_sample(key));
  remember_all();
  if (all.length > 0) refine_lists({ pin: pins() });
  tell_values();
}

function first_sample(key: string): Sample[] {
  const value = live.values.get(key);
  const sampled = value ? sampled_value(value) : null;
  return sampled === null ? [] : [[value!.time, sampled]];
}

const pin_key = () => `pins of ${live.hello.kind}`;
export function pins(): string[] {
  return [...live.samples.keys()];
}
export function pin(key: string) {
  if (!live.samples.delete(key)) {
    live.samples.set(key, first_sample(key));
    void remember(key);
  }
  tell_values();
  refine_lists({ pin: pins() });
  try {
    localStorage.setItem(pin_key(), JSON.stringify(pins()));
  } catch {
    // A browser may forbid it: pins are not kept then.
  }
  changed();
}
