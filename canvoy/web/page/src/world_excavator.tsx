// An excavator: the machine from the side and from above, and the seat with its held, pressed, lit
// and shown elements.
import { useLive, type Json } from "./live";
import { Card, Layout, Legend, number_text, type PictureProps } from "./parts";
import { texts } from "./texts";

// The picture: metres in front of the axis of the slew and above the ground, as in the snapshot.
const scale = 40;
const axis = { x: 150, y: 300 };
const x_of = (metres: number) => axis.x + metres * scale;
const y_of = (metres: number) => axis.y - metres * scale;
// Position of the heap, in degrees of the slew.
const heap = { at: 80, width: 20 };

const bar = ([[x1, z1], [x2, z2]]: [number, number][], thick: number, thin: number) => {
  // A beam with a thick foot: its corners are across the line between the joints.
  const length = Math.hypot(x2 - x1, z2 - z1) || 1;
  const across = [-(z2 - z1) / length, (x2 - x1) / length];
  const corner = (x: number, z: number, by: number) => `${x_of(x + across[0] * by).toFixed(1)} ${y_of(z + across[1] * by).toFixed(1)}`;
  return `M${corner(x1, z1, thick)}L${corner(x2, z2, thin)}L${corner(x2, z2, -thin)}L${corner(x1, z1, -thick)}z`;
};

function Bucket(props: { from: [number, number]; to: [number, number]; share: number }) {
  const [x1, z1] = props.from;
  const [x2, z2] = props.to;
  const length = Math.hypot(x2 - x1, z2 - z1) || 1;
  // Hollow on the side of the cab, to the right of the direction from hinge to tip.
  const right = [(z2 - z1) / length, -(x2 - x1) / length];
  const at = (along: number, away: number) =>
    `${x_of(x1 + (x2 - x1) * along + right[0] * away).toFixed(1)} ${y_of(z1 + (z2 - z1) * along + right[1] * away).toFixed(1)}`;
  const depth = 0.75;
  return (
    <g>
      {props.share > 0.02 && <path class="earth" d={`M${at(0.05, 0)}Q${at(0.1, depth * props.share)} ${at(0.5, depth * props.share)}T${at(1, 0)}z`} />}
      <path class="bucket" d={`M${at(0, 0)}Q${at(0.05, depth)} ${at(0.55, depth)}T${at(1, 0)}`} />
    </g>
  );
}

function Machine(props: { now: Json }) {
  const { now } = props;
  const plant = now.plant ?? {};
  const arm: [number, number][] = plant.arm ?? [[0.6, 1.8], [4, 5], [6.5, 3], [6.5, 1.5]];
  const tracks = (now.movements?.left_track?.place ?? 0) * scale;
  const share = Math.min(1, (plant.bucket_m3 ?? 0) / 1.2);
  return (
    <g class="machine">
      <rect class="ground" x="0" y={y_of(0)} width="640" height="140" />
      <rect class="track" x={x_of(-1.9)} y={y_of(0.85)} width={3.9 * scale} height={0.85 * scale} rx={0.42 * scale} />
      <path class="links" d={`M${x_of(-1.6)} ${y_of(0.03)}H${x_of(1.7)}`} style={{ strokeDashoffset: `${-tracks % 16}` }} />
      <rect class="body" x={x_of(-2.3)} y={y_of(2.1)} width={3.3 * scale} height={1.15 * scale} rx="8" />
      <path class="body" d={`M${x_of(-0.4)} ${y_of(2.1)}V${y_of(3.5)}H${x_of(0.7)}L${x_of(1)} ${y_of(2.1)}z`} />
      <path class="window" d={`M${x_of(-0.15)} ${y_of(2.3)}V${y_of(3.3)}H${x_of(0.58)}L${x_of(0.82)} ${y_of(2.3)}z`} />
      {plant.beacon && <circle class="beacon on" cx={x_of(0.1)} cy={y_of(3.62)} r="6" />}
      {plant.light && <path class="work-light" d={`M${x_of(0.75)} ${y_of(3.2)}L${x_of(5)} ${y_of(2.2)}V${y_of(0)}L${x_of(3)} ${y_of(0)}z`} />}
      {plant.horn && <g class="siren"><path d={`M${x_of(1.2)} ${y_of(3.4)}q10 -10 0 -22M${x_of(1.45)} ${y_of(3.3)}q18 -18 0 -36`} /></g>}
      <path class="beam" d={bar([arm[0], arm[1]], 0.3, 0.2)} />
      <path class="beam" d={bar([arm[1], arm[2]], 0.22, 0.13)} />
      <Bucket from={arm[2]} to={arm[3]} share={share} />
      {arm.slice(0, 3).map(([x, z], i) => <circle key={i} class="joint" cx={x_of(x)} cy={y_of(z)} r="5" />)}
    </g>
  );
}

