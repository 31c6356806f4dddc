// Small components of several views.
import type { ComponentChildren } from "preact";
import { useEffect, useState } from "preact/hooks";
import { live, type Value } from "./live";
import { texts } from "./texts";

const pad = (n: number) => String(n).padStart(2, "0");

/** True for times of buses and their logs, which are calendar times; those of runs begin at 0. */
const is_calendar = (seconds: number) => seconds > 4e8;

/** `1:02:03.4` for a run, or the time of day for a bus, in the time zone of the browser. Further digits are cut, not rounded. */
export function time_text(seconds: number | undefined, digits = 1): string {
  if (seconds === undefined || !Number.isFinite(seconds)) return "–";
  const part = 10 ** digits;
  const parts = Math.floor(seconds * part + 1e-6);  // 1e-6 of a part: rounding error of a double, as for 0.3
  const whole = Math.floor(parts / part);
  const rest = digits ? `.${String(parts - whole * part).padStart(digits, "0")}` : "";
  if (is_calendar(seconds)) {
    const day = new Date(whole * 1000);
    return `${pad(day.getHours())}:${pad(day.getMinutes())}:${pad(day.getSeconds())}${rest}`;
  }
  const h = Math.floor(whole / 3600);
  const m = Math.floor(whole / 60) % 60;
  return `${h ? `${h}:${pad(m)}` : m}:${pad(whole % 60)}${rest}`;
}

/** The date and the time zone of times of day; empty for times of a run. */
export function day_text(seconds: number | undefined): string {
  if (seconds === undefined || !is_calendar(seconds)) return "";
  const day = new Date(seconds * 1000);
  const minutes = -day.getTimezoneOffset();
  const zone = `UTC${minutes < 0 ? "−" : "+"}${Math.floor(Math.abs(minutes) / 60)}${minutes % 60 ? `:${pad(Math.abs(minutes) % 60)}` : ""}`;
  return `${day.getFullYear()}-${pad(day.getMonth() + 1)}-${pad(day.getDate())}, ${zone}`;
}

export function number_text(value: number): string {
  if (!Number.isFinite(value)) return "–";
  const size = Math.abs(value);
  return value.toLocaleString("en", { maximumFractionDigits: size >= 100 ? 1 : size >= 1 ? 2 : 3 });
}

/** A tick of an axis, with the digits that tell it from the next one. */
export function tick_text(value: number, step: number): string {
  const digits = Math.min(12, Math.max(0, -Math.floor(Math.log10(step) + 1e-9)));
  return value.toLocaleString("en", { minimumFractionDigits: digits, maximumFractionDigits: digits });
}

export function value_text(value: unknown): string {
  if (value === null || value === undefined) return "–";
  if (typeof value === "number") return number_text(value);
  if (typeof value === "object") return fields_text(value);
  return String(value);
}

/** The fields of a value that are set. */
function fields_text(fields: object): string {
  const set = Object.entries(fields).filter(([, field]) => field !== 0 && field !== false && field !== null);
  return set.map(([name, field]) => (Array.isArray(fields) ? value_text(field) : `${name}: ${value_text(field)}`)).join(", ") || "0";
}

/** The value of an object with its unit; words have none. */
export function measure_text(value: Value | undefined): string {
  if (value?.text !== undefined) return value.text;
  return `${value_text(value?.value)} ${typeof value?.value === "number" ? (value.unit ?? "") : ""}`.trimEnd();
}

/** The name of a device in the snapshot. */
export function device_name(bus: string | undefined, node: number | undefined): string {
  if (node === 0) return "all nodes";
  if (node === undefined) return "";
  const known = live.state.snapshot?.nodes?.find((each: any) => each.bus === bus && each.node === node);
  return known?.device ?? `node ${node}`;
}

/** Whose value it is; those of node 0 are told to all, and by nobody that is known. */
export const owner_name = (value: Value) => (value.node === 0 ? value.bus : device_name(value.bus, value.node));

/** Values of a node without heartbeat are old, whatever they say. */
export function is_old(value: Value): boolean {
  return live.state.snapshot?.nodes?.some((each: any) => each.bus === value.bus && each.node === value.node && each.state === "silent") ?? false;
}

