// What is on a bus or in a log, of which no world is known: its nodes, its main values, and its
// traffic.
import { useMemo } from "preact/hooks";
import { go } from "./address";
import { place_of, useLive, type Json, type Value } from "./live";
import { Shares } from "./load";
import { Card, Layout, measure_text, State, time_text, is_old, owner_name, type PictureProps } from "./parts";
import { texts } from "./texts";

const nodes_max = 24;
const values_max = 16;
const first_profile_index = "6000";

const grave = (node: Json) => (node.state === "silent" ? 2 : 0) + (node.error_register && node.error_register !== "00" ? 1 : 0);

function NodeTiles() {
  const { state } = useLive();
  const all: Json[] = state.snapshot?.nodes ?? [];
  const nodes = all.length > nodes_max ? [...all].sort((a, b) => grave(b) - grave(a)).slice(0, nodes_max) : all;
  return (
    <Card title={texts.views.nodes}>
      {all.length === 0 && <p class="hint">{texts.nodes_none}</p>}
      <ul class="tiles">
        {nodes.map((node) => {
          const heard = state.counts?.[node.bus]?.nodes?.[node.node]?.last;
          return (
            <li key={`${node.bus} ${node.node}`} class={grave(node) > 1 ? "bad" : grave(node) > 0 ? "warn" : node.state === "operational" ? "good" : ""}>
              <button type="button" class="tile-name" onClick={() => go({ view: "objects", node: `${node.bus} ${node.node}`, search: "" })}>{node.device}</button>
              <span class="tile-state"><State state={node.state} /></span>
              <span class="muted">{node.bus}{node.error_register !== "00" && <b class="bad-text"> {texts.errors} {node.error_register}h</b>}</span>
              <span class="muted tile-age">{heard === undefined ? texts.never : texts.ago(Math.max(0, state.counted - heard))}</span>
            </li>
          );
        })}
      </ul>
      {nodes.length < all.length && <button type="button" onClick={() => go({ view: "nodes" })}>{texts.nodes_all(all.length)}</button>}
    </Card>
  );
}

/** What changes first, then what has a unit: that is what people know the network by. */
function main_values(values: Map<string, Value>): string[] {
  const rank = (value: Value) => (value.changes > 2 ? 0 : 2) + (value.unit ? 0 : 1);
  return [...values.values()]
    .filter((value) => value.index >= first_profile_index && value.name)
    .sort((a, b) => rank(a) - rank(b) || a.node - b.node || (a.index + a.sub).localeCompare(b.index + b.sub))
    .slice(0, values_max)
    .map(place_of);
}

function MainValues() {
  const { values, state } = useLive();
  // There may be thousands: which are shown is chosen once a second.
  const chosen = useMemo(() => main_values(values), [values, values.size, Math.floor(state.time)]);
  const shown = chosen.map((key) => values.get(key)!);
  return (
    <Card title={texts.main_values}>
      {shown.length === 0 && <p class="hint">{texts.values_none_yet}</p>}
      <dl class="main-values">
        {shown.map((value) => (
          <div key={`${value.bus} ${value.node} ${value.index}:${value.sub}`}>
            <dt>{value.name!.replace(/_/g, "_\u200b")} <span>{owner_name(value)}</span></dt>
            <dd class={is_old(value) ? "old" : ""} title={`${texts.changed_at} ${time_text(value.time, 1)}`}>{measure_text(value)}</dd>
          </div>
        ))}
      </dl>
    </Card>
  );
}

function Services() {
  const { rates } = useLive();
  return <>{Object.entries<Json>(rates).slice(0, 2).map(([bus, rate]) => <Shares key={bus} title={`${bus}: ${texts.load_by_service}`} all={rate} parts={Object.entries<Json>(rate.services)} most={8} />)}</>;
}

export function Overview(props: PictureProps) {
  return <Layout kind="overview" figures={[]} parts={props} picture={<NodeTiles />} details={<><MainValues /><Services /></>} />;
}
