// A report: what canvoy report has put into the page, drawn once, with a slider for its pictures.
import { render } from "preact";
import { useState } from "preact/hooks";
import { EventList, Verdicts } from "./events";
import { live, merge, type Json } from "./live";
import { Load } from "./load";
import { Nodes } from "./nodes";
import { Card, device_name, number_text, time_text, measure_text, value_text } from "./parts";
import { texts } from "./texts";
import { worlds } from "./worlds";

const told: Json = JSON.parse(document.getElementById("data")!.textContent!);

/** Each picture is told as what has changed since the one before (RFC 7386). */
const pictures: Json[] = [];
for (const change of told.pictures) pictures.push(merge(pictures.at(-1), change));

/** Of the whole length: a report has no "now" of which a rate could be. */
function mean_rates(): Json {
  const length = Math.max(told.end.time - (told.about.begin ?? 0), 1e-6);
  const rate = (of: Json) => ({ frames: of.frames / length, bits: of.bits / length });
  const parts = (all: Json) => Object.fromEntries(Object.entries<Json>(all).map(([name, each]) => [name, rate(each)]));
  return Object.fromEntries(
    Object.entries<Json>(told.end.counts).map(([bus, of]) => [bus, { ...rate(of), nodes: parts(of.nodes), services: parts(of.services) }]),
  );
}

function take() {
  live.hello = { ...told.about, can: {} };
  live.state = { ...told.end, ...pictures.at(-1) };
  live.events = told.events;
  live.rates = mean_rates();
  for (const [key, { values, ...place }] of Object.entries<Json>(told.values)) live.values.set(key, { ...place, ...values[0] });
}

// What stands elsewhere in the report, or is of the last moment alone.
const no_statistics = [
  "time", "event", "invariants", "nodes", "buses", "all_held", "movements", "seat", "displays", "lamps", "paper", "terminal", "wish", "arm",
];

/** Numbers and words of the summary, with those of its parts behind their names. */
function statistics(from: Json, before = ""): [string, string][] {
  return Object.entries<Json>(from).flatMap(([key, value]): [string, string][] => {
    if (no_statistics.includes(key)) return [];
    const name = `${before}${key.replace(/_/g, " ")}`;
    if (value === null || value === "" || typeof value === "boolean") return [];
    if (Array.isArray(value)) {
      const is_list = value.length > 0 && value.length <= 8 && value.every((each) => each && typeof each === "object");
      return is_list ? value.flatMap((each, i) => statistics(each, `${name} ${i + 1}, `)) : [];
    }
    if (typeof value === "object") return statistics(value, `${name}, `);
    return [[name, value_text(value)]];
  });
}

function Statistics() {
  const rows = statistics(live.state.summary ?? {});
  if (rows.length === 0) return null;
  return (
    <Card title={texts.statistics}>
      <table class="plain"><tbody>{rows.map(([name, value]) => <tr key={name}><td>{name}</td><td class="number">{value}</td></tr>)}</tbody></table>
    </Card>
  );
}

function Pictures() {
  const [shown, show] = useState(pictures.length - 1);
  const Picture = worlds[live.hello.kind];
  if (!Picture) return null;
  const picture = pictures[shown];
  live.state = { ...live.state, ...picture };
  return (
    <section>
      <label class="field picture-time">
        <span>{texts.report_picture} {texts.report_at} <b class="number">{time_text(picture.time, 0)}</b></span>
        <input type="range" min={0} max={pictures.length - 1} value={shown} aria-valuetext={time_text(picture.time, 0)} onInput={(event) => show(Number(event.currentTarget.value))} />
      </label>
      <Picture><Verdicts /></Picture>
    </section>
  );
}

const curve = { width: 600, height: 120, left: 56, top: 8, bottom: 22 };

