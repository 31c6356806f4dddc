// The run and its time in the address: a link requests them, and the present ones are written to
// it.
import { asked_seed, link_hash, part, parts_of, refine, refine_lists, watch_address, go, type Part } from "./address";
import { ask, live } from "./live";
import { time_text } from "./parts";
import { texts } from "./texts";

const close_s = 0.06;  // maximum delay of reported times

/** Milliseconds are precise enough for an address. Rounded up, so that all earlier events are included at the time of a link. */
const at_text = (time: number) => String(Math.ceil(time * 1000 - 1e-6) / 1000);
/** Seconds since the start. */
export const time_now = () => (live.state.time ?? 0) - (live.hello.begin ?? 0);
const stands = () => !!live.state.play && (live.state.play.paused || live.state.play.over) && !live.state.play.seeking;

const on_its_way_ms = 5000;  // a seek is answered before its time is reached, and a state may still be of before
let going_to = NaN;
let goes_until = 0;
const is_on_its_way = () =>
  (performance.now() < goes_until || !!live.state.play?.seeking) && Math.abs(time_now() - going_to) > close_s;
/** The time at which the run will stand: what Back is pressed against while a seek is on its way. */
const time_ahead = () => (is_on_its_way() ? going_to : time_now());

/** True if the run in the address differs from the played one. */
function asked() {
  const plan = live.state.plan;
  const seed = asked_seed();
  const is_other = !!plan && seed !== null
    && JSON.stringify([String(plan.seed), plan.faults, plan.acts]) !== JSON.stringify([seed, parts_of("fault"), parts_of("act")]);
  const at = part("at");
  const time = at === "" ? NaN : Number(at);
  return { is_other, time, moves: Number.isFinite(time) && time >= 0 && (is_other || Math.abs(time - time_ahead()) > close_s) };
}

/** Goes to a time. The address keeps it until a state has it, so that a reload meanwhile does not request another one. */
async function go_to(time: number) {
  going_to = time;
  goes_until = performance.now() + on_its_way_ms;
  await ask("seek", { time });
}

let answers = false;  // a question is open, or its answer is on the way

/** A link from elsewhere needs a confirmation before it moves what others watch too; Back needs none, and does not change the run. */
async function follow(by_link: boolean) {
  if (!live.hello.can?.replay || live.state.time === undefined) return;
  const { is_other, time, moves } = asked();
  const restarts = is_other && by_link;
  if (!restarts && !moves) return write_run();
  const question = restarts ? texts.restart_asks : texts.time_asks(time_text(time + (live.hello.begin ?? 0), 1));
  answers = true;
  if (!by_link || confirm(question)) {
    if (moves) await ask("pause", { paused: true });  // first: a restarted run does not play beyond the time
    if (restarts) await ask("restart", { seed: Number(asked_seed()), faults: parts_of("fault"), acts: parts_of("act") });
    if (moves) await go_to(time);
  }
  answers = false;
  write_run();
}

/** The address of the played run, and its time if it stands. */
function write_run() {
  if (answers || live.state.time === undefined || is_on_its_way()) return;
  const at = stands() ? at_text(time_now()) : "";
  const { plan } = live.state;
  if (plan) refine_lists({ fault: plan.faults, act: plan.acts }, [["seed", String(plan.seed)], ["at", at]]);
  else refine({ at });
}

let is_first = true;
let written = "";

/** Called for each received state: updates the address. */
export function follow_run() {
  const { play, plan } = live.state;
  if (play?.seeking || is_on_its_way()) return;
  const now = JSON.stringify([plan?.seed, plan?.faults, plan?.acts, stands() && time_now()]);
  if (now === written) return;
  written = now;
  if (is_first) void follow(true);
  else write_run();
  is_first = false;
}

export const watch_links = () => watch_address((by_link) => void follow(by_link));

/** Goes to a time, from which Back returns to the present one; `also`: to another view. */
export function seek(time: number, also: Partial<Record<Part, string>> = {}) {
  refine({ at: at_text(time_now()) });
  go({ ...also, at: at_text(time) });
  written = "";  // while time advances, it is not in the address
  void go_to(time);
}

/** An event may be shown before the state of its time has come: a link is of what is shown. */
const time_shown = () => Math.max(time_now(), (live.events.at(-1)?.time ?? 0) - (live.hello.begin ?? 0));

/** A link to the shown view for others, with an address at which they reach the server. */
export function link_text(): string {
  const addresses: string[] = live.hello.addresses ?? [];
  const own = addresses.find((each) => new URL(each).host === location.host);
  const base = own ?? addresses[0] ?? `${location.origin}${location.pathname}${location.search}`;
  return base + link_hash(live.hello.can?.replay ? at_text(time_shown()) : undefined);
}
