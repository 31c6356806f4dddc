// Events, and the verdicts on the run; faults can be added.
import { useState } from "preact/hooks";
import { ask, live, useLive, type Json } from "./live";
import { seek } from "./run_link";
import { Card, time_text } from "./parts";
import { texts } from "./texts";
import { Verdicts } from "./verdicts";

const shown_max = 400;
const tone: Record<string, string> = {
  "fault-begins": "bad", broken: "bad", emergency: "warn", "fault-ends": "good", "can-state": "warn",
  silent: "bad", "heard-again": "good", "bus-lost": "bad", "bus-back": "good", "frames-lost": "bad",
};

export function Faults() {
  const { hello, state } = useLive();
  const [kind, set_kind] = useState("");
  const [place, set_place] = useState<Record<string, string>>({});
  const [duration, set_duration] = useState("30");
  const [said, say] = useState("");
  const faults: Json[] = hello.faults ?? [];
  const places: Json[] = hello.places ?? [];
  if (faults.length === 0 || !hello.can?.replay) return null;
  const inject = async (event: Event) => {
    event.preventDefault();
    const where = Object.entries(place).filter(([, number]) => number !== "").map(([name, number]) => (number === "on" ? `:${name}` : `:${name}=${number}`)).join("");
    const answer = await ask("fault", { fault: (kind || faults[0].fault) + where, duration_s: Number(duration) });
    say(answer.error ?? "");
  };
  const { plan } = state;
  const take_back = async (number: number) => {
    const answer = await ask("restart", { seed: plan.seed, faults: plan.faults.filter((_: string, i: number) => i !== number), keep: true });
    say(answer.error ?? "");
  };
  const told = faults.find((each) => each.fault === (kind || faults[0].fault));
  return (
    <Card title={texts.faults} class="faults">
      <form onSubmit={inject}>
        <label class="field"><span>{texts.fault_pick}</span>
          <select value={kind || faults[0].fault} onChange={(event) => set_kind(event.currentTarget.value)}>
            {faults.map((each) => <option key={each.fault} value={each.fault}>{each.fault}</option>)}
          </select>
        </label>
        <p class="hint">{told?.text}</p>
        <div class="tools">
          {places.filter((each) => each.most > 0).map((each) => (
            <label class="field small" key={each.place}><span>{each.place}</span>
              <input inputMode="numeric" pattern="[0-9]*" value={place[each.place] ?? ""} placeholder="–" onInput={(event) => set_place({ ...place, [each.place]: event.currentTarget.value })} />
            </label>
          ))}
          <label class="field small"><span>{texts.fault_for}</span>
            <select value={duration} onChange={(event) => set_duration(event.currentTarget.value)}>
              {[["5", "5 s"], ["30", "30 s"], ["60", "1 min"], ["300", "5 min"], ["0", texts.fault_rest]].map(([value, name]) => <option key={value} value={value}>{name}</option>)}
            </select>
          </label>
          <button type="submit" class="danger">{texts.fault_inject}</button>
        </div>
        <p class="error" role="alert">{said}</p>
      </form>
      {plan?.faults.length > 0 && (
        <ul class="chips" aria-label={texts.fault_made}>
          {plan.faults.map((fault: string, i: number) => (
            <li key={fault + i} class="on bad">{fault} <button type="button" class="take-back" title={texts.fault_take_back(fault)} aria-label={texts.fault_take_back(fault)} onClick={() => void take_back(i)}>×</button></li>
          ))}
        </ul>
      )}
    </Card>
  );
}

export function EventList(props: { count?: number; only?: (event: Json) => boolean }) {
  const { events, hello } = useLive();
  const list = (props.only ? events.filter(props.only) : events).slice(-(props.count ?? shown_max)).reverse();
  if (list.length === 0) return <p class="hint">{texts.events_none}</p>;
  const go = (time: number) => seek(Math.max(0, time - 2 - (hello.begin ?? 0)));
  return (
    <ol class="events" tabIndex={0}>
      {list.map((event, i) => (
        <li key={live.events.length - i} class={event.code === "0000" ? "good" : (tone[event.event] ?? "")}>
          {hello.can?.replay ? <button type="button" class="time" title={texts.go_to} onClick={() => go(event.time)}>{time_text(event.time, 1)}</button> : <span class="time">{time_text(event.time, 1)}</span>}
          <span>{event.words}</span>
        </li>
      ))}
    </ol>
  );
}

export function Events() {
  return (
    <div class="events-view">
      <div class="side">
        <Faults />
        <Verdicts />
      </div>
      <Card title={texts.events_all}><EventList /></Card>
    </div>
  );
}
