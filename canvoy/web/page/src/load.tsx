// Load of the buses: by bus, by node, by service.
import { useMemo } from "preact/hooks";
import { useLive, type Json } from "./live";
import { Bar, Card, device_name, number_text } from "./parts";
import { texts } from "./texts";

function Shares(props: { title: string; parts: [string, Json][]; all: Json }) {
  const rows = props.parts.filter(([, rate]) => rate.frames > 0).sort((a, b) => b[1].bits - a[1].bits).slice(0, 24);
  return (
    <Card title={props.title}>
      <table class="plain">
        <thead><tr><td></td><th class="number">{texts.load_frames}</th><th class="number">%</th><td class="bar-column"></td></tr></thead>
        <tbody>
          {rows.map(([name, rate]) => {
            const share = rate.bits / (props.all.bits || 1);
            return (
              <tr key={name}><td>{name}</td><td class="number">{number_text(rate.frames)}</td><td class="number">{(share * 100).toFixed(1)}</td>
                <td><Bar share={share} label={name} /></td></tr>
            );
          })}
        </tbody>
      </table>
    </Card>
  );
}

export function Load() {
  const { rates, state } = useLive();
  const snapshot: Json[] = state.snapshot?.buses ?? [];
  // Rates change once a second, states twenty times: unchanged parts are not built again.
  return useMemo(() => drawn(rates, snapshot), [rates]);
}

function drawn(rates: Json, snapshot: Json[]) {
  const buses = Object.entries<Json>(rates);
  const load_of = (bus: string) => snapshot.find((each) => each.bus === bus)?.load_percent;
  return (
    <div class="load">
      <Card title={texts.views.load}>
        <table class="plain">
          <thead><tr><th>{texts.load_bus}</th><th class="number">{texts.load_share}</th><th class="number">{texts.load_frames}</th><th class="number">bit/s</th><td class="bar-column"></td></tr></thead>
          <tbody>
            {buses.map(([bus, rate]) => {
              const load = load_of(bus);
              return (
                <tr key={bus}><td>{bus}</td><td class="number">{load === undefined ? "–" : `${load.toFixed(1)} %`}</td>
                  <td class="number">{number_text(rate.frames)}</td><td class="number">{number_text(rate.bits)}</td>
                  <td>{load !== undefined && <Bar warns share={load / 100} label={`${texts.load_share} ${bus}`} />}</td></tr>
              );
            })}
          </tbody>
        </table>
      </Card>
      {buses.map(([bus, rate]) => (
        <div class="pair" key={bus}>
          <Shares title={`${bus}: ${texts.load_by_node}`} all={rate} parts={Object.entries<Json>(rate.nodes).map(([node, each]) => [node === "0" ? texts.load_all_nodes : device_name(bus, Number(node)), each])} />
          <Shares title={`${bus}: ${texts.load_by_service}`} all={rate} parts={Object.entries<Json>(rate.services)} />
        </div>
      ))}
    </div>
  );
}
