// The latest value of each object that was heard: process values first, those of an object in one
// row until it is opened, and communication parameters folded. Search results are ranked.
import { useEffect, useRef, useState } from "preact/hooks";
import { part, refine, useAddress } from "./address";
import { live, pin, pins, place_of, useLive, type Value } from "./live";
import { device_name, is_old, measure_text, owner_name, time_text } from "./parts";
import { SortHead, useSorted } from "./sorted";
import { texts } from "./texts";

const row_height = 34;
const rows_around = 8;
const first_own_index = "2000";  // below it are communication parameters (CiA 301, 7.4.1)
const first_profile_index = "6000";

interface Row {
  kind: "device" | "object" | "entry" | "group";
  key: string;
  text: string;
  level: number;
  values: Value[];
  is_open?: boolean;
}

const plain = (text: string) => text.toLowerCase().replace(/[_-]/g, " ");

/** Quality of the match of a value with the search: 0 is best; -1: no match. */
export function rank_of(value: Value, sought: string): number {
  const name = plain(value.name ?? "");
  const address = `${value.index}:${value.sub}`.toLowerCase();
  const words = sought.split(" ").filter(Boolean);
  const behind = value.index < first_own_index ? 10 : 0;
  if (address.startsWith(sought)) return 0;
  if (!words.every((word) => name.includes(word))) return -1;
  const own = name.split(", ").at(-1)!;
  if (name === sought || own === sought) return 1 + behind;
  if (name.startsWith(sought) || own.startsWith(sought)) return 2 + behind;
  return (words.every((word) => ` ${name}`.includes(` ${word}`)) ? 3 : 4) + behind;
}

const process_first = (a: Value, b: Value) => {
  const group = (value: Value) => (value.index >= first_profile_index ? 0 : value.index >= first_own_index ? 1 : 2);
  return group(a) - group(b) || (a.index + a.sub).localeCompare(b.index + b.sub);
};

/** Head of each column: its class, its title, and what it sorts by. */
const columns: [string, string, ((value: Value) => string | number)?][] = [
  ["pin", texts.pin_short],
  ["index", texts.object, (value) => value.index + value.sub],
  ["name", texts.name_short, (value) => value.name ?? ""],
  ["value", texts.value, (value) => (typeof value.value === "number" ? value.value : measure_text(value))],
  ["raw", texts.raw],
  ["time", texts.changed_at, (value) => -value.time],
];
const sort_columns = Object.fromEntries(columns.flatMap(([name, , of]) => (of ? [[name, of]] : [])));

const entry_row = (value: Value): Row => ({ kind: "entry", key: place_of(value), text: value.name ?? "", level: 1, values: [value] });

function ranked(all: Value[], sought: string): Value[] {
  return all
    .map((value) => ({ value, rank: rank_of(value, sought) }))
    .filter(({ rank }) => rank >= 0)
    .sort((a, b) => a.rank - b.rank || process_first(a.value, b.value))
    .map(({ value }) => value);
}

/** Values of one index: a row for all, and one for each if it is open. */
function object_rows(values: Value[], open: Set<string>, level: number): Row[] {
  const [first] = values;
  if (values.length === 1) return [{ kind: "entry", key: place_of(first), text: first.name ?? "", level, values }];
  const key = `${first.bus} ${first.node} ${first.index}`;
  const is_open = open.has(key);
  const head: Row = { kind: "object", key, text: (first.name ?? "").split(", ")[0], level, values, is_open };
  const entries = values.map((value): Row => ({ kind: "entry", key: place_of(value), text: value.name ?? "", level: level + 1, values: [value] }));
  return is_open ? [head, ...entries] : [head];
}

function grouped(all: Value[], open: Set<string>): Row[] {
  const devices = new Map<string, Value[]>();
  for (const value of all) {
    const key = `${value.bus} ${value.node}`;
    if (!devices.get(key)?.push(value)) devices.set(key, [value]);
  }
  const rows: Row[] = [];
  for (const [device, values] of [...devices].sort(([a], [b]) => a.localeCompare(b, "en", { numeric: true }))) {
    const { bus, node } = values[0];
    rows.push({ kind: "device", key: device, text: node === 0 ? bus : `${device_name(bus, node)}`, level: 1, values });
    const objects = new Map<string, Value[]>();
    for (const value of values.sort(process_first)) if (!objects.get(value.index)?.push(value)) objects.set(value.index, [value]);
    const plumbing = [...objects].filter(([index]) => index < first_own_index);
    for (const [index, each] of objects) if (index >= first_own_index) rows.push(...object_rows(each, open, 2));
    if (plumbing.length === 0) continue;
    const key = `${device} communication`;
    rows.push({ kind: "group", key, text: texts.communication(plumbing.length), level: 2, values: plumbing.flatMap(([, each]) => each), is_open: open.has(key) });
    if (open.has(key)) plumbing.forEach(([, each]) => rows.push(...object_rows(each, open, 3)));
  }
  return rows;
}

