// The verdicts on the run, in sentences: the worst values, their times, and the limits.
import { go } from "./address";
import { useLive, type Json } from "./live";
import { Card, number_text, time_text } from "./parts";
import { texts } from "./texts";

const first_upper = (text: string) => text.charAt(0).toUpperCase() + text.slice(1);

/** `Longest wait: 62 s, at 4:12; 300 s are allowed.` `inside`: of a sentence. */
export function verdict_text(it: Json, inside = false): string {
  const where = `${it.lift ? `${texts.lift} ${it.lift}: ` : ""}${it.fault ? `${it.fault}: ` : ""}`;
  const words = it.words ?? String(it.invariant).replace(/_/g, " ");
  const what = where ? where + words : inside ? words : first_upper(words);
  if (!it.decided) return `${what}: ${texts.open}.`;
  const unit = String(it.unit ?? "").replace(/2$/, "²").replace(/3$/, "³");
  const measure = (value: number) => `${number_text(value)}${unit && ` ${unit}`}`;
  const colon = / (by|most|for)$/.test(what) ? "" : ":";
  const when = it.worst > 0 && it.worst_at !== undefined ? `, ${texts.at_time} ${time_text(it.worst_at, 1)}` : "";
  return `${what}${colon} ${measure(it.worst)}${when}; ${it.allowed === 0 ? texts.none_allowed : `${measure(it.allowed)} ${texts.allowed}`}.`;
}

/** Broken ones first, then those closest to their limit, and unjudged ones last. */
const weight = (it: Json) => (it.held ? 0 : 1e9) + (it.decided ? 1 + (it.allowed > 0 ? it.worst / it.allowed : 0) : 0);
export const sorted_verdicts = (all: Json[]) => [...all].sort((a, b) => weight(b) - weight(a));

export function Verdicts(props: { most?: number }) {
  const { state } = useLive();
  const all: Json[] = sorted_verdicts(state.summary?.invariants ?? []);
  if (all.length === 0) return null;
  const open = all.filter((it) => !it.decided).length;
  const broken = all.filter((it) => !it.held).length;
  const shown = all.slice(0, props.most ?? all.length);
  return (
    <Card title={texts.verdicts}>
      <p class="muted">{texts.verdict_counts(all.length - open - broken, broken, open)}</p>
      <table class="plain verdicts">
        <tbody>
          {shown.map((it, i) => (
            <tr key={i} class={it.held ? "" : "broken"}>
              <td><span class={`state ${it.held ? (it.decided ? "good" : "") : "bad"}`}>{it.held ? (it.decided ? texts.held : texts.open_short) : texts.is_broken}</span></td>
              <td>{verdict_text(it)}</td>
            </tr>
          ))}
        </tbody>
      </table>
      {shown.length < all.length && <button type="button" onClick={() => go({ view: "events" })}>{texts.verdicts_all(all.length)}</button>}
    </Card>
  );
}
