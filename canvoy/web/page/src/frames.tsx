// All frames, in a list that draws only its visible part.
import { useEffect, useLayoutEffect, useRef, useState } from "preact/hooks";
import { part, refine, useAddress } from "./address";
import { ask, live, useLive, watch_frames, type Frame, type Json } from "./live";
import { Card, device_name, time_text, measure_text, useMedia } from "./parts";
import { texts } from "./texts";

const row_height_usual = 26;
const row_height_narrow = 46;  // two lines
const rows_around = 6;

/** The clause that defines this object: `CiA 419, 8.4.1`; looked up once for each object of a node. */
const clauses = new Map<string, string>();
async function find_clause(frame: Frame, index: string): Promise<string> {
  const key = `${frame.bus} ${frame.node} ${index}`;
  const known = clauses.get(key);
  if (known !== undefined) return known;
  const answer = await ask("objects", { bus: frame.bus, node: frame.node ?? 0, search: index });
  const number = parseInt(index, 16);
  const object = (answer.objects ?? []).find((each: Json) => {
    const first = parseInt(each.object, 16);
    return number >= first && number < first + (each.count ?? 1);
  });
  const text = object ? [object.profile, object.clause].filter(Boolean).join(", ") : "";
  clauses.set(key, text);
  return text;
}

function Clause(props: { frame: Frame; index: string }) {
  const [text, set] = useState("");
  useEffect(() => {
    let is_shown = true;
    void find_clause(props.frame, props.index).then((found) => { if (is_shown) set(found); });
    return () => void (is_shown = false);
  }, [props.frame.bus, props.frame.node, props.index]);
  return text ? <span class="clause muted">{text}</span> : null;
}

function Details(props: { frame: Frame | null }) {
  const { frame } = props;
  if (!frame) return <p class="hint">{texts.frame_pick}</p>;
  const [id, data = ""] = frame.frame.split("#");
  const clause = texts.service_clauses.find(([name]) => frame.service.startsWith(name))?.[1];
  const bytes = data.startsWith("R") ? [] : (data.match(/../g) ?? []);
  return (
    <div class="details">
      <h3>
        {frame.service} <span class="muted">{device_name(frame.bus, frame.node)}</span>
      </h3>
      <p>{frame.text}</p>
      <dl>
        <dt>{texts.frame_time}</dt><dd>{time_text(frame.time, 6)}</dd>
        {clause && <><dt>{texts.clause}</dt><dd>{clause}</dd></>}
        <dt>CAN-ID</dt><dd class="mono">{id}h</dd>
        <dt>{texts.raw}</dt><dd class="mono">{bytes.join(" ") || data}</dd>
      </dl>
      {bytes.length > 0 && (
        <table class="bits">
          <tbody>
            {bytes.map((byte, i) => (
              <tr key={i}>
                <th scope="row">{i}</th><td class="mono">{byte}</td>
                <td class="mono">{parseInt(byte, 16).toString(2).padStart(8, "0").replace(/(....)/, "$1 ")}</td>
              </tr>
            ))}
          </tbody>
        </table>
      )}
      {frame.marks?.map((mark) => <p key={mark} class="mark">{mark}</p>)}
      {frame.news && <p class="news">{frame.news}</p>}
      {frame.values?.map((value: Json, i: number) => (
        <p key={i} class="one-value">
          <span class="mono">{value.index}:{value.sub}</span> {value.name}
          <b> {measure_text(value)}</b> <Clause frame={frame} index={value.index} />
        </p>
      ))}
    </div>
  );
}

/** A log that the command writes, if it was started with --allow-record. */
function Recording() {
  const { state, hello } = useLive();
  const [said, say] = useState("");
  const log = state.record ?? {};
  if (!hello.can?.record) return null;
  const toggle = async () => say((await ask("record", { on: !log.on })).error ?? "");
  return (
    <div class="tools recorder">
      <button type="button" class={log.on ? "recording" : ""} aria-pressed={log.on ? "true" : "false"} title={texts.record_label} onClick={() => void toggle()}>
        {log.on ? texts.record_stop : `● ${texts.record}`}
      </button>
      <span class="count muted" role="status">{said || log.trouble || (log.file ? texts.recording(log.file, log.frames) : texts.record_label)}</span>
    </div>
  );
}

/** Identifies a frame in an address. */
const name_of = (frame: Frame) => `${frame.time} ${frame.bus} ${frame.frame}`;

