// A battery on its charger: state of charge, current, and what both report.
import { useLive } from "./live";
import { Card, Figure, Legend, number_text, type PictureProps } from "./parts";
import { texts } from "./texts";

export function ChargerWorld(props: PictureProps) {
  const { state } = useLive();
  const now = state.snapshot ?? {};
  const plant = now.plant ?? {};
  const soc = plant.state_of_charge_percent ?? now.state_of_charge_percent ?? 0;
  const amps = plant.current_a ?? now.current_a ?? 0;
  const flows = Math.abs(amps) > 0.05;
  const width = 150 * Math.max(0, Math.min(1, soc / 100));
  return (
    <div class="world charger">
      <div class="left">
      <Card class="picture">
        <svg viewBox="0 0 640 300" role="img" aria-label={`${texts.kinds.charger}: ${number_text(soc)} %`}>
          <g class="device">
            <rect x="40" y="70" width="170" height="160" rx="14" />
            <text class="device-name" x="125" y="62" text-anchor="middle">{texts.charger}</text>
            <path class={`bolt ${flows ? "on" : ""}`} d="M132 92l-34 48h24l-8 36 36-50h-25z" />
            <text x="125" y="212" text-anchor="middle" class="big">{number_text(now.current_a ?? 0)} A</text>
          </g>
          <g class="cable">
            <path d="M210 120h210" />
            <path d="M210 180h210" />
            {flows && <path class="flow" d="M210 120h210" style={{ animationDuration: `${Math.max(0.25, 30 / Math.abs(amps))}s` }} />}
            {flows && <path class="flow back" d="M420 180h-210" style={{ animationDuration: `${Math.max(0.25, 30 / Math.abs(amps))}s` }} />}
            <text x="315" y="155" text-anchor="middle">{number_text(plant.voltage_v ?? now.voltage_v ?? 0)} V</text>
          </g>
          <g class="device">
            <rect x="420" y="70" width="180" height="160" rx="14" />
            <rect x="600" y="120" width="10" height="60" rx="4" class="pole" />
            <text class="device-name" x="510" y="62" text-anchor="middle">{texts.battery}</text>
            <rect class="cell" x="435" y="90" width="150" height="70" rx="6" />
            <rect class={`charge ${soc < 20 ? "low" : ""}`} x="435" y="90" width={width} height="70" rx="6" />
            <text x="510" y="134" text-anchor="middle" class="big on-charge">{number_text(soc)} %</text>
            <text x="510" y="190" text-anchor="middle">{number_text(plant.temperature_celsius ?? now.temperature_celsius ?? 0)} °C</text>
            <text x="510" y="214" text-anchor="middle">{number_text(plant.charge_ah ?? now.charge_ah ?? 0)} Ah</text>
          </g>
        </svg>
        <Legend rows={texts.legends.charger} />
        <p class="said" role="status">{now.reason}</p>
      </Card>
      {props.below}
      </div>
      <div class="side">
        <Card class="figures">
          <Figure name={texts.requested} value={number_text(now.requested_current_a ?? 0)} unit="A" />
          <Figure name={texts.delivered} value={number_text(now.charge_ah ?? 0)} unit="Ah" />
          <Figure name={texts.energy} value={number_text((now.energy_wh ?? 0) / 1000)} unit="kWh" />
        </Card>
        {props.children}
        <Card title={texts.said_and_true}>
          <table class="plain">
            <thead><tr><td></td><th class="number">{texts.says}</th><th class="number">{texts.truth}</th></tr></thead>
            <tbody>
              {texts.charger_rows.map(([name, key, unit]) => (
                <tr key={key}>
                  <td>{name}</td>
                  <td class="number">{now[key] === undefined || now[key] === null ? "–" : `${number_text(now[key])} ${unit}`}</td>
                  <td class="number">{plant[key] === undefined || plant[key] === null ? "–" : `${number_text(plant[key])} ${unit}`}</td>
                </tr>
              ))}
            </tbody>
          </table>
        </Card>
      </div>
    </div>
  );
}
