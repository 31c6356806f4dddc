// The page: its frame, the time controls, and the selected view.
import { render, type JSX } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";
import "./style.css";
import { go, useAddress } from "./address";
import { EventList, Events, Faults } from "./events";
import { Frames } from "./frames";
import { ask, draw_each, is_current, live, plays_here, start, useLive, want_values, type Json } from "./live";
import { Load } from "./load";
import { Nodes } from "./nodes";
import { Objects } from "./objects";
import { Overview } from "./overview";
import { Card, Copy, day_text, time_text, useMedia } from "./parts";
import { Plots } from "./plots";
import { follow_run, link_text, seek, watch_links } from "./run_link";
import { Status } from "./status";
import { Summary } from "./summary";
import { texts } from "./texts";
import { Trends } from "./trends";
import { Verdicts } from "./verdicts";
import { worlds } from "./worlds";

const speeds = [1, 2, 5, 10, 30, 60, 300, 1000];
const icons: Record<string, string> = {
  world: "M4 20V8l8-5 8 5v12h-6v-6h-4v6z",
  nodes: "M12 3a3 3 0 0 1 1 5.8V11h5v4.2a3 3 0 1 1-2 0V13H8v2.2a3 3 0 1 1-2 0V11h5V8.8A3 3 0 0 1 12 3z",
  objects: "M4 5h16v3H4zM4 10.5h16v3H4zM4 16h16v3H4z",
  frames: "M3 5h8v5H3zM13 5h8v5h-8zM3 14h5v5H3zM10 14h11v5H10z",
  plots: "M4 4v16h17v-2H6V4zM8 14l4-5 3 3 5-7 1.5 1.2-6.2 8.8-3.2-3.2-2.6 3.2z",
  load: "M5 20V10h3v10zM10.5 20V4h3v16zM16 20v-7h3v7z",
  events: "M12 3a9 9 0 1 0 0 18 9 9 0 0 0 0-18zm1 4v5.2l3.5 2-1 1.7L11 13.3V7z",
};

function Icon(props: { name: string }) {
  return <svg viewBox="0 0 24 24" width="20" height="20" aria-hidden="true"><path d={icons[props.name]} fill="currentColor" /></svg>;
}

async function toggle_play() {
  const { play } = live.state;
  if (!play || !live.hello.can?.replay) return;
  if (play.over) await ask("seek", { time: 0 });
  void ask("pause", { paused: !play.over && !play.paused });
}

/** Space plays and pauses, as in video players, unless it presses the focused element. */
function on_key(event: KeyboardEvent) {
  if (event.key !== " " || event.defaultPrevented || event.ctrlKey || event.altKey || event.metaKey) return;
  if ((event.target as Element).closest("button, a, input, select, summary, dialog, [role=button]")) return;
  event.preventDefault();
  void toggle_play();
}

function Transport() {
  const { state, hello } = useLive();
  const play = state.play;
  const [dragged, drag] = useState<number | null>(null);
  const time = state.time ?? 0;
  const at = time - (hello.begin ?? 0);
  if (!play) return <time class="clock">{time_text(state.time, 1)} <small class="muted">{day_text(state.time)}</small></time>;
  const can = hello.can?.replay;
  const stands = play.paused || play.over;
  return (
    <div class="transport" role="group" aria-label={texts.time}>
      <button type="button" class="icon" disabled={!can} title={texts.restart} aria-label={texts.restart} onClick={() => seek(0)}>
        <svg viewBox="0 0 16 16" width="14" height="14" aria-hidden="true"><path d="M3 2h2v12H3zM14 2v12L6 8z" fill="currentColor" /></svg>
      </button>
      <button type="button" class="icon main" disabled={!can} aria-label={stands ? texts.play : texts.pause} title={stands ? texts.play : texts.pause}
        onClick={() => void toggle_play()}>
        <svg viewBox="0 0 16 16" width="16" height="16" aria-hidden="true"><path d={stands ? "M4 2l10 6-10 6z" : "M3 2h4v12H3zM9 2h4v12H9z"} fill="currentColor" /></svg>
      </button>
      <button type="button" class="icon" disabled={!can} title={texts.step} aria-label={texts.step} onClick={() => void ask("step", { step_s: 0.1 })}>
        <svg viewBox="0 0 16 16" width="14" height="14" aria-hidden="true"><path d="M2 2l8 6-8 6zM11 2h2v12h-2z" fill="currentColor" /></svg>
      </button>
      <time class="clock">{play.seeking ? texts.seeking : time_text(dragged ?? time, 1)} <small class="muted">{day_text(time)}</small></time>
      <input type="range" class="timeline" aria-label={texts.timeline} min={0} max={hello.end ?? 1} step={0.1} value={dragged ?? at} disabled={!can}
        aria-valuetext={time_text(time, 0)}
        onInput={(event) => drag(Number(event.currentTarget.value))}
        onChange={(event) => { seek(Number(event.currentTarget.value)); drag(null); }} />
      <span class="end muted">{time_text(hello.end, 0)}</span>
      <select aria-label={texts.speed} value={String(play.speed)} disabled={!can} onChange={(event) => void ask("speed", { speed: Number(event.currentTarget.value) })}>
        {[...new Set([...speeds, play.speed])].sort((a, b) => a - b).map((speed) => <option key={speed} value={String(speed)}>×{speed}</option>)}
      </select>
    </div>
  );
}