export function Frames() {
  useLive();
  const tried = useAddress()("filter");
  const [filter, set_filter] = useState(tried);
  const typed = useRef(tried);
  const [error, set_error] = useState("");
  const [follows, follow] = useState(part("frame") === "");
  const [held, hold] = useState<Frame[] | null>(null);
  const [picked, set_picked] = useState<Frame | null>(null);
  const top = useRef(0);  // where the list is scrolled to
  const [, scrolled] = useState(0);
  const [height, set_height] = useState(600);
  const list = useRef<HTMLDivElement>(null);
  const row_height = useMedia("(max-width: 720px)") ? row_height_narrow : row_height_usual;

  useEffect(() => {
    if (filter === tried) return;
    const waits = setTimeout(() => refine({ filter: (typed.current = filter) }), 350);
    return () => clearTimeout(waits);
  }, [filter]);
  useEffect(() => {
    if (tried !== typed.current) set_filter((typed.current = tried)); // by Back
  }, [tried]);
  useEffect(() => watch_frames(tried, set_error), [tried, live.hello]);

  const frames = held ?? live.frames;
  const is_at_end = follows && !held;
  const pick = (frame: Frame) => {
    set_picked(frame);
    refine({ frame: name_of(frame) });
  };
  const show = (frame: Frame) => {
    const y = frames.indexOf(frame) * row_height;
    const box = list.current;
    if (!box) return;
    if (y < box.scrollTop) box.scrollTop = y;
    if (y > box.scrollTop + box.clientHeight - row_height) box.scrollTop = y - box.clientHeight + row_height;
  };
  // A link has selected a frame that has not arrived yet.
  const sought = part("frame");
  useEffect(() => {
    if (!sought || (picked && name_of(picked) === sought)) return;
    const found = frames.find((frame) => name_of(frame) === sought);
    if (!found) return;
    set_picked(found);
    follow(false);
    requestAnimationFrame(() => show(found));
  }, [sought, frames.length]);
  useEffect(() => {
    const box = list.current;
    if (!box) return;
    const look = () => set_height(box.clientHeight);
    look();
    const observer = new ResizeObserver(look);
    observer.observe(box);
    return () => observer.disconnect();
  }, []);
  useLayoutEffect(() => {
    if (!is_at_end || !list.current) return;
    top.current = Math.max(0, frames.length * row_height - height);
    list.current.scrollTop = frames.length * row_height;
  });

  const on_scroll = () => {
    const box = list.current;
    // The event of a last scroll arrives when another view is already shown.
    if (!box) return;
    const near_end = box.scrollTop + box.clientHeight >= box.scrollHeight - row_height * 2;
    if (is_at_end && (near_end || box.scrollTop >= top.current)) return;
    top.current = box.scrollTop;
    scrolled(box.scrollTop);
    if (!near_end) follow(false);
  };
  // The end is drawn before the list has been scrolled there.
  const from = is_at_end ? Math.max(0, frames.length * row_height - height) : top.current;
  const first = Math.max(0, Math.floor(from / row_height) - rows_around);
  const shown = frames.slice(first, first + Math.ceil(height / row_height) + 2 * rows_around);
  const move = (by: number) => {
    const at = picked ? frames.indexOf(picked) : first;
    const next = frames[Math.max(0, Math.min(frames.length - 1, at + by))];
    if (!next) return;
    pick(next);
    follow(false);
    show(next);
  };
  const on_key = (event: KeyboardEvent) => {
    const steps: Record<string, number> = { ArrowDown: 1, ArrowUp: -1, PageDown: 20, PageUp: -20 };
    if (!steps[event.key]) return;
    event.preventDefault();
    move(steps[event.key]);
  };
  return (
    <div class="frames-view">
      <Card class="frames">
        <Recording />
        <div class="tools">
          <label class="field grow">
            <span>{texts.filter}</span>
            <input type="search" value={filter} placeholder={texts.filter_example} spellcheck={false} autocomplete="off"
              aria-invalid={error ? "true" : "false"} aria-describedby="filter-error"
              onInput={(event) => set_filter(event.currentTarget.value)} />
          </label>
          <button type="button" aria-pressed={held ? "true" : "false"} onClick={() => hold(held ? null : [...live.frames])}>
            {held ? texts.play : texts.pause}
          </button>
          <label class="check"><input type="checkbox" checked={follows} onChange={(event) => follow(event.currentTarget.checked)} />{texts.follow}</label>
          <span class="muted count">{texts.frames_count(frames.length)}{live.frames_searched < 0 ? texts.frames_full : live.frames_searched < 1 ? texts.frames_searched(live.frames_searched) : ""}</span>
        </div>
        <p class="error" id="filter-error" role="alert">{error}</p>
        {live.frames_lost > 0 && <p class="hint">{texts.frames_lost(live.frames_lost)}</p>}
        <div class="frame-head frame-row" aria-hidden="true">
          <span>{texts.frame_time}</span><span>{texts.frame_bus}</span><span>{texts.frame_frame}</span><span>{texts.frame_service}</span><span>{texts.frame_text}</span>
        </div>
        <div class="frame-list" ref={list} onScroll={on_scroll} onKeyDown={on_key} tabIndex={0} role={frames.length > 0 ? "listbox" : undefined} aria-label={texts.views.frames}>
          {frames.length === 0 && <p class="hint">{texts.frames_none}</p>}
          <div role="presentation" style={{ height: `${frames.length * row_height}px`, position: "relative" }}>
            <div role="presentation" style={{ transform: `translateY(${first * row_height}px)` }}>
              {shown.map((frame, row) => (
                <div key={row} role="option" aria-selected={frame === picked ? "true" : "false"}
                  class={`frame-row ${frame === picked ? "picked" : ""} ${frame.marks ? "marked" : ""} s-${frame.service.split(" ")[0].replace(/[0-9]+$/, "").toLowerCase()}`}
                  onClick={() => { pick(frame); follow(false); }}>
                  <span class="mono">{time_text(frame.time, 4)}</span>
                  <span>{frame.bus}</span>
                  <span class="mono">{frame.frame}</span>
                  <span class="service">{frame.service}</span>
                  <span class="said-text">{device_name(frame.bus, frame.node)}{frame.text ? ": " : ""}{frame.text}</span>
                </div>
              ))}
            </div>
          </div>
        </div>
      </Card>
      <Card class={`detail-card ${picked ? "" : "none"}`}><Details frame={picked} /></Card>
    </div>
  );
}
