// All objects as a tree: network, node, object, sub-index. The content of a branch is requested
// when it is opened.
import { useEffect, useState } from "preact/hooks";
import { ask, live, pin, pins, place_of, useLive, type Json } from "./live";
import { measure_text } from "./parts";
import { texts } from "./texts";
import { Writer } from "./writer";

// Maximum number that the server lists.
export const listed_max = 300;

interface Place {
  bus: string;
  node: number;
}

/** The last heard value of an entry, and whether it is pinned. */
function Latest(props: Place & { object: string; sub: string; name: string }) {
  const key = place_of({ ...props, index: props.object });
  const value = live.values.get(key);
  if (!value) return null;
  const is_pinned = pins().includes(key);
  return (
    <span class="latest">
      <b>{measure_text(value)}</b>
      <button type="button" class="icon" aria-pressed={is_pinned ? "true" : "false"} aria-label={`${is_pinned ? texts.unpin : texts.pin}: ${props.name}`} onClick={() => pin(key)}>
        {is_pinned ? "★" : "☆"}
      </button>
    </span>
  );
}

export function ObjectBranch(props: Place & { object: Json; is_open: boolean }) {
  const { bus, node, object } = props;
  // Hundreds of them are listed, and few are opened.
  const [was_open, open] = useState(props.is_open);
  return (
    <li>
      <details open={props.is_open} onToggle={(event) => open(was_open || event.currentTarget.open)}>
        <summary>
          <span class="mono">{object.object}h</span> {object.name}
          <span class="muted"> {object.profile}{object.clause && `, ${object.clause}`}</span>
        </summary>
        <ul>
          {(was_open || props.is_open) && object.entries.map((entry: Json) => (
            <li key={entry.sub}>
              <span class="mono">:{entry.sub}</span> {entry.name} <span class="muted">{entry.type} {entry.access} {entry.unit}</span>
              <Latest bus={bus} node={node} object={object.object} sub={entry.sub} name={entry.name} />
              <Writer bus={bus} node={node} object={`${object.object}:${entry.sub}`} entry={entry} />
            </li>
          ))}
        </ul>
      </details>
    </li>
  );
}

/** Objects in groups by the purpose of their index range (CiA 301, 7.4.1). */
function group_of(object: string): string {
  const index = parseInt(object, 16);
  return texts.groups.find(([last]) => index <= last)?.[1] ?? "";
}

function NodeBranch(props: Place & { name: string; search: string }) {
  const { bus, node, search } = props;
  const [is_open, open] = useState(false);
  const [found, set] = useState<Json | null>(null);
  useEffect(() => {
    if (!is_open) return;
    const waits = setTimeout(async () => set(await ask("objects", { bus, node, search })), found ? 200 : 0);
    return () => clearTimeout(waits);
  }, [is_open, search, bus, node]);
  const objects: Json[] = found?.objects ?? [];
  const groups = [...new Set(objects.map((each) => group_of(each.object)))];
  return (
    <li>
      <details onToggle={(event) => { if (event.target === event.currentTarget) open(event.currentTarget.open); }}>
        <summary>{props.name} <span class="muted">{found?.profile}</span></summary>
        {found?.error && <p class="error">{found.error}</p>}
        {found && objects.length === 0 && <p class="hint">{texts.objects_none}</p>}
        {objects.length >= listed_max && <p class="hint">{texts.objects_cut(listed_max)}</p>}
        <ul>
          {groups.map((group) => (
            <li key={group}>
              <details open={objects.length < 12}>
                <summary class="muted">{group}</summary>
                <ul>
                  {objects.filter((each) => group_of(each.object) === group).map((object) => (
                    <ObjectBranch key={object.object} bus={bus} node={node} object={object} is_open={objects.length < 4} />
                  ))}
                </ul>
              </details>
            </li>
          ))}
        </ul>
      </details>
    </li>
  );
}

export function ObjectTree(props: { search: string; bus: string; node: string }) {
  const { state, hello } = useLive();
  const nodes: Json[] = state.snapshot?.nodes ?? [];
  const buses: string[] = (hello.buses ?? []).filter((bus: string) => !props.bus || bus === props.bus);
  const of = (bus: string) => nodes.filter((each) => each.bus === bus && (!props.node || String(each.node) === props.node));
  return (
    <ul class="objects tree" aria-label={texts.tree}>
      {buses.map((bus) => (
        <li key={bus}>
          <details open>
            <summary><b>{bus}</b> <span class="muted">{texts.nodes_count(of(bus).length)}</span></summary>
            <ul>{of(bus).map((each) => <NodeBranch key={each.node} bus={bus} node={each.node} name={each.device} search={props.search} />)}</ul>
          </details>
        </li>
      ))}
    </ul>
  );
}