function Share(props: { close: () => void }) {
  const { state, hello } = useLive();
  const box = useRef<HTMLDialogElement>(null);
  useEffect(() => box.current?.showModal(), []);
  const [link] = useState(link_text);
  const plan = state.plan;
  return (
    <dialog ref={box} onClose={props.close} aria-labelledby="share-title">
      <h2 id="share-title">{texts.share_title}</h2>
      <label class="field"><span>{texts.share_link}</span><input readOnly value={link} id="share-link" /></label>
      <Copy text={link} />
      {!plays_here && <p class="hint">{texts.share_token} {hello.is_local && texts.share_local}</p>}
      {plan && (
        <>
          <label class="field"><span>{texts.share_command}</span><input readOnly value={plan.command} id="share-command" /></label>
          <Copy text={plan.command} />
          <p class="hint">{texts.share_note} {plan.acts.length > 0 && texts.share_acts(plan.acts.length)}</p>
        </>
      )}
      <div class="tools">
        {plan && <a class="button" href="api/run.toml" download="run.toml">{texts.save_run}</a>}
        <a class="button" href="api/frames.log" download="canvoy.log">{texts.save}</a>
        <button type="button" onClick={() => box.current?.close()}>{texts.close}</button>
      </div>
    </dialog>
  );
}

function World() {
  const { hello } = useLive();
  const is_wide = useMedia("(min-width: 1700px)");
  const Picture = worlds[hello.kind] ?? Overview;
  return (
    <Picture summary={(figures) => <Summary figures={figures} />} trends={<><Trends />{is_wide && <Verdicts most={12} />}</>} below={!is_wide && <Verdicts most={6} />}>
      <Card title={texts.views.events} class="recent"><EventList count={40} /></Card>
      <Faults />
    </Picture>
  );
}

const views: Record<string, () => JSX.Element | null> = {
  world: World, nodes: Nodes, objects: Objects, frames: Frames, plots: Plots, load: Load, events: Events,
};

const views_of_values = ["nodes", "objects", "plots"];

function set_theme(theme: string) {
  document.documentElement.dataset.theme = theme;
  try {
    localStorage.setItem("theme", theme);
  } catch {
    // It is not kept then.
  }
}

/** A bus and a log are known by their names. */
function title_of(hello: Json): string {
  if (hello.source) return hello.kind === "log" ? hello.source.split("/").at(-1) : hello.source;
  return texts.kinds[hello.kind] ?? texts.name;
}

function Page() {
  const { hello, state } = useLive();
  const is_now = is_current();
  useEffect(() => void document.documentElement.classList.toggle("stale", !is_now), [is_now]);
  const stands = !is_now || !!state.play?.paused || !!state.play?.over;
  useEffect(() => void document.documentElement.classList.toggle("stands", stands), [stands]);
  const has_world = hello.kind in worlds;
  const [shares, share] = useState(false);
  const asked = useAddress()("view");
  const known = !!hello.kind && state.time !== undefined;
  const view = asked in views ? asked : "world";
  const View = views[view];
  const pick = (name: string) => { if (name !== view || !known) go({ view: name, object: "", sort: "" }); };
  useEffect(() => want_values(views_of_values.includes(view) || (known && !has_world && view === "world")), [view, known, has_world]);
  useEffect(() => draw_each(has_world && view === "world"), [has_world, view]);
  useEffect(watch_links, []);
  useEffect(() => {
    addEventListener("keydown", on_key);
    return () => removeEventListener("keydown", on_key);
  }, []);
  useEffect(() => { if (known) follow_run(); });
  const invariants: any[] = state.summary?.invariants ?? [];
  const broken = invariants.filter((each) => !each.held).length;
  const is_decided = invariants.every((each) => each.decided);
  const toggle_theme = () => {
    const dark = getComputedStyle(document.documentElement).colorScheme.includes("dark") && document.documentElement.dataset.theme !== "light";
    set_theme(dark ? "light" : "dark");
  };
  return (
    <>
      <a class="skip" href="#view" onClick={(event) => { event.preventDefault(); document.getElementById("view")?.focus(); }}>{texts.skip}</a>
      <header>
        <img src="icon.svg" alt="" width="26" height="26" />
        <h1>{title_of(hello)}</h1>
        <Transport />
        <div class="right">
          {invariants.length > 0 && (
            <button type="button" class={`verdict ${!is_now ? "" : broken ? "bad" : state.play?.trouble ? "" : "good"}`} onClick={() => pick("events")}>
              {!is_now ? texts.unknown_verdict : broken ? texts.broken(broken) : is_decided ? texts.all_held : texts.none_broken}
            </button>
          )}
          {known && <button type="button" onClick={() => share(true)}>{texts.share}</button>}
          <button type="button" class="icon" aria-label={texts.theme} title={texts.theme} onClick={toggle_theme}>◐</button>
        </div>
      </header>
      <nav aria-label={texts.views_label}>
        {Object.keys(views).map((each) => (
          <button type="button" key={each} aria-current={each === view ? "page" : undefined} onClick={() => pick(each)}>
            <Icon name={each} /><span>{texts.views[each === "world" && known && !has_world ? "overview" : each]}</span>
          </button>
        ))}
      </nav>
      <main id="view" tabIndex={0} data-view={view}>
        <Status />
        {known && <View />}
      </main>
      {shares && <Share close={() => share(false)} />}
    </>
  );
}

try {
  const theme = localStorage.getItem("theme");
  if (theme) document.documentElement.dataset.theme = theme;
} catch {
  // From the system.
}
if (location.search && !plays_here) history.replaceState(null, "", location.pathname + location.hash);
start();
render(<Page />, document.getElementById("page")!);
