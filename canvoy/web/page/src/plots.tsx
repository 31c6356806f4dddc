// Pinned values over time.
import { useEffect, useRef } from "preact/hooks";
import type uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { part, refine } from "./address";
import { live, pin, useLive, type Sample } from "./live";
import { Card, day_text, measure_text, owner_name, save, tick_text, time_text } from "./parts";
import { texts } from "./texts";
import { emergency_times, fault_spans } from "./trends";

const states_max = 500;

const colour = (name: string) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

let library: Promise<typeof uPlot> | undefined;
/** Loaded when needed: most users of the page open no plots. */
const plot_library = () => (library ??= new Promise((resolve, reject) => {
  const script = document.createElement("script");
  script.src = "uplot.js";
  script.onload = () => resolve((window as unknown as { uPlot: typeof uPlot }).uPlot);
  script.onerror = reject;
  document.head.append(script);
}));

/** Samples of a value that is constant until it changes, up to the present. */
function data_of(key: string, now: number, begin = shown_span()[0]): uPlot.AlignedData {
  const samples = live.samples.get(key) ?? [];
  const xs = samples.map(([time]) => time);
  const ys = samples.map(([, value]) => (typeof value === "number" ? value : null));  // a name: it had no number then
  // What lies before the shown time is not drawn: the value that was there at its begin is.
  const next = xs.findIndex((time) => time > begin);
  if (next > 0 && xs[next - 1] < begin) {
    xs.splice(next, 0, begin);
    ys.splice(next, 0, ys[next - 1]);
  }
  if (samples.length && now > xs[xs.length - 1]) {
    xs.push(now);
    ys.push(ys[ys.length - 1]);
  }
  return [xs, ys];
}

// Ticks at times that people count in, in seconds.
const steps = [0.001, 0.01, 0.1, 0.5, 1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200, 14400, 21600, 43200, 86400];
const step_digits = (step: number) => (step < 0.01 ? 3 : step < 0.1 ? 2 : step < 1 ? 1 : 0);

/** Faults as bands, emergencies as marks at the top. */
function draw_faults(u: uPlot) {
  const { ctx } = u;
  const { left, top, width, height } = u.bbox;
  const x = (time: number) => Math.max(left, Math.min(left + width, u.valToPos(time, "x", true)));
  ctx.save();
  ctx.globalAlpha = 0.22;
  ctx.fillStyle = colour("--bad");
  for (const span of fault_spans(live.state.time)) {
    if (x(span.end) > left && x(span.begin) < left + width) ctx.fillRect(x(span.begin), top, Math.max(2, x(span.end) - x(span.begin)), height);
  }
  ctx.globalAlpha = 1;
  ctx.fillStyle = colour("--lamp");
  for (const time of emergency_times()) if (x(time) > left && x(time) < left + width) ctx.fillRect(x(time) - 1, top, 2, 10);
  ctx.restore();
}

/** A value with names: a band for each state, over the same time as the curves. */
function States(props: { samples: Sample[]; begin: number; end: number }) {
  const { begin, end } = props;
  const spans = props.samples
    .map(([time, value], i) => ({ from: Math.max(begin, time), to: Math.min(end, props.samples[i + 1]?.[0] ?? live.state.time), name: String(value) }))
    .filter((span) => span.to > span.from);
  const names = [...new Set(props.samples.map(([, value]) => String(value)))];
  const share = (time: number) => (100 * (time - begin)) / Math.max(end - begin, 1e-6);
  return (
    <>
      <div class="states" role="img" aria-label={spans.slice(-20).map((span) => `${time_text(span.from, 1)} ${span.name}`).join(", ")}>
        {spans.slice(-states_max).map((span) => (
          <span key={span.from} class={`band-${names.indexOf(span.name) % 8}`} style={{ left: `${share(span.from)}%`, width: `${share(span.to) - share(span.from)}%` }} title={`${span.name}, ${texts.at_time} ${time_text(span.from, 1)}`}>{span.name}</span>
        ))}
      </div>
      <p class="trend-scale muted"><span>{time_text(begin, 0)}</span><span>{time_text(end, 0)}</span></p>
    </>
  );
}

