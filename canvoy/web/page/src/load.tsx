// Load of the buses: by bus, by node, by service.
import { useMemo } from "preact/hooks";
import { useAddress } from "./address";
import { useLive, type Json } from "./live";
import { Bar, Card, device_name, number_text } from "./parts";
import { SortHead, useSorted } from "./sorted";
import { texts } from "./texts";

const share_columns = { name: ([name]: [string, Json]) => name, frames: ([, rate]: [string, Json]) => rate.frames, share: ([, rate]: [string, Json]) => rate.bits };

/** Parts of the load of a bus, the largest first. */
export function Shares(props: { title: string; parts: [string, Json][]; all: Json; most?: number }) {
  const largest = props.parts.filter(([, rate]) => rate.frames > 0).sort((a, b) => b[1].bits - a[1].bits).slice(0, props.most ?? 24);
  const rows = useSorted(largest, share_columns);
  return (
    <Card title={props.title}>
      <table class="plain">
        <thead><tr><SortHead by="name" title={texts.name_short} /><SortHead by="frames" title={texts.load_frames} class="number" /><SortHead by="share" title="%" class="number" /><td class="bar-column"></td></tr></thead>
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
  const sort = useAddress()("sort");
  const snapshot: Json[] = state.snapshot?.buses ?? [];
  // Rates change once a second, states twenty times: unchanged parts are not built again.
  return useMemo(() => <Drawn rates={rates} snapshot={snapshot} />, [rates, sort]);
}

const bus_columns = { bus: ([bus]: [string, Json]) => bus, frames: ([, rate]: [string, Json]) => rate.frames, bits: ([, rate]: [string, Json]) => rate.bits };

function Drawn(props: { rates: Json; snapshot: Json[] }) {
  const { rates, snapshot } = props;
  const buses = Object.entries<Json>(rates);
  const rows = useSorted(buses, bus_columns);
  const load_of = (bus: string) => snapshot.find((each) => each.bus === bus)?.load_percent;
  return (
    <div class="load">
      <Card title={texts.views.load}>
        <table class="plain">
          <thead><tr><SortHead by="bus" title={texts.load_bus} /><th class="number">{texts.load_share}</th><SortHead by="frames" title={texts.load_frames} class="number" /><SortHead by="bits" title="bit/s" class="number" /><td class="bar-column"></td></tr></thead>
          <tbody>
            {rows.map(([bus, rate]) => {
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
