// The dashboard of a taxi, a police car from above with its lights, and a bus with its displays.
import { useLive, type Json } from "./live";
import { Card, Layout, Legend, number_text, type PictureProps } from "./parts";
import { texts } from "./texts";

function Screen(props: { title: string; text: string | undefined; class?: string }) {
  return (
    <figure class={`screen ${props.class ?? ""}`}>
      <figcaption>{props.title}</figcaption>
      <pre>{props.text?.trimEnd() || " "}</pre>
    </figure>
  );
}

function lines_of(text: unknown): string {
  if (Array.isArray(text)) return text.join("\n");
  return typeof text === "string" ? text : "";
}

export function TaxiWorld(props: PictureProps) {
  const { state } = useLive();
  const now = state.snapshot ?? {};
  const meter = now.meter ?? {};
  const lamps: string[] = now.lamps ?? [];
  const lit = lamps.some((lamp) => lamp === "on" || lamp === "dimmed" || lamp === "blinking");
  const picture = (
    <Card class="picture">
      <svg viewBox="60 8 520 188" role="img" aria-label={texts.kinds.taxi}>
        <g class={`roof-sign ${lit ? "lit" : ""}`}><rect x="270" y="18" width="100" height="30" rx="6" /><text x="320" y="40" text-anchor="middle">TAXI</text></g>
        <path class="body" d="M90 150q0-42 42-46l58-8q40-46 100-46h80q60 0 92 46l52 10q46 8 46 44v14h-470z" />
        <path class="window" d="M206 96q32-32 84-32h22v32zM326 64h44q48 0 74 32h-118z" />
        <circle class="wheel" cx="190" cy="164" r="28" /><circle class="wheel" cx="452" cy="164" r="28" />
        <text class="big" x="320" y="142" text-anchor="middle">{Math.round((now.plant?.speed_m_per_s ?? 0) * 3.6)} km/h</text>
      </svg>
      <p class="said" role="status">{now.driver}</p>
      <div class="meter">
        <span class="meter-state">{meter.state}</span>
        <span>{texts.tariff} {meter.level}</span>
        <span>{number_text(meter.distance_km ?? 0)} km</span>
        <output>{(meter.total ?? meter.fare ?? 0).toFixed?.(2)}</output>
      </div>
      <Legend rows={texts.legends.taxi} />
    </Card>
  );
  const figures = [
    { name: texts.served_people, value: now.carried ?? 0 },
    { name: texts.paid, value: (now.paid ?? 0).toFixed(2) },
    { name: texts.driven, value: number_text((now.plant?.distance_m ?? 0) / 1000), unit: "km" },
  ];
  const details = (
    <div class="pair">
      <Card title={texts.terminal}>
        {(now.displays ?? []).map((each: Json, i: number) => <Screen key={i} title={`${i + 1}`} text={lines_of(each.text)} />)}
      </Card>
      <Card title={texts.paper}><pre class="paper">{lines_of(now.paper) || " "}</pre></Card>
    </div>
  );
  return <Layout kind="taxi" figures={figures} picture={picture} details={details} parts={props} />;
}

export function PoliceWorld(props: PictureProps) {
  const { state } = useLive();
  const now = state.snapshot ?? {};
  const plant = now.plant ?? {};
  const beacons: boolean[] = plant.beacons ?? [];
  const flashers: boolean[] = plant.flashers ?? [];
  const terminal = now.terminal ?? {};
  const siren = plant.siren !== undefined && plant.siren !== "none";
  const is_on = (key: string) => (key === "siren" ? siren : !!plant[key]);
  const picture = (
    <Card class="picture">
      <svg viewBox="60 0 580 206" role="img" aria-label={texts.kinds.police}>
        {plant.blue_light && <rect class="glow" x="200" y="6" width="240" height="70" rx="35" />}
        <g class="roof-bar">
          {beacons.map((on, i) => <rect key={i} class={`beacon ${on ? "on" : ""}`} x={240 + i * (160 / Math.max(beacons.length, 1))} y="30" width={150 / Math.max(beacons.length, 1)} height="20" rx="5" />)}
        </g>
        <path class="body" d="M90 160q0-42 42-46l58-8q40-50 100-50h80q60 0 92 50l52 10q46 8 46 44v14h-470z" />
        <path class="window" d="M206 106q32-36 84-36h22v36zM326 70h44q48 0 74 36h-118z" />
        {flashers.map((on, i) => <rect key={i} class={`beacon ${on ? "on" : ""}`} x={512 - i * 16} y="120" width="12" height="10" rx="3" />)}
        <circle class="wheel" cx="190" cy="174" r="28" /><circle class="wheel" cx="452" cy="174" r="28" />
        <text class="big" x="320" y="150" text-anchor="middle">{Math.round((plant.speed_m_per_s ?? 0) * 3.6)} km/h</text>
        {siren && <g class="siren"><path d="M560 60q16 20 0 40M576 46q28 34 0 68M592 32q40 48 0 96" /></g>}
      </svg>
      <p class="said" role="status">{now.crew}</p>
      <ul class="chips">
        {texts.police_chips.map(([key, text]) => <li key={key} class={is_on(key) ? "on" : ""}>{text}</li>)}
      </ul>
      <Legend rows={texts.legends.police} />
    </Card>
  );
  const figures = [
    { name: texts.calls, value: `${now.statistics?.attended ?? 0} / ${now.statistics?.calls ?? 0}` },
    { name: texts.response, value: number_text(now.statistics?.mean_response_s ?? 0), unit: "s" },
    { name: texts.driven, value: number_text((plant.distance_m ?? 0) / 1000), unit: "km" },
  ];
  const details = (
    <Card title={`${texts.terminal}: ${terminal.client ?? ""}`}>
      <div class="screens">
        <Screen title="1" text={lines_of(terminal.display_1)} />
        <Screen title="2" text={lines_of(terminal.display_2)} />
      </div>
    </Card>
  );
  return <Layout kind="police" figures={figures} picture={picture} details={details} parts={props} />;
}

