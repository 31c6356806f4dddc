// A charging yard: what each bay delivers, and how full each battery is, against the goal.
import { useLive } from "./live";
import { Card, Layout, Legend, number_text, time_text, type PictureProps } from "./parts";
import { SortHead, useSorted } from "./sorted";
import { texts } from "./texts";

/** A row of the picture: a battery, and the cable to its bay. */
const row_height = 46;
const bar = { x: 330, width: 250 };

function Battery(props: { it: any; bay: any; goal?: number; y: number }) {
  const { it, bay, goal, y } = props;
  const soc = it.state_of_charge_percent ?? 0;
  const is_plugged = it.place === "plugged in";
  const amps = is_plugged ? (bay?.plant?.current_a ?? 0) : 0;
  const flows = Math.abs(amps) > 0.05;
  const missed = goal !== undefined && it.at_goal_percent !== undefined && it.at_goal_percent < goal;
  return (
    <g class="yard-row" transform={`translate(0 ${y})`}>
      <text x="16" y="27">{`${texts.battery} ${it.vehicle}`}</text>
      <text x="134" y="27" class="muted">{it.place === "away" ? texts.yard_away : `${texts.bay} ${it.bay}`}</text>
      {is_plugged && <path class="yard-cable" d={`M200 22h${bar.x - 200}`} />}
      {flows && <path class="flow" d={`M200 22h${bar.x - 200}`} style={{ animationDuration: `${Math.max(0.25, 30 / Math.abs(amps))}s` }} />}
      {is_plugged && <text x="265" y="14" text-anchor="middle">{number_text(amps)} A</text>}
      <rect class="cell" x={bar.x} y="6" width={bar.width} height="32" rx="6" />
      <rect class={`charge ${soc < 20 || missed ? "low" : ""}`} x={bar.x} y="6" width={(bar.width * Math.max(0, Math.min(100, soc))) / 100} height="32" rx="6" />
      {goal !== undefined && <path class="yard-goal" d={`M${bar.x + (bar.width * goal) / 100} 2v40`} />}
      <text x={bar.x + bar.width / 2} y="28" text-anchor="middle" class="on-charge">{number_text(Math.round(soc * 10) / 10)} %</text>
    </g>
  );
}

export function YardWorld(props: PictureProps) {
  const { state } = useLive();
  const now: any = state.snapshot ?? {};
  const bays: any[] = now.bays ?? [];
  const vehicles: any[] = now.vehicles ?? [];
  const goal: number | undefined = now.goal?.state_of_charge_percent;
  const height = Math.max(1, vehicles.length) * row_height + 8;
  const rows = useSorted<any>(bays, {
    bay: (bay) => bay.bay, charger: (bay) => bay.reason ?? "", current: (bay) => bay.plant?.current_a ?? 0, voltage: (bay) => bay.plant?.voltage_v ?? 0, mains: (bay) => bay.mains_wh ?? 0,
  });
  const picture = (
    <Card class="picture">
      <svg viewBox={`0 0 600 ${height}`} role="img" aria-label={texts.kinds["charging-yard"]}>
        {vehicles.map((it, i) => (
          <Battery key={it.vehicle} it={it} bay={bays[it.bay - 1]} goal={goal} y={i * row_height + 4} />
        ))}
      </svg>
      <Legend rows={texts.legends.yard} />
    </Card>
  );
  const figures = [
    { name: texts.from_mains, value: number_text((now.mains_wh ?? 0) / 1000), unit: "kWh" },
    { name: texts.mains_at_most, value: number_text((now.mains_w_max ?? 0) / 1000), unit: "kW" },
    ...(now.goal ? [{ name: `${texts.goal} ${texts.at_time} ${time_text(now.goal.at, 0)}`, value: number_text(goal ?? 0), unit: "%" }] : []),
  ];
  const details = (
    <Card title={texts.bays}>
      <table class="plain">
        <thead><tr>{texts.bay_columns.map(([by, name], i) => <SortHead key={by} by={by} title={name} class={i > 1 ? "number" : ""} />)}</tr></thead>
        <tbody>
          {rows.map((bay) => (
            <tr key={bay.bay}>
              <td>{bay.bay}</td>
              <td>{bay.reason}</td>
              <td class="number">{number_text(bay.plant?.current_a ?? 0)} A</td>
              <td class="number">{number_text(bay.plant?.voltage_v ?? 0)} V</td>
              <td class="number">{number_text((bay.mains_wh ?? 0) / 1000)} kWh</td>
            </tr>
          ))}
        </tbody>
      </table>
    </Card>
  );
  return <Layout kind="charger yard" figures={figures} picture={picture} details={details} parts={props} />;
}
