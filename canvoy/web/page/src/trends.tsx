// Curves of the values in the picture of a world, over the whole run: from the server, which stores
// them, and then from states. Faults are shown as bands.
import { useEffect, useMemo } from "preact/hooks";
import { ask, live, useLive, type Json } from "./live";
import { seek } from "./run_link";
import { Card, number_text, time_text } from "./parts";
import { texts } from "./texts";

const samples_max = 600;
const marks_max = 200;
const colours = 8;
const width = 300;
const height = 72;

interface Kept {
  hello: Json;
  names: string;
  times: number[];
  values: Record<string, (number | null)[]>;
  asks: boolean;
}
let kept: Kept | null = null;

/** `lifts.*.position_m` stands for all elements. */
function names_of(pattern: string): string[] {
  const [list, rest] = pattern.split(".*.");
  if (rest === undefined) return [pattern];
  return (live.state.snapshot?.[list] ?? []).map((_: Json, i: number) => `${list}.${i}.${rest}`);
}

const number_at = (place: string): number | null => {
  let value: Json = live.state.snapshot;
  for (const key of place.split(".")) value = value?.[key];
  return typeof value === "number" ? value : null;
};

async function ask_all(names: string) {
  const mine: Kept = { hello: live.hello, names, times: [], values: {}, asks: true };
  kept = mine;
  const told = await ask("trend", { names });
  mine.times = told.times ?? [];
  mine.values = told.values ?? {};
  mine.asks = false;
}

/** The present samples, with one more if it is due. */
function follow(names: string) {
  if (!kept || kept.hello !== live.hello || kept.names !== names) return void ask_all(names);
  const { time, play } = live.state;
  const last = kept.times.at(-1) ?? -1;
  if (kept.asks || play?.seeking || time <= last) return;
  const period = Math.max(1, (time - (kept.times[0] ?? 0)) / samples_max);
  if (time - last < period) return;
  // There was a jump, or there are too many samples: the server has all of them.
  if (time - last > 20 * period || kept.times.length > 2 * samples_max) return void ask_all(names);
  kept.times.push(time);
  for (const name of names.split(",")) (kept.values[name] ??= kept.times.map(() => null).slice(1)).push(number_at(name));
}

interface Span { begin: number; end: number; fault: string }
/** Times of faults, from events; those that have not ended end at `until`. */
export function fault_spans(until: number): Span[] {
  const spans: Span[] = [];
  const open = new Map<string, Span>();
  for (const { event, time, fault, bus, node, lift } of live.events) {
    const key = `${fault} ${bus} ${node} ${lift}`;
    if (event === "fault-begins") open.set(key, { begin: time, end: until, fault });
    if (event !== "fault-ends") continue;
    spans.push({ begin: open.get(key)?.begin ?? time, end: time, fault });
    open.delete(key);
  }
  return [...spans, ...open.values()];
}

/** Times of emergencies; an end of an error is none. */
export function emergency_times(): number[] {
  return live.events.filter((event) => event.event === "emergency" && event.code !== "0000").map((event) => event.time).slice(-marks_max);
}

interface LineProps {
  title: string;
  unit: string;
  places: string[];
  factor: number;
  times: number[];
  values: Kept["values"];
}

