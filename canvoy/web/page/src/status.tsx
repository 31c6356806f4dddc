// Faults of the display, in one line above each view: a lost connection, bus or node, lost frames,
// a truncated log.
import { useEffect, useState } from "preact/hooks";
import { is_current, useLive, type Json } from "./live";
import { texts } from "./texts";

const left_out_from_s = 0.1;

/** Draws again each second while nothing comes from the server. */
function useClock(runs: boolean) {
  const [, tick] = useState(0);
  useEffect(() => {
    if (!runs) return;
    const timer = setInterval(() => tick((n) => n + 1), 1000);
    return () => clearInterval(timer);
  }, [runs]);
}

export function Status() {
  const { hello, state, is_open, is_silent, heard_at, lost_place, frames_lost } = useLive();
  useClock(!is_current());
  if (!hello.kind) return <p class="lost" role="alert">{texts.waiting}</p>;
  const snapshot: Json = state.snapshot ?? {};
  const silent = (snapshot.nodes ?? []).filter((node: Json) => node.state === "silent").map((node: Json) => node.device);
  const lines: string[] = [];
  const age = (performance.now() - heard_at) / 1000;
  if (lost_place) lines.push(texts.lost_place);
  else if (!is_open) lines.push(texts.lost(Math.round(age)));
  else if (is_silent) lines.push(texts.no_news(Math.round(age)));
  const trouble = snapshot.trouble || state.play?.trouble;
  const lost = (snapshot.frames_lost ?? 0) + (state.play?.frames_lost ?? 0);
  if (trouble) lines.push(texts.trouble(trouble));
  else if (snapshot.bus_state && snapshot.bus_state !== "error-active") lines.push(texts.bus_state(snapshot.bus_state));
  if (snapshot.clock_ahead_s) lines.push(texts.clock_ahead(snapshot.clock_ahead_s));
  if (silent.length > 0) lines.push(texts.silent(silent));
  if (lost > 0) lines.push(texts.frames_lost_before(lost));
  for (const line of snapshot.unknown_pdos ?? []) lines.push(texts.unknown_pdos(line));
  if (hello.unreadable > 0) lines.push(texts.unreadable(hello.unreadable, hello.unreadable_at));
  if (hello.of_other_buses > 0) lines.push(texts.of_other_buses(hello.of_other_buses, hello.buses.length));
  if (frames_lost > 0) lines.push(texts.frames_lost(frames_lost));
  if (state.play?.left_out > left_out_from_s) lines.push(texts.left_out(state.play.left_out));
  if (lines.length === 0) return null;
  return <div class="lost" role="alert" aria-label={texts.status}>{lines.map((line) => <p key={line}>{line}</p>)}</div>;
}