/** Whether a media query holds. */
export function useMedia(query: string): boolean {
  const [holds, set] = useState(() => matchMedia(query).matches);
  useEffect(() => {
    const media = matchMedia(query);
    const look = () => set(media.matches);
    media.addEventListener("change", look);
    return () => media.removeEventListener("change", look);
  }, [query]);
  return holds;
}

export function Card(props: { title?: string; class?: string; children: ComponentChildren }) {
  return (
    <section class={`card ${props.class ?? ""}`}>
      {props.title && <h2>{props.title}</h2>}
      {props.children}
    </section>
  );
}

/** What the page has around a world, and a report has not. */
export interface PictureProps {
  summary?: (figures: FigureProps[]) => ComponentChildren;
  /** Curves. */
  trends?: ComponentChildren;
  /** Below the picture. */
  below?: ComponentChildren;
  children?: ComponentChildren;
}

/** A world: the summary on top, the picture with its details, and what has happened beside them. */
export function Layout(props: { kind: string; figures: FigureProps[]; picture: ComponentChildren; details?: ComponentChildren; parts: PictureProps }) {
  const { figures, parts } = props;
  return (
    <div class={`world ${props.kind}`}>
      {parts.summary?.(figures) ?? (figures.length > 0 && <Card class="summary"><div class="figures">{figures.map((each) => <Figure key={each.name} {...each} />)}</div></Card>)}
      <div class="left">{props.picture}{props.details}{parts.below}</div>
      {parts.trends && <div class="middle">{parts.trends}</div>}
      {parts.children && <div class="side">{parts.children}</div>}
    </div>
  );
}

/** The meaning of the marks of a picture. */
export function Legend(props: { rows: [string, string][] }) {
  return <ul class="legend">{props.rows.map(([mark, text]) => <li key={text}><span class={`swatch ${mark}`} aria-hidden="true" />{text}</li>)}</ul>;
}

export interface FigureProps {
  name: string;
  value: ComponentChildren;
  unit?: string;
  tone?: string;
  /** Shows more of it. */
  open?: () => void;
}

export function Figure(props: FigureProps) {
  const parts = (
    <>
      <span class="figure-name">{props.name}</span>
      <span class="figure-value">
        {props.value}
        {props.unit && <small> {props.unit}</small>}
      </span>
    </>
  );
  const kind = `figure ${props.tone ?? ""}`;
  return props.open ? <button type="button" class={kind} onClick={props.open}>{parts}</button> : <div class={kind}>{parts}</div>;
}

/** `warns`: a high value is bad. */
export function Bar(props: { share: number; label: string; warns?: boolean }) {
  const share = Math.max(0, Math.min(1, props.share || 0));
  return (
    <div class="bar" role="meter" aria-label={props.label} aria-valuemin={0} aria-valuemax={100} aria-valuenow={Math.round(share * 100)}>
      <div style={{ width: `${share * 100}%` }} class={!props.warns ? "" : share > 0.8 ? "bad" : share > 0.5 ? "warn" : ""} />
    </div>
  );
}

const tones: Record<string, string> = {
  operational: "good", "pre-operational": "warn", stopped: "bad", silent: "bad", off: "off", initialisation: "warn",
  "error-active": "good", "error-warning": "warn", "error-passive": "warn", "bus-off": "bad",
  normal: "good", fault: "bad", "out of order": "bad",
};
export function State(props: { state: string }) {
  return <span class={`state ${tones[props.state] ?? ""}`}>{props.state}</span>;
}

export function Copy(props: { text: string }) {
  const [said, say] = useState("");
  const copy = async () => {
    try {
      await navigator.clipboard.writeText(props.text);  // missing if the page came by plain HTTP from another machine
      say(texts.copied);
    } catch {
      say(texts.not_copied);
    }
    setTimeout(() => say(""), 3000);
  };
  return <button type="button" onClick={copy}>{said || texts.copy}</button>;
}

export function save(name: string, text: string, type = "text/plain") {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([text], { type }));
  link.download = name;
  link.click();
  URL.revokeObjectURL(link.href);
}