/** A value holds until it changes: steps. */
function Curve(props: { name: string; points: [number, number][] }) {
  const value = live.values.get(props.name);
  const begin = told.about.begin ?? 0;
  const end = Math.max(told.end.time, begin + 1e-6);
  const all = props.points.map((each) => each[1]);
  const low = Math.min(...all);
  const high = Math.max(...all, low + 1e-9);
  const x = (time: number) => curve.left + ((time - begin) / (end - begin)) * (curve.width - curve.left - 4);
  const y = (of: number) => curve.height - curve.bottom - ((of - low) / (high - low)) * (curve.height - curve.top - curve.bottom);
  const path = props.points.map(([time, of], i) => (i === 0 ? `M${x(time).toFixed(1)} ${y(of).toFixed(1)}` : `H${x(time).toFixed(1)}V${y(of).toFixed(1)}`)).join("");
  const title = value ? `${device_name(value.bus, value.node)}: ${value.name ?? value.index}` : props.name;
  return (
    <figure class="curve">
      <figcaption>{title} <b>{measure_text(value)}</b></figcaption>
      <svg viewBox={`0 0 ${curve.width} ${curve.height}`} role="img" aria-label={title}>
        <path class="axis" d={`M${curve.left} ${curve.top}V${curve.height - curve.bottom}H${curve.width - 4}`} />
        <path class="line" d={`${path}H${x(end).toFixed(1)}`} />
        <text x={curve.left - 6} y={curve.top + 9} text-anchor="end">{number_text(Math.max(...all))}</text>
        <text x={curve.left - 6} y={curve.height - curve.bottom} text-anchor="end">{number_text(low)}</text>
        <text x={curve.left} y={curve.height - 5}>{time_text(begin, 0)}</text>
        <text x={curve.width - 4} y={curve.height - 5} text-anchor="end">{time_text(end, 0)}</text>
      </svg>
    </figure>
  );
}

function Curves() {
  const all = Object.entries<[number, number][]>(told.curves);
  if (all.length === 0) return null;
  return <Card title={texts.curves}><div class="pair">{all.map(([name, points]) => <Curve key={name} name={name} points={points} />)}</div></Card>;
}

function Values() {
  const all = [...live.values.values()];
  if (all.length === 0) return null;
  return (
    <Card>
      <details>
        <summary>{texts.last_values(all.length)}</summary>
        <div class="scroll" tabIndex={0} role="region" aria-label={texts.last_values(all.length)}>
          <table class="plain wide"><tbody>
            {all.map((value, i) => (
              <tr key={i}><td>{value.node === 0 ? value.bus : device_name(value.bus, value.node)}</td><td class="mono">{value.index}:{value.sub}</td><td class="words">{value.name}</td>
                <td class="strong words">{measure_text(value)}</td><td class="mono muted">{value.raw}</td></tr>
            ))}
          </tbody></table>
        </div>
      </details>
    </Card>
  );
}

function Report() {
  const invariants: Json[] = live.state.summary?.invariants ?? [];
  const broken = invariants.filter((each) => !each.held).length;
  const plan = live.state.plan;
  return (
    <main class="load">
      <h1>
        {texts.report}: {texts.kinds[live.hello.kind] ?? live.hello.kind}
        {invariants.length > 0 && <span class={`state ${broken ? "bad" : "good"}`}>{broken ? texts.broken(broken) : texts.all_held}</span>}
      </h1>
      <p class="muted">{plan ? texts.report_command : texts.report_log}: <code class="mono">{plan?.command ?? live.hello.command}</code>, {time_text(told.end.time - (told.about.begin ?? 0), 0)}</p>
      <Pictures />
      <div class="pair">
        {!(live.hello.kind in worlds) && <Verdicts />}
        <Statistics />
        <Card title={texts.events_all}>
          <EventList count={told.events.length} />
          {told.events_left_out > 0 && <p class="hint">{texts.report_missing(told.events_left_out)}</p>}
        </Card>
      </div>
      <Curves />
      <Nodes />
      <h2>{texts.mean_load}</h2>
      <Load />
      <Values />
      <p class="muted">{texts.report_by}</p>
    </main>
  );
}

take();
document.title = `Canvoy: ${texts.report}: ${live.hello.kind}`;
render(<Report />, document.getElementById("report")!);
