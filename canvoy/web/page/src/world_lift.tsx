// The building: shafts with cars and doors, people at the landings, and the state of the lifts.
import { useState } from "preact/hooks";
import { ask, useLive, type Json } from "./live";
import { Card, Layout, Legend, State, number_text, type PictureProps } from "./parts";
import { SortHead, useSorted } from "./sorted";
import { texts } from "./texts";

const left = 158;
const least_floor = 26;  // room for two adjacent buttons of 24 pixels, the size for a finger

interface Sizes {
  pitch: number;
  car_width: number;
  width: number;
  floors: Json[];
  floor_height: number;
  height: number;
  y: (height_m: number) => number;
}

/** In pixels: the picture is not scaled below readable size. */
function sizes_of(scenery: Json, lifts: number): Sizes {
  const floors: Json[] = scenery.floors ?? [];
  const count = Math.max(floors.length, 2);
  const floor_height = Math.max(least_floor, Math.min(48, 520 / count));
  const top = floors.at(-1)?.height_m || 1;
  const span = floor_height * (count - 1);
  const y = (height_m: number) => 34 + floor_height + span * (1 - height_m / top);
  const [pitch, car_width] = lifts > 4 ? [56, 36] : [78, 46];
  return { pitch, car_width, width: left + lifts * pitch + 4, floors, floor_height, height: span + floor_height + 50, y };
}

/** Standing people: some figures, and a number if there are more. */
function People(props: { x: number; y: number; count: number; room: number; size: number; class: string; flip?: boolean }) {
  const step = props.size * 0.52;
  const shown = Math.min(props.count, Math.floor(props.room / step));
  const way = props.flip ? -1 : 1;
  return (
    <g class={props.class}>
      {Array.from({ length: shown }, (_, i) => {
        const x = props.x + way * (i + 0.5) * step;
        const r = props.size * 0.15;
        return (
          <g key={i}>
            <circle cx={x} cy={props.y - props.size * 0.8} r={r} />
            <path d={`M${x - r * 1.5} ${props.y}v${-props.size * 0.4}a${r * 1.5} ${r * 1.5} 0 0 1 ${r * 3} 0v${props.size * 0.4}z`} />
          </g>
        );
      })}
      {props.count > shown && (
        <text x={props.x + way * (shown * step + 3)} y={props.y - 3} text-anchor={props.flip ? "end" : "start"}>
          {props.count}
        </text>
      )}
    </g>
  );
}

function Car(props: { lift: Json; number: number; rated: Json; sizes: Sizes }) {
  const { lift, number, sizes } = props;
  const { pitch, car_width } = sizes;
  const x = left + (number - 1) * pitch;
  const h = sizes.floor_height - 4;
  const y = sizes.y(lift.position_m) - h;
  const leaf = (car_width / 2) * (1 - lift.open);
  const fill = Math.min(1, lift.load_kg / (props.rated?.rated_load_kg || 1));
  const person = Math.min(h * 0.8, 26);
  return (
    <g class={`car ${lift.mode === "normal" ? "" : "odd"} ${lift.overload ? "over" : ""}`} transform={`translate(${x} ${y})`}>
      <rect class="cabin" width={car_width} height={h} rx="3" />
      <rect class="load" x="1" y={h - 3} width={(car_width - 2) * fill} height="2" />
      {lift.open > 0.1 && <People x={3} y={h - 4} count={lift.persons} room={car_width - 14} size={person} class="riders" />}
      <rect class="leaf" x="0" width={leaf} height={h} rx="2" />
      <rect class="leaf" x={car_width - leaf} width={leaf} height={h} rx="2" />
      {leaf > 14 && lift.persons > 0 && (
        <text class="count" x={car_width / 2} y={h / 2 + 5} text-anchor="middle">{lift.persons}</text>
      )}
      {lift.direction !== "none" && (
        <path class="lantern" transform={`translate(${car_width + 9} ${h / 2})`}
          d={lift.direction === "up" ? "M0 -6l6 10h-12z" : "M0 6l6 -10h-12z"} />
      )}
    </g>
  );
}

function Landing(props: { index: number; landing: Json; sizes: Sizes; lifts: number; can: boolean; call: (up: boolean) => void }) {
  const { index, landing, sizes } = props;
  const floor = sizes.floors[index];
  const y = sizes.y(floor.height_m);
  const size = Math.min(sizes.floor_height * 0.72, 28);
  const button = (up: boolean) => {
    const lit = up ? landing?.lamp_up : landing?.lamp_down;
    const exists = up ? index < sizes.floors.length - 1 : index > 0;
    const label = up ? texts.call_up(floor.floor) : texts.call_down(floor.floor);
    const press = () => props.call(up);
    const on_key = (event: KeyboardEvent) => {
      if (event.key !== "Enter" && event.key !== " ") return;
      event.preventDefault();
      press();
    };
    const r = Math.min(9, sizes.floor_height * 0.34);
    return exists ? (
      <g class={`call ${lit ? "lit" : ""}`} transform={`translate(${left - (up ? 44 : 18)} ${y - sizes.floor_height / 2})`}
        role="button" tabindex={props.can ? 0 : -1} aria-label={label} aria-pressed={lit ? "true" : "false"}
        data-floor={index + 1} data-way={up ? "up" : "down"} onClick={press} onKeyDown={on_key}>
        <title>{label}</title>
        <rect class="hit" x="-12.5" y="-12.5" width="25" height="25" />
        <circle r={r + 2} />
        <path d={up ? `M0 ${-r * 0.6}l${r * 0.65} ${r}h${-r * 1.3}z` : `M0 ${r * 0.6}l${r * 0.65} ${-r}h${-r * 1.3}z`} />
      </g>
    ) : null;
  };
  return (
    <g class="landing">
      <line class="slab" x1="0" x2={left + props.lifts * sizes.pitch - 24} y1={y} y2={y} />
      <text class="floor-name" x="24" y={y - sizes.floor_height / 2 + 5} text-anchor="end">{floor.floor}</text>
      <People x={left - 62} y={y - 1} count={(landing?.waiting_up ?? 0) + (landing?.waiting_down ?? 0)} room={58} size={size} class="waiters" flip />
      {button(true)}
      {button(false)}
    </g>
  );
}

