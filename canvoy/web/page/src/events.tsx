// What has happened, and how the run is judged; faults can be made.
import { useState } from "preact/hooks";
import { ask, live, useLive, type Json } from "./live";
import { Card, number_text, time_text } from "./parts";
import { texts } from "./texts";

const shown_max = 400;
const tone: Record<string, string> = {
  "fault-begins": "bad", broken: "bad", emergency: "warn", "fault-ends": "good", "can-state": "warn",
};

export function Faults() {
  const { hello } = useLive();
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
    </Card>
  );
}

export function Verdicts() {
  const { state } = useLive();
  const all: Json[] = state.summary?.invariants ?? [];
  if (all.length === 0) return null;
  return (
    <Card title={texts.verdicts}>
      <table class="plain verdicts">
        <tbody>
          {all.map((each, i) => (
            <tr key={i} class={each.held ? "" : "broken"}>
              <td><span class={`state ${each.held ? (each.decided ? "good" : "") : "bad"}`}>{each.held ? (each.decided ? texts.held : texts.open) : texts.is_broken}</span></td>
              <td>{each.lift ? `${texts.lift} ${each.lift}: ` : ""}{each.fault ? `${each.fault}: ` : ""}{String(each.invariant).replace(/_/g, " ")}</td>
              <td class="number">{each.decided ? `${number_text(each.worst)} ${each.unit ?? ""}` : "–"}</td>
              <td class="number muted">{number_text(each.allowed)} {each.unit ?? ""} {texts.allowed}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </Card>
  );
}

export function EventList(props: { count?: number; only?: (event: Json) => boolean }) {
  const { events, hello } = useLive();
  const list = (props.only ? events.filter(props.only) : events).slice(-(props.count ?? shown_max)).reverse();
  if (list.length === 0) return <p class="hint">{texts.events_none}</p>;
  const go = (time: number) => void ask("seek", { time: Math.max(0, time - 2 - (hello.begin ?? 0)) });
  return (
    <ol class="events">
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