function Line(props: LineProps) {
  const { times, factor, places } = props;
  const lines = places.map((place) => (props.values[place] ?? []).map((value) => (value === null ? null : value * factor)));
  const all = lines.flat().filter((value): value is number => value !== null);
  if (all.length < 2) return null;
  const least = all.reduce((one, other) => Math.min(one, other));
  const most = all.reduce((one, other) => Math.max(one, other));
  const low = least > most / 2 ? least : Math.min(0, least);  // far from 0, the change is of interest
  const high = Math.max(low + 1e-6, most);
  const begin = times[0];
  const end = times[times.length - 1];
  const x = (time: number) => ((time - begin) / Math.max(end - begin, 1e-6)) * width;
  const y = (value: number) => height - 3 - ((value - low) / (high - low)) * (height - 8);
  const path = (line: (number | null)[]) => {
    let is_down = false;
    return line.map((value, i) => {
      const part = value === null ? "" : `${is_down ? "L" : "M"}${x(times[i]).toFixed(1)} ${y(value).toFixed(1)}`;
      is_down = value !== null;
      return part;
    }).join("");
  };
  const is_one = places.length === 1;
  const now = is_one ? number_at(places[0]) : null;
  const digits = most - least > 10 ? 10 : 1000;
  const [first, last] = [least, most].map((value) => number_text(Math.round(value * digits) / digits || 0));
  const range = `${first} … ${last} ${props.unit}`;
  const { can, begin: run_begin, kind } = live.hello;
  const go_there = (event: MouseEvent) => {
    const box = (event.currentTarget as Element).getBoundingClientRect();
    seek(begin + ((event.clientX - box.left) / box.width) * (end - begin) - (run_begin ?? 0));
  };
  const seen = (time: number) => time >= begin && time <= end;
  return (
    <figure class="trend">
      <figcaption>
        <span>{props.title}</span>
        {now !== null && <b>{number_text(now * factor)} {props.unit}</b>}
        {!is_one && <span class="lines">{lines.map((line, i) => line.length > 0 && <span key={i}><i class={`line-${i % colours}`} />{i + 1}</span>)}</span>}
      </figcaption>
      <svg viewBox={`0 0 ${width} ${height}`} preserveAspectRatio="none" role="img" aria-label={`${props.title}: ${range}`} class={can?.replay ? "goes" : ""} onClick={can?.replay ? go_there : undefined}>
        {fault_spans(end).filter((span) => span.end >= begin).map((span, i) => (
          <rect key={i} class="fault-band" x={Math.max(0, x(span.begin))} y="0" width={Math.max(1.5, x(span.end) - Math.max(0, x(span.begin)))} height={height}><title>{span.fault || texts.fault_here}</title></rect>
        ))}
        {emergency_times().filter(seen).map((time, i) => <path key={i} class="emergency-mark" d={`M${x(time).toFixed(1)} 0v5`} />)}
        {low <= 0 && <path class="axis" d={`M0 ${y(0)}H${width}`} />}
        {is_one && low <= 0 && !lines[0].includes(null) && <path class="area" d={`${path(lines[0])}V${Math.max(0, y(0)).toFixed(1)}H0z`} />}
        {lines.map((line, i) => <path key={i} class={`line line-${i % colours}`} d={path(line)} />)}
        {kind === "log" && <path class="now" d={`M${x(live.state.time).toFixed(1)} 0V${height}`} />}
      </svg>
      <p class="trend-scale muted"><span>{time_text(begin, 0)}</span><span>{range}</span><span>{time_text(end, 0)}</span></p>
    </figure>
  );
}

export function Trends() {
  const { state, hello, events } = useLive();
  const rows = texts.trends[hello.kind] ?? [];
  const names = rows.flatMap(([, , pattern]) => names_of(pattern)).join(",");
  useEffect(() => { if (names) follow(names); }, [state, names]);
  const is_there = kept?.names === names && kept.times.length > 1;
  // States come twenty times a second, samples once.
  return useMemo(() => (
    <Card title={hello.kind === "log" ? texts.trend_title_log : texts.trend_title} class="trends">
      {is_there && kept ? rows.map(([title, unit, pattern, factor]) => (
        <Line key={title} title={title} unit={unit} places={names_of(pattern)} factor={factor ?? 1} times={kept!.times} values={kept!.values} />
      )) : rows.map(([title]) => <figure key={title} class="trend empty"><figcaption>{title}</figcaption><svg viewBox={`0 0 ${width} ${height}`} preserveAspectRatio="none" aria-hidden="true" /><p class="trend-scale">&nbsp;</p></figure>)}
    </Card>
  ), [is_there && kept, kept?.times.length, events.length, hello.kind === "log" && state.time]);
}
