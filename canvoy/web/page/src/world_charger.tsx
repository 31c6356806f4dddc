// A battery on its charger: state of charge, current, and what both report.
import { useLive } from "./live";
import { Card, Layout, Legend, number_text, type PictureProps } from "./parts";
import { texts } from "./texts";

const cell = 168;  // width of the battery's charge when it is full

export function ChargerWorld(props: PictureProps) {
  const { state } = useLive();
  const now = state.snapshot ?? {};
  const plant = now.plant ?? {};
  const soc = plant.state_of_charge_percent ?? now.state_of_charge_percent ?? 0;
  const amps = plant.current_a ?? now.current_a ?? 0;
  const flows = Math.abs(amps) > 0.05;
  const seconds = `${Math.max(0.25, 30 / Math.abs(amps))}s`;
  const picture = (
    <Card class="picture">
      <svg viewBox="0 0 640 214" role="img" aria-label={`${texts.kinds.charger}: ${number_text(soc)} %`}>
        <g class="device">
          <text class="device-name" x="105" y="18" text-anchor="middle">{texts.charger}</text>
          <rect x="10" y="28" width="190" height="176" rx="14" />
          <path class={`bolt ${flows ? "on" : ""}`} d="M114 44l-40 56h28l-9 42 42-58h-29z" />
          <text x="105" y="188" text-anchor="middle" class="big">{number_text(now.current_a ?? 0)} A</text>
        </g>
        <g class="cable">
          <path d="M200 82h216" />
          <path d="M200 150h216" />
          {flows && <path class="flow" d="M200 82h216" style={{ animationDuration: seconds }} />}
          {flows && <path class="flow back" d="M416 150h-216" style={{ animationDuration: seconds }} />}
          <text x="308" y="124" text-anchor="middle" class="big">{number_text(plant.voltage_v ?? now.voltage_v ?? 0)} V</text>
        </g>
        <g class="device">
          <text class="device-name" x="516" y="18" text-anchor="middle">{texts.battery}</text>
          <rect x="416" y="28" width="200" height="176" rx="14" />
          <rect x="616" y="86" width="12" height="60" rx="4" class="pole" />
          <rect class="cell" x="432" y="44" width={cell} height="92" rx="8" />
          <rect class={`charge ${soc < 20 ? "low" : ""}`} x="432" y="44" width={(cell * Math.max(0, Math.min(100, soc))) / 100} height="92" rx="8" />
          <text x="516" y="100" text-anchor="middle" class="huge on-charge">{number_text(Math.round(soc * 10) / 10)} %</text>
          <text x="516" y="160" text-anchor="middle">{number_text(plant.charge_ah ?? now.charge_ah ?? 0)} Ah</text>
          <text x="516" y="188" text-anchor="middle">{number_text(plant.temperature_celsius ?? now.temperature_celsius ?? 0)} °C</text>
        </g>
      </svg>
      <p class="said" role="status">{now.reason}</p>
      <Legend rows={texts.legends.charger} />
    </Card>
  );
  const figures = [
    { name: texts.requested, value: number_text(now.requested_current_a ?? 0), unit: "A" },
    { name: texts.delivered, value: number_text(now.charge_ah ?? 0), unit: "Ah" },
    { name: texts.energy, value: number_text((now.energy_wh ?? 0) / 1000), unit: "kWh" },
  ];
  const details = (
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
  );
  return <Layout kind="charger" figures={figures} picture={picture} details={details} parts={props} />;
}
