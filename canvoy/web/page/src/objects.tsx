// Values of objects: those heard on the bus, and all of the profile of a node; to read, to write
// and to pin.
import { useEffect, useState } from "preact/hooks";
import { go, refine, useAddress } from "./address";
import { Heard } from "./heard";
import { ask, useLive, type Json } from "./live";
import { listed_max, ObjectBranch, ObjectTree } from "./object_tree";
import { Card } from "./parts";
import { texts } from "./texts";

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
        {objects.length >= listed_max && <li class="hint">{texts.objects_cut(listed_max)}</li>}
        {objects.map((object) => <ObjectBranch key={object.object} bus={bus} node={Number(node)} object={object} is_open={objects.length < 6} />)}
      </ul>
    </>
  );
}

const kinds = { heard: Heard, all_objects: OfProfile, tree: ObjectTree };

export function Objects() {
  const { state } = useLive();
  const part = useAddress();
  const search = part("search");
  const place = part("node");
  const asked = part("list") as keyof typeof kinds;
  const kind = asked in kinds ? asked : "heard";
  const whole = kind === "all_objects";
  const View = kinds[kind];
  const nodes: Json[] = state.snapshot?.nodes ?? [];
  const all = place || (whole && nodes[0] ? `${nodes[0].bus} ${nodes[0].node}` : "");
  const [bus, node] = all ? [all.slice(0, all.lastIndexOf(" ")), all.slice(all.lastIndexOf(" ") + 1)] : ["", ""];
  return (
    <Card title={texts.views.objects} class="objects-view">
      <div class="tools">
        <label class="field grow"><span>{texts.search}</span>
          <input type="search" value={search} placeholder={texts.search_example} onInput={(event) => refine({ search: event.currentTarget.value })} />
        </label>
        <label class="field"><span>{texts.node}</span>
          <select value={all} onChange={(event) => go({ node: event.currentTarget.value })}>
            {!whole && <option value="">{texts.all_nodes}</option>}
            {nodes.map((each) => <option key={`${each.bus} ${each.node}`} value={`${each.bus} ${each.node}`}>{each.device} {each.device.includes(each.bus) ? "" : each.bus}</option>)}
          </select>
        </label>
        <div class="switch" role="group" aria-label={texts.views.objects}>
          {(Object.keys(kinds) as (keyof typeof kinds)[]).map((each) => (
            <button type="button" key={each} aria-pressed={kind === each ? "true" : "false"} onClick={() => go({ list: each === "heard" ? "" : each })}>{texts[each]}</button>
          ))}
        </div>
      </div>
      <View search={search} bus={bus} node={node} />
    </Card>
  );
}