type Numbered = [lift: Json, number: number];
const lift_columns = {
  lift: ([, number]: Numbered) => number, floor: ([lift]: Numbered) => lift.floor, state: ([lift]: Numbered) => lift.mode, speed: ([lift]: Numbered) => lift.speed_m_s,
  load: ([lift]: Numbered) => lift.load_kg, starts: ([lift]: Numbered) => lift.starts, energy: ([lift]: Numbered) => lift.energy_wh,
};

function LiftTable(props: { lifts: Json[] }) {
  const rows = useSorted(props.lifts.map((lift, i): Numbered => [lift, i + 1]), lift_columns);
  return (
    <div class="scroll" tabIndex={0} role="region" aria-label={texts.lifts}>
      <table class="plain">
        <thead>
          <tr>{texts.lift_columns.map(([by, name], i) => <SortHead key={by} by={by} title={name} class={i > 2 ? "number" : ""} />)}</tr>
        </thead>
        <tbody>
          {rows.map(([lift, number]) => (
            <tr key={number}>
              <td>{number}</td>
              <td>{lift.floor}</td>
              <td><State state={lift.mode} /></td>
              <td class="number">{lift.speed_m_s.toFixed(1)} m/s</td>
              <td class="number">{lift.load_kg.toFixed(0)} kg</td>
              <td class="number">{lift.starts}</td>
              <td class="number">{number_text(lift.energy_wh / 1000)} kWh</td>
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

export function LiftWorld(props: PictureProps) {
  const { state, hello } = useLive();
  const [said, say] = useState("");
  const [chosen, choose] = useState("");
  const wanted = Number(chosen);  // 0: as far as there are floors
  const snapshot = state.snapshot ?? {};
  const lifts: Json[] = snapshot.lifts ?? [];
  const sizes = sizes_of(hello.scenery ?? {}, Math.max(lifts.length, 1));
  const { pitch, car_width } = sizes;
  const count = sizes.floors.length;
  const call = async (index: number, up: boolean) => {
    const from = index + 1;
    const to = wanted > 0 && wanted !== from && up === wanted > from ? wanted : up ? count : 1;
    const answer = await ask("visit", { from, to });
    say(answer.error ?? texts.called(sizes.floors[from - 1].floor, sizes.floors[to - 1].floor));
  };
  const picture = (
    <Card class="picture">
      <div class="scroll" tabIndex={0} role="region" aria-label={texts.kinds.lift}>
      <svg viewBox={`0 0 ${sizes.width} ${sizes.height}`} width={sizes.width} height={sizes.height} class="building" role="group" aria-label={texts.kinds.lift}>
        <clipPath id="hoistway"><rect x="0" y="26" width={sizes.width} height={sizes.height} /></clipPath>
        <rect class="wall" x={left - 6} y="22" width={Math.max(lifts.length, 1) * pitch + 6} height={sizes.height - 38} rx="6" />
        {sizes.floors.map((_, i) => (
          <Landing key={i} index={i} landing={snapshot.landings?.[i]} sizes={sizes} lifts={Math.max(lifts.length, 1)} can={hello.can?.visit} call={(up) => void call(i, up)} />
        ))}
        {lifts.map((lift, i) => {
          const x = left + i * pitch;
          return (
            <g key={i}>
              <rect class="shaft" x={x - 3} y="24" width={car_width + 6} height={sizes.height - 42} rx="4" />
              <g clip-path="url(#hoistway)"><path class="rope" d={`M${x + car_width / 2} 0v${-sizes.height}`} style={{ transform: `translateY(${sizes.y(lift.position_m) - sizes.floor_height + 4}px)` }} /></g>
              {lift.car_calls?.map((floor: number) => (
                <rect key={floor} class="car-call" x={x + car_width + 5} y={sizes.y(sizes.floors[floor - 1]?.height_m ?? 0) - sizes.floor_height / 2 - 2} width="8" height="4" rx="2" />
              ))}
              <text class="shaft-name" x={x + car_width / 2} y="15" text-anchor="middle">{i + 1}</text>
            </g>
          );
        })}
        {lifts.map((lift, i) => <Car key={i} lift={lift} number={i + 1} rated={hello.scenery?.lifts?.[i]} sizes={sizes} />)}
      </svg>
      </div>
      <Legend rows={texts.legends.lift} />
      {hello.can?.visit && (
        <label class="visitor">{texts.visitors_go}
          <select value={chosen} onChange={(event) => choose(event.currentTarget.value)}>
            <option value="">{texts.visitors_far}</option>
            {sizes.floors.map((floor, i) => <option key={i} value={String(i + 1)}>{texts.floor} {floor.floor}</option>)}
          </select>
        </label>
      )}
      <p class="said" role="status">{said}</p>
    </Card>
  );
  const figures = [
    { name: texts.waiting_people, value: snapshot.waiting ?? 0 },
    { name: texts.riding_people, value: snapshot.riding ?? 0 },
    { name: texts.served_people, value: snapshot.served ?? 0 },
  ];
  return <Layout kind={`lift ${lifts.length > 4 ? "many" : ""}`} figures={figures} picture={picture} details={<Card title={texts.lifts}><LiftTable lifts={lifts} /></Card>} parts={props} />;
}
