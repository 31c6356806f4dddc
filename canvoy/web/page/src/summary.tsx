// The first card of World and Overview: whether all is well, in a sentence; the key figures; and
// the state of the network.
import { useMemo } from "preact/hooks";
import { go } from "./address";
import { is_current, useLive, type Json } from "./live";
import { Figure, number_text, time_text, type FigureProps } from "./parts";
import { texts } from "./texts";
import { fault_spans } from "./trends";
import { sorted_verdicts, verdict_text } from "./verdicts";

type Tone = "good" | "warn" | "bad" | "";
interface Judgement {
  tone: Tone;
  headline: string;
  /** Added to the headline. */
  note?: string;
  detail: string;
}

function of_run(invariants: Json[]): Judgement {
  const all = sorted_verdicts(invariants);
  const broken = all.filter((it) => !it.held).length;
  const open = all.filter((it) => it.held && !it.decided).length;
  if (broken > 0) return { tone: "bad", headline: texts.broken_of(broken, all.length), detail: verdict_text(all[0]) };
  if (open === all.length) return { tone: "", headline: texts.all_open, detail: texts.all_open_why };
  const near = all.find((it) => it.decided && it.worst > 0 && it.allowed > 0);
  return { tone: "good", headline: texts.hold(all.length - open, all.length), note: open > 0 ? texts.open_count(open) : undefined, detail: near ? `${texts.nearest} ${verdict_text(near, true)}` : texts.nothing_near };
}

/** Without a server nothing is known, however it was. */
const lost: Judgement = { tone: "", headline: texts.not_known, detail: texts.not_known_why };

const bus_lost = (trouble: string): Judgement => ({ tone: "bad", headline: texts.bus_lost, detail: trouble });

const names = (nodes: Json[]) => nodes.map((node) => node.device).join(", ");

/** Of a bus or a log, where nothing is known of what the network is for. */
function of_network(snapshot: Json, is_log: boolean): Judgement {
  const nodes: Json[] = snapshot.nodes ?? [];
  const silent = nodes.filter((node) => node.state === "silent");
  const faulty = nodes.filter((node) => node.error_register && node.error_register !== "00");
  const idle = nodes.filter((node) => node.state !== "operational");
  if (snapshot.bus_state === "bus-off") return { tone: "bad", headline: texts.bus_off, detail: texts.bus_off_why };
  if (silent.length > 0) return { tone: "bad", headline: texts.silent_of(silent.length, nodes.length), detail: texts.silent(silent.map((node) => node.device)) };
  if (faulty.length > 0) return { tone: "warn", headline: texts.faulty_of(faulty.length, nodes.length), detail: `${texts.error_register} ${faulty.map((node) => `${node.device}: ${node.error_register}h`).join(", ")}.` };
  if (snapshot.bus_state && snapshot.bus_state !== "error-active") return { tone: "warn", headline: texts.bus_state(snapshot.bus_state), detail: texts.bus_errors };
  if (nodes.length === 0) return { tone: "", headline: texts.nodes_none, detail: is_log ? texts.nodes_none_log : texts.nodes_none_bus };
  if (idle.length > 0) return { tone: "", headline: texts.operational_of(nodes.length - idle.length, nodes.length), detail: `${names(idle.slice(0, 6))}: ${[...new Set(idle.map((node) => node.state))].join(", ")}.` };
  return { tone: "good", headline: texts.all_operational(nodes.length), detail: texts.no_errors };
}

const marks: Record<Tone, string> = {
  good: "M6 12.5l4 4 8.5-9", bad: "M7 7l10 10M17 7L7 17", warn: "M12 5.5v8M12 17.6v.4", "": "M7 12h.2M12 12h.2M17 12h.2",
};

/** Emergencies that are no end of an error. */
export const emergencies_of = (events: Json[]) => events.filter((event) => event.event === "emergency" && event.code !== "0000");

export function Summary(props: { figures: FigureProps[] }) {
  const { state, hello, events, rates } = useLive();
  const snapshot: Json = state.snapshot ?? {};
  const nodes: Json[] = snapshot.nodes ?? [];
  const invariants: Json[] = state.summary?.invariants ?? [];
  const trouble = snapshot.trouble || state.play?.trouble;
  const said = !is_current() ? lost : trouble ? bus_lost(trouble) : invariants.length > 0 ? of_run(invariants) : of_network(snapshot, hello.kind === "log");
  const emergencies = useMemo(() => emergencies_of(events).length, [hello, events.length, events.at(-1)]);
  const faults = useMemo(() => fault_spans(Infinity).filter((span) => span.end === Infinity), [hello, events.length, events.at(-1)]);
  const operational = nodes.filter((node) => node.state === "operational").length;
  const loads: number[] = (snapshot.buses ?? []).map((bus: Json) => bus.load_percent ?? 0);
  const frames = snapshot.frames_per_second ?? Object.values<Json>(rates).reduce((sum, rate) => sum + rate.frames, 0);
  const see = (view: string) => () => go({ view });
  return (
    <section class={`card summary ${said.tone}`} aria-label={texts.summary}>
      <div class="judgement">
        <svg class="seal" viewBox="0 0 24 24" width="44" height="44" aria-hidden="true"><circle cx="12" cy="12" r="12" /><path d={marks[said.tone]} /></svg>
        <div>
          <p class="headline">{said.headline} {said.note && <small>{said.note}</small>}</p>
          <p class="detail">{said.detail}</p>
          {faults.length > 0 && <p class="faults-now">{faults.map((span) => <span class="state bad" key={span.fault + span.begin}>{texts.fault_since(span.fault, time_text(span.begin, 0))}</span>)}</p>}
        </div>
      </div>
      <div class="figures">
        {props.figures.map((figure) => <Figure key={figure.name} {...figure} />)}
        <Figure name={texts.nodes_up} value={`${operational}/${nodes.length}`} tone={nodes.some((node) => node.state === "silent") ? "bad" : ""} open={see("nodes")} />
        {loads.length > 0
          ? <Figure name={texts.load_most} value={number_text(Math.round(Math.max(...loads) * 10) / 10)} unit="%" tone={Math.max(...loads) > 80 ? "bad" : ""} open={see("load")} />
          : <Figure name={texts.frames_rate} value={number_text(Math.round(frames))} open={see("load")} />}
        <Figure name={texts.emergencies} value={emergencies} open={see("events")} />
      </div>
    </section>
  );
}