function Pin(props: { value: Value }) {
  const key = place_of(props.value);
  const is_pinned = pins().includes(key);
  return (
    <button type="button" class="icon" aria-pressed={is_pinned ? "true" : "false"} aria-label={`${is_pinned ? texts.unpin : texts.pin}: ${props.value.name ?? props.value.index}`} onClick={() => pin(key)}>
      {is_pinned ? "★" : "☆"}
    </button>
  );
}

function RowView(props: { row: Row; names_device: boolean; toggle: () => void }) {
  const { row } = props;
  const [value] = row.values;
  const folds = row.kind === "object" || row.kind === "group";
  const name = folds ? (
    <button type="button" class="fold" aria-expanded={row.is_open ? "true" : "false"} onClick={props.toggle}>
      <span aria-hidden="true">{row.is_open ? "▾" : "▸"}</span> {row.text}
    </button>
  ) : row.text;
  const latest = row.values.reduce((last, each) => (each.time > last.time ? each : last));
  const is_value = row.kind === "entry";
  return (
    <div role="row" aria-level={row.level} aria-expanded={folds ? (row.is_open ? "true" : "false") : undefined} class={`value-row ${row.kind} level-${row.level} ${is_value && is_old(value) ? "old" : ""}`}>
      <span role="gridcell" class="pin-cell">{is_value && <Pin value={value} />}</span>
      <span role="gridcell" class="mono index-cell">{is_value ? `${value.index}:${value.sub}` : row.kind === "object" ? value.index : ""}</span>
      <span role="gridcell" class="name-cell" title={row.text}>{props.names_device && is_value && <span class="muted">{owner_name(value)}: </span>}{name}</span>
      <span role="gridcell" class="strong value-cell" title={is_value ? measure_text(value) : undefined}>{is_value ? measure_text(value) : row.kind === "device" ? "" : texts.entries_count(row.values.length)}</span>
      <span role="gridcell" class="mono muted raw-cell">{is_value && value.raw}</span>
      <span role="gridcell" class="muted time-cell" title={time_text(latest.time, 1)}>{row.kind !== "device" && row.kind !== "group" && texts.ago(Math.max(0, live.state.time - latest.time))}</span>
    </div>
  );
}

/** Draws only the visible part. */
function useWindow(count: number) {
  const box = useRef<HTMLDivElement>(null);
  const [top, set_top] = useState(0);
  const [height, set_height] = useState(600);
  useEffect(() => {
    if (!box.current) return;
    const observer = new ResizeObserver(() => box.current && set_height(box.current.clientHeight));
    observer.observe(box.current);
    return () => observer.disconnect();
  }, []);
  const first = Math.max(0, Math.min(Math.floor(top / row_height), count - 1) - rows_around);
  const last = Math.min(count, first + Math.ceil(height / row_height) + 2 * rows_around);
  return { box, first, last, on_scroll: () => box.current && set_top(box.current.scrollTop) };
}

export function Heard(props: { search: string; bus: string; node: string }) {
  const { values } = useLive();
  useAddress();
  const open = new Set(part("object").split(",").filter(Boolean));
  const sought = plain(props.search).trim();
  const all = [...values.values()].filter((value) => (!props.bus || value.bus === props.bus) && (!props.node || String(value.node) === props.node));
  const is_sorted = part("sort").replace("-", "") in sort_columns;
  const listed = sought ? ranked(all, sought) : all.filter((value) => value.index >= first_own_index);
  const flat = useSorted(listed, sort_columns);
  const rows = sought || is_sorted ? flat.map(entry_row) : grouped(all, open);
  const { box, first, last, on_scroll } = useWindow(rows.length);
  const toggle = (key: string) => {
    if (!open.delete(key)) open.add(key);
    refine({ object: [...open].join(",") });
  };
  if (rows.length === 0) return <p class="hint">{sought && all.length > 0 ? texts.objects_none : texts.values_none}</p>;
  return (
    <div class="value-list" ref={box} onScroll={on_scroll} tabIndex={0} role="treegrid" aria-label={texts.heard} aria-rowcount={rows.length}>
      <div role="row" class="value-row value-head">
        {columns.map(([name, title, of]) => (of ? <SortHead key={name} by={name} title={title} class={`${name}-cell`} inline /> : <span role="columnheader" class={`${name}-cell`} key={name}>{title}</span>))}
      </div>
      <div role="presentation" style={{ height: `${first * row_height}px` }} />
      {rows.slice(first, last).map((row) => <RowView key={row.key} row={row} names_device={!!sought || is_sorted} toggle={() => toggle(row.key)} />)}
      <div role="presentation" style={{ height: `${(rows.length - last) * row_height}px` }} />
    </div>
  );
}