function Curve(props: { name: string; unit: string }) {
  const box = useRef<HTMLDivElement>(null);
  const plot = useRef<uPlot | null>(null);
  const zoomed = useRef(part("zoom") !== "");
  /** Returns the function that ends it. */
  const draw = (Library: typeof uPlot, where: HTMLDivElement) => {
    const width = () => where.clientWidth;
    const axis = { stroke: colour("--muted"), grid: { stroke: colour("--line"), width: 1 }, ticks: { stroke: colour("--line") }, font: "12px system-ui, sans-serif" };
    const made = new Library(
      {
        width: width(),
        height: 180,
        legend: { live: true },
        cursor: { sync: { key: "pins" }, drag: { x: true, y: false } },
        scales: { x: { time: false } },
        axes: [
          { ...axis, incrs: steps, space: 90, values: (_: uPlot, splits: number[], __: number, ___: number, step: number) => splits.map((time) => time_text(time, step_digits(step))) },
          { ...axis, values: (_: uPlot, splits: number[], __: number, ___: number, step: number) => splits.map((value) => tick_text(value, step)), size: (_: uPlot, values: string[] | null) => 24 + 7 * Math.max(3, ...(values ?? []).map((each) => each.length)) },
        ],
        series: [
          { label: texts.time, value: (_: uPlot, time: number | null) => (time === null ? "–" : time_text(time, 1)) },
          { label: props.unit || texts.value, stroke: colour("--accent"), width: 2, fill: colour("--accent-faint"), paths: Library.paths.stepped!({ align: 1 }), points: { show: false } },
        ],
        hooks: {
          drawClear: [draw_faults],
          setSelect: [(u) => {
            if (u.select.width === 0) return;
            zoomed.current = true;
            const [begin, end] = [u.select.left, u.select.left + u.select.width].map((x) => u.posToVal(x, "x"));
            refine({ zoom: `${begin.toFixed(3)} ${end.toFixed(3)}` });
            queueMicrotask(() => u.setData(data_of(props.name, live.state.time, begin), false));
          }],
        },
      },
      data_of(props.name, live.state.time),
      where,
    );
    made.over.addEventListener("dblclick", () => {
      zoomed.current = false;
      refine({ zoom: "" });
    });
    const [min, max] = part("zoom").split(" ").map(Number);
    if (max > min) made.setScale("x", { min, max });
    plot.current = made;
    const observer = new ResizeObserver(() => made.setSize({ width: width(), height: 180 }));
    observer.observe(where);
    return () => {
      observer.disconnect();
      made.destroy();
      plot.current = null;
    };
  };
  useEffect(() => {
    let is_shown = true;
    let end = () => {};
    void plot_library().then((Library) => { if (is_shown && box.current) end = draw(Library, box.current); });
    return () => {
      is_shown = false;
      end();
    };
  }, [live.hello]);
  useEffect(() => {
    plot.current?.setData(data_of(props.name, live.state.time), false);
    const [min, max] = shown_span();
    if (!zoomed.current && max > min) plot.current?.setScale("x", { min, max });
  });
  return <div ref={box} />;
}

/** The zoomed time, or that of all pinned values. */
function shown_span(): [number, number] {
  const [min, max] = part("zoom").split(" ").map(Number);
  if (max > min) return [min, max];
  const firsts = [...live.samples.values()].flatMap((samples) => samples.slice(0, 1).map(([time]) => time));
  return [Math.min(live.state.time, ...firsts), live.state.time];
}

function Plot(props: { name: string }) {
  const { samples } = useLive();
  const mine = samples.get(props.name) ?? [];
  const value = live.values.get(props.name);
  const title = value ? `${owner_name(value)}: ${value.name ?? value.index}` : props.name;
  const has_names = mine.length > 0 && mine.every(([, each]) => typeof each === "string");
  const [begin, end] = shown_span();
  return (
    <section class="plot">
      <h3>
        <span>{title}</span>
        <b>{measure_text(value)}</b>
        <button type="button" class="icon" aria-label={`${texts.unpin}: ${title}`} onClick={() => pin(props.name)}>×</button>
      </h3>
      {has_names ? <States samples={mine} begin={begin} end={end} /> : mine.length > 0 ? <Curve name={props.name} unit={value?.unit ?? ""} /> : <p class="hint">{texts.plot_waits}</p>}
    </section>
  );
}

export function Plots() {
  const { samples } = useLive();
  const keys = [...samples.keys()];
  const csv = () =>
    ["time,bus,node,object,name,value,unit"]
      .concat(keys.flatMap((key) => {
        const value = live.values.get(key);
        return (samples.get(key) ?? []).map(([time, y]) =>
          [time, value?.bus, value?.node, `${value?.index}:${value?.sub}`, JSON.stringify(value?.name ?? ""), y, value?.unit ?? ""].join(","));
      }))
      .join("\n");
  return (
    <Card title={texts.views.plots}>
      {keys.length === 0 ? <p class="hint">{texts.plots_none}</p> : (
        <div class="tools"><p class="hint grow">{day_text(live.state.time)} {texts.plots_hint}</p><button type="button" onClick={() => save("plots.csv", csv(), "text/csv")}>{texts.plots_export}</button></div>
      )}
      {keys.map((key) => <Plot key={key} name={key} />)}
    </Card>
  );
}
