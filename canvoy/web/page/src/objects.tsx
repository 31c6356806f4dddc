// Values of objects: those that were heard on the bus, and all that a node's profile has; to read,
// to write and to pin.
import { useEffect, useState } from "preact/hooks";
import { ask, pin, pins, useLive, type Json, type Value } from "./live";
import { ObjectBranch, ObjectTree } from "./object_tree";
import { Card, device_name, time_text, measure_text } from "./parts";
import { texts } from "./texts";

const shown_max = 400;

function Heard(props: { search: string; bus: string; node: string }) {
  const { values } = useLive();
  const sought = props.search.toLowerCase().replace(/[_-]/g, " ");
  const pinned = new Set(pins());
  const rows = [...values.entries()]
    .filter(([, value]) => (!props.bus || value.bus === props.bus) && (!props.node || String(value.node) === props.node))
    .filter(([, value]) => `${value.index}:${value.sub} ${value.name ?? ""}`.toLowerCase().replace(/[_-]/g, " ").includes(sought))
    .sort(([, a], [, b]) => a.bus.localeCompare(b.bus) || a.node - b.node || (a.index + a.sub).localeCompare(b.index + b.sub));
  if (rows.length === 0) return <p class="hint">{texts.values_none}</p>;
  return (
    <div class="scroll">
      <table class="plain wide">
        <thead>
          <tr><th></th><th>{texts.device}</th><th>{texts.object}</th><th></th><th>{texts.value}</th><th>{texts.raw}</th><th>{texts.changed_at}</th></tr>
        </thead>
        <tbody>
          {rows.slice(0, shown_max).map(([key, value]: [string, Value]) => (
            <tr key={key}>
              <td>
                <button type="button" class="icon" aria-pressed={pinned.has(key) ? "true" : "false"} aria-label={`${pinned.has(key) ? texts.unpin : texts.pin}: ${value.name ?? value.index}`} onClick={() => pin(key)}>
                  {pinned.has(key) ? "★" : "☆"}
                </button>
              </td>
              <td>{value.node === 0 ? value.bus : device_name(value.bus, value.node)}</td>
              <td class="mono">{value.index}:{value.sub}</td>
              <td class="words">{value.name}</td>
              <td class="strong words">{measure_text(value)}</td>
              <td class="mono muted">{value.raw}</td>
              <td class="mono muted">{time_text(value.time, 1)}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

function OfProfile(props: { search: string; bus: string; node: string }) {
  const [found, set] = useState<Json>({});
  const { bus, node, search } = props;
  useEffect(() => {
    if (!bus || !node) return;
    const waits = setTimeout(async () => set(await ask("objects", { bus, node: Number(node), search })), 200);
    return () => clearTimeout(waits);
  }, [search, bus, node]);
  const objects: Json[] = found.objects ?? [];
  return (
    <>
      <p class="muted">{found.profile}</p>
      {found.objects && objects.length === 0 && <p class="hint">{texts.objects_none}</p>}
      <ul class="objects">
        {objects.map((object) => <ObjectBranch key={object.object} bus={bus} node={Number(node)} object={object} is_open={objects.length < 6} />)}
      </ul>
    </>
  );
}

const kinds = { heard: Heard, all_objects: OfProfile, tree: ObjectTree };

export function Objects() {
  const { state } = useLive();
  const [search, set_search] = useState("");
  const [place, set_place] = useState("");
  const [kind, set_kind] = useState<keyof typeof kinds>("heard");
  const whole = kind === "all_objects";
  const View = kinds[kind];
  const nodes: Json[] = state.snapshot?.nodes ?? [];
  const all = place || (whole && nodes[0] ? `${nodes[0].bus} ${nodes[0].node}` : "");
  const [bus, node] = all ? [all.slice(0, all.lastIndexOf(" ")), all.slice(all.lastIndexOf(" ") + 1)] : ["", ""];
  return (
    <Card title={texts.views.objects}>
      <div class="tools">
        <label class="field grow"><span>{texts.search}</span>
          <input type="search" value={search} placeholder={texts.search_example} onInput={(event) => set_search(event.currentTarget.value)} />
        </label>
        <label class="field"><span>{texts.node}</span>
          <select value={all} onChange={(event) => set_place(event.currentTarget.value)}>
            {!whole && <option value="">{texts.all_nodes}</option>}
            {nodes.map((each) => <option key={`${each.bus} ${each.node}`} value={`${each.bus} ${each.node}`}>{each.device} {each.device.includes(each.bus) ? "" : each.bus}</option>)}
          </select>
        </label>
        <div class="switch" role="group" aria-label={texts.views.objects}>
          {(Object.keys(kinds) as (keyof typeof kinds)[]).map((each) => (
            <button type="button" key={each} aria-pressed={kind === each ? "true" : "false"} onClick={() => set_kind(each)}>{texts[each]}</button>
          ))}
        </div>
      </div>
      <View search={search} bus={bus} node={node} />
    </Card>
  );
}