/** From above: the direction of the upper carriage, and the heap. */
function Slew(props: { degrees: number; reach: number }) {
  const point = (degrees: number, radius: number) => {
    const angle = (degrees * Math.PI) / 180;
    return `${(Math.sin(angle) * radius).toFixed(1)} ${(-Math.cos(angle) * radius).toFixed(1)}`;
  };
  const reach = Math.max(10, Math.min(46, props.reach * 5));
  return (
    <g class="slew" transform="translate(560 66)">
      <circle r="50" />
      <path class="heap" d={`M0 0L${point(heap.at - heap.width, 48)}A48 48 0 0 1 ${point(heap.at + heap.width, 48)}z`} />
      <rect class="track" x="-13" y="-17" width="6" height="34" rx="2" /><rect class="track" x="7" y="-17" width="6" height="34" rx="2" />
      <g transform={`rotate(${props.degrees})`}><rect class="body" x="-9" y="-8" width="18" height="20" rx="3" /><path class="boom" d={`M3 -6V${-reach}`} /></g>
      <text y="66" text-anchor="middle">{number_text(Math.round(props.degrees))}°</text>
    </g>
  );
}

function Stick(props: { name: string; x: number; y: number }) {
  return (
    <figure class="stick">
      <svg viewBox="-34 -34 68 68" role="img" aria-label={`${props.name}: ${Math.round(props.x * 100)} %, ${Math.round(props.y * 100)} %`}>
        <rect x="-32" y="-32" width="64" height="64" rx="12" />
        <path d="M-32 0H32M0 -32V32" />
        <line x1="0" y1="0" x2={props.x * 24} y2={-props.y * 24} />
        <circle cx={props.x * 24} cy={-props.y * 24} r="8" />
      </svg>
      <figcaption>{props.name}</figcaption>
    </figure>
  );
}

function Pedal(props: { name: string; at: number }) {
  const height = Math.abs(props.at) * 30;
  return (
    <figure class="stick pedal">
      <svg viewBox="-14 -34 28 68" role="img" aria-label={`${props.name}: ${Math.round(props.at * 100)} %`}>
        <rect x="-12" y="-32" width="24" height="64" rx="8" />
        <rect class="pressed" x="-12" y={props.at > 0 ? -height : 0} width="24" height={height} rx="4" />
        <path d="M-12 0H12" />
      </svg>
      <figcaption>{props.name}</figcaption>
    </figure>
  );
}

function Chips(props: { title: string; names: string[]; on: string[]; bad?: string[] }) {
  return (
    <>
      <h3 class="seat-title">{props.title}</h3>
      <ul class="chips">
        {props.names.map((name) => (
          <li key={name} class={props.on.includes(name) ? (props.bad?.includes(name) ? "on bad" : "on") : ""}>{name}</li>
        ))}
      </ul>
    </>
  );
}

function Seat(props: { now: Json }) {
  const { seat = {}, movements = {} } = props.now;
  const hand = (name: string) => movements[name]?.hand ?? 0;
  return (
    <Card title={texts.seat} class="seat">
      <div class="sticks">
        <Stick name={texts.left_stick} x={hand("slew")} y={hand("stick")} />
        <Pedal name={texts.left_pedal} at={hand("left_track")} />
        <Pedal name={texts.right_pedal} at={hand("right_track")} />
        <Stick name={texts.right_stick} x={hand("bucket")} y={hand("boom")} />
      </div>
      <Chips title={texts.buttons} names={texts.seat_buttons} on={seat.pressed ?? []} />
      <Chips title={texts.lamps} names={texts.seat_lamps} on={seat.lit ?? []} bad={["fault", "locked", "low fuel", "hot"]} />
      <h3 class="seat-title">{texts.seat_display}</h3>
      <dl class="seat-display">
        {texts.seat_rows.map(([name, key, unit]) => {
          const value = seat.display?.[key];
          return <div key={key}><dt>{name}</dt><dd>{value === undefined || value === null ? "––" : `${value} ${unit}`}</dd></div>;
        })}
      </dl>
    </Card>
  );
}

export function ExcavatorWorld(props: PictureProps) {
  const { state } = useLive();
  const now = state.snapshot ?? {};
  const { plant = {}, statistics = {}, movements = {} } = now;
  const picture = (
    <Card class="picture">
      <svg viewBox="0 0 640 420" role="img" aria-label={texts.kinds.excavator}>
        <Machine now={now} />
        <Slew degrees={movements.slew?.place ?? 0} reach={plant.tip_x_m ?? 0} />
      </svg>
      <p class="said" role="status">{now.operator}</p>
      <Legend rows={texts.legends.excavator} />
    </Card>
  );
  const figures = [
    { name: texts.cycles, value: statistics.cycles ?? 0 },
    { name: texts.heaped, value: number_text(statistics.heaped_m3 ?? 0), unit: "m³" },
    { name: texts.spilled, value: number_text(statistics.spilled_m3 ?? 0), unit: "m³" },
  ];
  return <Layout kind="excavator" figures={figures} picture={picture} details={<Seat now={now} />} parts={props} />;
}
