// Pinned values over time.
import { useEffect, useRef } from "preact/hooks";
import type uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { part, refine } from "./address";
import { live, pin, useLive } from "./live";
import { Card, device_name, save, measure_text } from "./parts";
import { texts } from "./texts";

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
function data_of(key: string, now: number): uPlot.AlignedData {
  const samples = live.samples.get(key) ?? [];
  const xs = samples.map((each) => each[0]);
  const ys = samples.map((each) => each[1]);
  if (samples.length && now > xs[xs.length - 1]) {
    xs.push(now);
    ys.push(ys[ys.length - 1]);
  }
  return [xs, ys];
}

function Plot(props: { name: string }) {
  const { state } = useLive();
  const box = useRef<HTMLDivElement>(null);
  const plot = useRef<uPlot | null>(null);
  const zoomed = useRef(part("zoom") !== "");
  const value = live.values.get(props.name);
  const title = value ? `${device_name(value.bus, value.node)}: ${value.name ?? value.index}` : props.name;
  /** Returns the function that ends it. */
  const draw = (Library: typeof uPlot, where: HTMLDivElement) => {
    const width = () => where.clientWidth;
    const axis = { stroke: colour("--muted"), grid: { stroke: colour("--line"), width: 1 }, ticks: { stroke: colour("--line") } };
    const made = new Library(
      {
        width: width(),
        height: 180,
        legend: { live: true },
        cursor: { sync: { key: "pins" }, drag: { x: true, y: false } },
        scales: { x: { time: live.hello.time_is === "clock" } },
        axes: [axis, { ...axis, size: 64 }],
        series: [{ label: texts.time }, { label: value?.unit ?? texts.value, stroke: colour("--accent"), width: 2, fill: colour("--accent-faint"), paths: Library.paths.stepped!({ align: 1 }), points: { show: false } }],
        hooks: {
          setSelect: [(u) => {
            if (u.select.width === 0) return;
            zoomed.current = true;
            refine({ zoom: [u.select.left, u.select.left + u.select.width].map((x) => u.posToVal(x, "x").toFixed(3)).join(" ") });
          }],
        },
      },
      data_of(props.name, state.time),
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
  useEffect(() => plot.current?.setData(data_of(props.name, live.state.time), !zoomed.current));
  return (
    <section class="plot">
      <h3>
        <span>{title}</span>
        <b>{measure_text(value)}</b>
        <button type="button" class="icon" aria-label={`${texts.unpin}: ${title}`} onClick={() => pin(props.name)}>×</button>
      </h3>
      <div ref={box} />
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
        <div class="tools"><p class="hint grow">{texts.plots_hint}</p><button type="button" onClick={() => save("plots.csv", csv(), "text/csv")}>{texts.plots_export}</button></div>
      )}
      {keys.map((key) => <Plot key={key} name={key} />)}
    </Card>
  );
}