const is_destination = (display: Json) => /destination/.test(display.display ?? "");
const is_next_stop = (display: Json) => /next-stop/.test(display.display ?? "");
const one_line = (text: unknown) => lines_of(text).split("\n").map((line) => line.trim()).filter(Boolean).join(" ");

/** A car as its passengers see it: its own destination and next stop, and its lamp. The doors are those of the vehicle. */
function Car(props: { number: number; displays: Json[]; doors: string[]; cars: number }) {
  const { number, displays } = props;
  const sign = displays.find(is_next_stop);
  const doors = number === 1 ? props.doors : [];
  const windows = [0, 1, 2, 3, 4, 5].slice(0, 6 - doors.length);
  const name = texts.car(number);
  return (
    <svg viewBox="36 20 568 176" role="img" aria-label={props.cars === 1 ? texts.kinds["bus-line"] : name} class={number > 1 && props.cars > 2 ? "behind" : ""}>
      <rect class="body" x="50" y="30" width="540" height="130" rx="16" />
      <rect class="led" x="70" y="38" width="420" height="30" rx="4" />
      <text class="led-text" x="82" y="59">{one_line(displays.find(is_destination)?.text)}</text>
      {sign?.stop_sign && <text class="led-text stop-lamp" x="482" y="59" text-anchor="end">STOP</text>}
      {windows.map((i) => <rect key={i} class="window" x={70 + i * 86} y="74" width="76" height="30" rx="6" />)}
      {doors.map((state, i) => (
        <g key={i} class={`bus-door ${state}`}>
          <rect x={506 - i * 86} y="74" width="62" height="80" rx="4" />
          <path d={state === "closed" ? `M${537 - i * 86} 74v80` : `M${512 - i * 86} 74v80M${562 - i * 86} 74v80`} />
        </g>
      ))}
      <rect class="led" x="70" y="109" width={doors.length > 1 ? 336 : 420} height="27" rx="4" />
      <text class="led-text" x="82" y="129">{sign ? one_line(sign.text) : ""}</text>
      {props.cars > 1 && <text class="car-name" x="578" y="59" text-anchor="end">{name}</text>}
      {number > 1 && <path class="coupling" d="M590 140h14" />}
      {number < props.cars && <path class="coupling" d="M50 140h-14" />}
      <circle class="wheel" cx="150" cy="164" r="26" /><circle class="wheel" cx="410" cy="164" r="26" />
    </svg>
  );
}

export function BusLineWorld(props: PictureProps) {
  const { state } = useLive();
  const now = state.snapshot ?? {};
  const plant = now.plant ?? {};
  const displays: Json[] = now.displays ?? [];
  const cars = Math.max(1, ...displays.map((each) => each.car ?? 1));
  const of_car = (car: number) => displays.filter((each) => (each.car ?? 1) === car);
  const picture = (
    <Card class="picture">
      <div class="cars">
        {Array.from({ length: cars }, (_, i) => <Car key={i} number={i + 1} displays={of_car(i + 1)} doors={plant.doors ?? []} cars={cars} />)}
      </div>
      <p class="said" role="status"><b>{Math.round((plant.speed_m_per_s ?? 0) * 3.6)} km/h</b> · {plant.at_stop ? `${texts.stands_at} ` : `${texts.next_stop} `}{plant.stop ?? ""}{plant.stop_requested ? ` · ${texts.stop_requested}` : ""}</p>
      <div class="screens">
        {displays.map((each, i) => <Screen key={i} class="led-screen" title={`${each.display ?? each.node}${each.stop_sign ? " · STOP" : ""}`} text={lines_of(each.text)} />)}
      </div>
      <Legend rows={texts.legends.busline} />
    </Card>
  );
  const figures = [
    { name: texts.aboard, value: plant.aboard ?? 0 },
    { name: texts.counted, value: now.counted_aboard ?? 0 },
    { name: texts.delay, value: number_text(plant.delay_s ?? 0), unit: "s" },
  ];
  const details = (
    <Card title={texts.journey}>
      <table class="plain"><tbody>
        {texts.bus_rows.map(([name, key]) => <tr key={key}><td>{name}</td><td class="number">{String(key === "local_time" ? (now[key] ?? "–") : (plant[key] ?? "–"))}</td></tr>)}
      </tbody></table>
    </Card>
  );
  return <Layout kind="busline" figures={figures} picture={picture} details={details} parts={props} />;
}
